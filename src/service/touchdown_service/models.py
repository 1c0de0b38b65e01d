"""Ship classes, ships and bodies of the physics service. SI units, radians, quaternions (x, y, z, w)."""

from collections.abc import Callable
from dataclasses import dataclass, field
from math import inf, sqrt

from .config import Config
from .vectors import Mat3, Quat, Vec3

GRAVITATIONAL_CONSTANT = 6.6743e-11
STANDARD_GRAVITY = 9.80665

FLYING = ""
CONTACT = "contact"
LANDED = "landed"
TIPPED = "tipped"
SURFACE_CONTACT_STATES = (FLYING, CONTACT, LANDED, TIPPED)

ATTITUDE_MODES = (
    "none",
    "hold",
    "prograde",
    "retrograde",
    "surface_retrograde",
    "normal",
    "antinormal",
    "radial",
    "antiradial",
)

# terrain_height(body_name, nx, ny, nz): metres above the body's radius, the direction in the body's axes.
TerrainHeight = Callable[[str, float, float, float], float]


@dataclass(slots=True)
class ShipClass:
    """A class as the game names it (checked by loading.load_ship_class), and what is computed of it once."""

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
    # Without one inertia goes with mass.
    dry_inertia_ratio: float | None = None
    # N m s; without one the wheels are never full.
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
    # The inertia tensor's factor: inertia_at_dry + inertia_per_fuel * fuel.
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
        self.full_torque = tuple(
            wheel + rcs for wheel, rcs in zip(self.reaction_wheel_torque, self.rcs_torque)
        )
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


# A body over one substep: its axes at the start and at the end, and the rotation of ground-bound ships between them.
BodyStep = tuple[Mat3, Mat3, Quat]


@dataclass(slots=True)
class Body:
    """A celestial body: it moves by its velocity once a tick and turns by its angular velocity once a substep."""

    name: str
    mass: float
    radius: float
    position: Vec3
    velocity: Vec3
    attitude: Quat
    angular_velocity: Vec3
    mu: float = field(init=False)

    def __post_init__(self) -> None:
        self.mu = GRAVITATIONAL_CONSTANT * self.mass


@dataclass(frozen=True, slots=True)
class Controls:
    """What the pilot commands, as the server takes it: clamped, the target normalized."""

    thrust_level: float = 0.0
    translation_input: Vec3 = (0.0, 0.0, 0.0)
    rotation_input: Vec3 = (0.0, 0.0, 0.0)
    attitude_hold: bool = False
    attitude_mode: str = "none"
    target_attitude: Quat = (0.0, 0.0, 0.0, 1.0)
    # Engine or translation thrusters; stick or attitude control; either: most ships coast.
    pushes: bool = field(init=False, compare=False)
    steers: bool = field(init=False, compare=False)
    is_active: bool = field(init=False, compare=False)

    def __post_init__(self) -> None:
        pushes = self.thrust_level != 0 or any(self.translation_input)
        steers = any(self.rotation_input) or self.attitude_mode != "none" or self.attitude_hold
        object.__setattr__(self, "pushes", pushes)
        object.__setattr__(self, "steers", steers)
        object.__setattr__(self, "is_active", pushes or steers)


NEUTRAL = Controls()


@dataclass(slots=True)
class Input:
    """A change of controls that holds from the start of a substep on; session and seq say whose it is."""

    tick: int
    substep: int
    change: dict[str, object]
    session: str = ""
    seq: int = 0
    # Wall seconds, by Redis's clock; later by as much as its stamp was late.
    arrived: float = 0.0


@dataclass(slots=True)
class Applied:
    """The last input that a ship was given."""

    session: str
    seq: int
    tick: int
    substep: int
    # Wall seconds before its interval was simulated; negative: late.
    margin: float


@dataclass(slots=True)
class Ship:
    """A simulated ship. Position and velocity are relative to the reference body's centre, in ICRF axes."""

    ship_class: ShipClass
    body: Body
    position: Vec3
    velocity: Vec3
    attitude: Quat
    angular_velocity: Vec3
    fuel: float
    # h: of the centre of mass above the feet, m; the class's, unless the ship's state carries its own.
    ground_contact_offset: float = 0.0
    # What the wheels have given so far, N m s, body axes.
    wheel_momentum: Vec3 = (0.0, 0.0, 0.0)
    impact_speed: float = 0.0
    surface_contact_state: str = FLYING
    crashed: bool = False
    controls: Controls = NEUTRAL
    ship_id: str = ""
    player_id: str = ""
    name: str = ""
    # A touch now would not be the initial one: it follows a bounce (REDIS.md, Initial touch).
    touched: bool = False
    # The ground at the last substep's end, which is the next one's start (contact.Standing).
    standing: tuple | None = field(default=None, repr=False, compare=False)
    # In the order they are due.
    pending: list[Input] = field(default_factory=list)
    applied: Applied | None = None

    @property
    def landed_body_name(self) -> str:
        return "" if self.surface_contact_state == FLYING else self.body.name


@dataclass(slots=True)
class World:
    """What a substep reads."""

    config: Config
    bodies: list[Body]
    terrain_height: TerrainHeight


@dataclass(slots=True)
class Event:
    """What happened to a ship in a substep of the interval that begins at `tick`."""

    tick: int
    substep: int
    type: str
    ship: Ship
    body: str
    # Of a touch: it follows a bounce, and its speed, m/s.
    again: bool = False
    impact_speed: float = 0.0


@dataclass(slots=True)
class Change:
    """The controls that a ship flew by from a substep of the interval that begins at `tick` on."""

    tick: int
    substep: int
    ship: Ship
    controls: Controls


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
