"""Contact settings and tick timing of the physics service."""

from dataclasses import dataclass, field, fields
from math import ceil

RADIANS_PER_DEGREE = 3.141592653589793 / 180


@dataclass(frozen=True, slots=True)
class Config:
    """The design's settings (DYNAMICS, Settings): m/s, rad/s, degrees where the name says so."""

    contact_crash_speed: float = 50.0
    contact_bounce_speed: float = 10.0
    contact_settle_tilt_deg: float = 5.0
    contact_settle_angular_vel: float = 0.01
    contact_settle_linear_vel: float = 0.5
    contact_tipped_angle_deg: float = 80.0
    contact_damping_ratio: float = 0.3
    contact_friction_static: float = 0.8
    contact_friction_kinetic: float = 0.5
    touchdown_attitude: str = "aligned"
    cos_settle_tilt: float = field(init=False)
    cos_tipped_angle: float = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "cos_settle_tilt", cosine_of_degrees(self.contact_settle_tilt_deg))
        object.__setattr__(self, "cos_tipped_angle", cosine_of_degrees(self.contact_tipped_angle_deg))


def load_config(overrides: dict[str, float | str]) -> Config:
    """Defaults where nothing is said. Raises ValueError for a name that is no setting."""
    known = {f.name for f in fields(Config) if f.init}
    unknown = sorted(set(overrides) - known)
    if unknown:
        raise ValueError(f"{unknown[0]}: no such setting")
    return Config(**overrides)


@dataclass(frozen=True, slots=True)
class Timing:
    """How a tick is cut (DYNAMICS, Time): game seconds a tick, substeps a tick, game seconds a substep."""

    tick_seconds: float
    substeps: int
    dt: float


def load_timing(tick_rate: float, time_scale: float) -> Timing:
    """tick_rate 0.1 to 100 Hz, time_scale 0.1 to 100."""
    return timing_of_tick(time_scale / tick_rate)


def timing_of_tick(tick_seconds: float) -> Timing:
    substeps = max(1, ceil(tick_seconds * 100 - 1e-9))
    return Timing(tick_seconds, substeps, tick_seconds / substeps)


def cosine_of_degrees(degrees: float) -> float:
    """0 to 90 degrees, by a polynomial of our own: math.cos has other bits in other languages (ORDER, Cosine)."""
    if degrees <= 45:
        x = degrees * RADIANS_PER_DEGREE
        s = x * x
        total = 0.0
        for k in range(9, 0, -1):
            total = ((1 - total) * s) / ((2 * k - 1) * (2 * k))
        return 1 - total
    x = (90 - degrees) * RADIANS_PER_DEGREE
    s = x * x
    total = 0.0
    for k in range(9, 0, -1):
        total = ((1 - total) * s) / (2 * k * (2 * k + 1))
    return x * (1 - total)
