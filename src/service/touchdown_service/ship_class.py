"""Ship classes under the game's names, and constants derived from them. SI units, body axes: +Z is the thrust axis and "up"."""

from dataclasses import dataclass, field
from math import inf, sqrt

from .law.vectors import Mat3, Vec3

STANDARD_GRAVITY = 9.80665


@dataclass(slots=True)
class ShipClass:
    """A class under the game's names (checked by loading.load_ship_class), with derived constants."""

    name: str
    dry_mass: float
    fuel_capacity: float
    inertia_tensor: list[list[float]]
    ground_contact_offset: float
    leg_radius: float
    main_engine_thrust: float
    main_engine_isp: float
    rcs_thrust: Vec3
    rcs_torque: Vec3
    rcs_lever: float
    rcs_isp: float
    reaction_wheel_torque: Vec3
    attitude_natural_frequency: float
    # None: inertia is proportional to mass.
    dry_inertia_ratio: float | None = None
    # N m s; None: the wheels never saturate.
    reaction_wheel_capacity: Vec3 | None = None
    full_mass: float = field(init=False)
    inertia: Mat3 = field(init=False)
    inverse_inertia: Mat3 = field(init=False)
    main_flow: float = field(init=False)
    rcs_flow: float = field(init=False)
    force_per_torque: float = field(init=False)
    full_torque: Vec3 = field(init=False)
    wheel_capacity: Vec3 = field(init=False)
    attitude_stiffness: float = field(init=False)
    attitude_damping: float = field(init=False)
    # Factor on the inertia tensor: inertia_at_dry + inertia_per_fuel * fuel.
    inertia_at_dry: float = field(init=False)
    inertia_per_fuel: float = field(init=False)
    # J and J' of DYNAMICS, Angular, kg m^2 with full tanks.
    support_inertia: float = field(init=False)
    scrub_inertia: float = field(init=False)

    def __post_init__(self) -> None:
        self.full_mass = self.dry_mass + self.fuel_capacity
        self.inertia = tuple(moment for row in self.inertia_tensor for moment in row)
        self.inverse_inertia = inverse(self.inertia)
        turns_by_rcs = max(self.rcs_torque) > 0
        burns_rcs = turns_by_rcs or max(self.rcs_thrust) > 0
        self.main_flow = 1 / (self.main_engine_isp * STANDARD_GRAVITY) if self.main_engine_thrust > 0 else 0.0
        self.rcs_flow = 1 / (self.rcs_isp * STANDARD_GRAVITY) if burns_rcs else 0.0
        self.force_per_torque = 1 / self.rcs_lever if turns_by_rcs else 0.0
        self.full_torque = tuple(wheel + rcs for wheel, rcs in zip(self.reaction_wheel_torque, self.rcs_torque))
        self.wheel_capacity = self.reaction_wheel_capacity or (inf, inf, inf)
        self.attitude_stiffness = self.attitude_natural_frequency * self.attitude_natural_frequency
        self.attitude_damping = 2 * self.attitude_natural_frequency
        if self.dry_inertia_ratio is None or self.fuel_capacity == 0:
            self.inertia_at_dry = self.dry_mass / self.full_mass
            self.inertia_per_fuel = 1 / self.full_mass
        else:
            self.inertia_at_dry = self.dry_inertia_ratio
            self.inertia_per_fuel = (1 - self.dry_inertia_ratio) / self.fuel_capacity
        self.support_inertia, self.scrub_inertia = scalar_inertias(self.inverse_inertia)


def inverse(m: Mat3) -> Mat3:
    """Adjugate over determinant."""
    a, b, c, d, e, f, g, h, i = m
    ca = e * i - f * h
    cb = f * g - d * i
    cc = d * h - e * g
    determinant = a * ca + b * cb + c * cc
    return (
        ca / determinant,
        (c * h - b * i) / determinant,
        (b * f - c * e) / determinant,
        cb / determinant,
        (a * i - c * g) / determinant,
        (c * d - a * f) / determinant,
        cc / determinant,
        (b * g - a * h) / determinant,
        (a * e - b * d) / determinant,
    )


def scalar_inertias(k: Mat3) -> tuple[float, float]:
    """J, the least moment against tilting, and J', a bound below the least moment of inertia; `k` the inverse tensor."""
    rows = [abs(k[i]) + abs(k[i + 1]) + abs(k[i + 2]) for i in (0, 3, 6)]
    scrub = 1 / max(rows)
    half = (k[0] - k[4]) / 2
    tilting = 1 / ((k[0] + k[4]) / 2 + sqrt(half * half + k[1] * k[1]))
    return min(tilting, 4 * scrub), scrub
