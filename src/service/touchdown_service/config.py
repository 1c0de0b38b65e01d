"""Contact settings and tick timing of the physics service."""

from dataclasses import dataclass, field, fields
from math import ceil
from typing import Any

from .validation.limits import ANY, Range, Refusal, known_fields, mapping, number, one_of

RADIANS_PER_DEGREE = 3.141592653589793 / 180


@dataclass(frozen=True, slots=True)
class Config:
    """The design's settings (DYNAMICS, Settings): m/s, rad/s, degrees where the name ends in deg."""

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
    surface_normal: str = "radial"
    contact_longest_substep: float = 0.01
    is_terrain_normal: bool = field(init=False)
    settle_squared: float = field(init=False)
    cos_settle_tilt: float = field(init=False)
    cos_tipped_angle: float = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "is_terrain_normal", self.surface_normal == "terrain")
        settle = self.contact_settle_linear_vel
        object.__setattr__(self, "settle_squared", settle * settle)
        object.__setattr__(self, "cos_settle_tilt", cosine_of_degrees(self.contact_settle_tilt_deg))
        object.__setattr__(self, "cos_tipped_angle", cosine_of_degrees(self.contact_tipped_angle_deg))


def load_config(given: Any, path: str = "settings") -> Config:
    """Absent settings get their defaults. Raises Refusal with the name of the invalid setting."""
    mapping(given, path)
    known_fields(given, frozenset(f.name for f in fields(Config) if f.init), path)
    values = {f.name: f.default for f in fields(Config) if f.init} | given
    settings: dict[str, Any] = {
        name: value if name in NAMED else number(value, f"{path}.{name}", RANGES.get(name, ANY))
        for name, value in values.items()
    }
    for name, names in NAMED.items():
        settings[name] = one_of(values[name], f"{path}.{name}", names)
    check_order(settings, path)
    return Config(**settings)


NAMED = {"touchdown_attitude": ("aligned", "kept"), "surface_normal": ("radial", "terrain")}
POSITIVE_SPEED = Range(0, 1e9, "m/s", is_open=True)
RANGES = {
    "contact_crash_speed": POSITIVE_SPEED,
    "contact_bounce_speed": POSITIVE_SPEED,
    "contact_settle_linear_vel": POSITIVE_SPEED,
    "contact_settle_angular_vel": Range(0, 1e6, "rad/s", is_open=True),
    "contact_settle_tilt_deg": Range(0, 90, "degrees", is_open=True),
    "contact_tipped_angle_deg": Range(0, 90, "degrees", is_open=True),
    "contact_damping_ratio": Range(0, 1, "", is_open=True),
    "contact_friction_static": Range(0, 2, ""),
    "contact_friction_kinetic": Range(0, 2, ""),
    # With longer substeps, ships with very unequal moments of inertia oscillate on their legs.
    "contact_longest_substep": Range(0.001, 0.022, "s"),
}


def check_order(settings: dict[str, Any], path: str) -> None:
    """Checks limits that depend on each other."""
    below = (
        ("contact_bounce_speed", "<", "contact_crash_speed"),
        ("contact_settle_tilt_deg", "<", "contact_tipped_angle_deg"),
        ("contact_friction_kinetic", "<=", "contact_friction_static"),
    )
    for name, sign, other in below:
        value, most = settings[name], settings[other]
        if not (value < most or (sign == "<=" and value == most)):
            raise Refusal(f"{path}.{name}: expected {sign} {other} ({most:g}), got {value:g}")
    if not settings["contact_tipped_angle_deg"] < 90:
        raise Refusal(f"{path}.contact_tipped_angle_deg: expected < 90 degrees")


@dataclass(frozen=True, slots=True)
class Timing:
    """Division of a tick (DYNAMICS, Time): game seconds per tick, substeps per tick, game seconds per substep."""

    tick_seconds: float
    substeps: int
    dt: float


TICK_RATE = Range(0.1, 100, "Hz")
TIME_SCALE = Range(0.1, 100, "")


def load_timing(tick_rate: Any, time_scale: Any, longest_substep: float) -> Timing:
    """tick_rate 0.1 to 100 Hz, time_scale 0.1 to 100; substeps of at most `longest_substep` seconds."""
    scale = number(time_scale, "time_scale", TIME_SCALE)
    return timing_of_tick(scale / number(tick_rate, "tick_rate", TICK_RATE), longest_substep)


def timing_of_tick(tick_seconds: float, longest_substep: float) -> Timing:
    substeps = max(1, ceil(tick_seconds / longest_substep - 1e-9))
    return Timing(tick_seconds, substeps, tick_seconds / substeps)


def cosine_of_degrees(degrees: float) -> float:
    """Cosine of 0 to 90 degrees by a polynomial, since the bits of math.cos differ between languages (ORDER, Cosine)."""
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
