"""Ships, bodies and events. SI units, radians, quaternions (x, y, z, w)."""

from collections.abc import Callable
from dataclasses import dataclass, field
from math import inf

from .config import Config
from .law.vectors import Mat3, Quat, Vec3
from .ship_class import ShipClass

GRAVITATIONAL_CONSTANT = 6.6743e-11

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

# terrain_height(body_name, nx, ny, nz): height above the body's radius, m; unit direction in body axes.
TerrainHeight = Callable[[str, float, float, float], float]


# A body over one substep: its axes at the start and at the end, and the rotation of ground-bound ships between them.
BodyStep = tuple[Mat3, Mat3, Quat]


@dataclass(slots=True)
class Body:
    """A celestial body: moves by its velocity once per tick, rotates by its angular velocity once per substep."""

    name: str
    mass: float
    radius: float
    position: Vec3
    velocity: Vec3
    attitude: Quat
    angular_velocity: Vec3
    # Distance from the centre within which all of the ground lies, m; further out no terrain is looked up.
    highest_ground: float = inf
    mu: float = field(init=False)

    def __post_init__(self) -> None:
        self.mu = GRAVITATIONAL_CONSTANT * self.mass


@dataclass(frozen=True, slots=True)
class Controls:
    """A pilot's controls, clamped, with the target normalized."""

    thrust_level: float = 0.0
    translation_input: Vec3 = (0.0, 0.0, 0.0)
    rotation_input: Vec3 = (0.0, 0.0, 0.0)
    attitude_hold: bool = False
    attitude_mode: str = "none"
    target_attitude: Quat = (0.0, 0.0, 0.0, 1.0)
    # Whether engine or translation thrusters, stick or attitude control, or any of them is in use; most ships coast.
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
    """A change of controls from the start of a substep on, identified by session and sequence number."""

    tick: int
    substep: int
    change: dict[str, object]
    session: str = ""
    seq: int = 0
    # Wall s by Redis's clock, plus the amount by which its stamp was late.
    arrived: float = 0.0


@dataclass(slots=True)
class Applied:
    """The last input applied to a ship."""

    session: str
    seq: int
    tick: int
    substep: int
    # Time from arrival to the simulation of its interval, wall s; negative: late.
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
    # h: height of the centre of mass above the feet, m; the class's unless the ship's state has its own.
    ground_contact_offset: float = 0.0
    # Momentum stored in the reaction wheels, N m s, body axes.
    wheel_momentum: Vec3 = (0.0, 0.0, 0.0)
    impact_speed: float = 0.0
    surface_contact_state: str = FLYING
    crashed: bool = False
    controls: Controls = NEUTRAL
    ship_id: str = ""
    player_id: str = ""
    name: str = ""
    # The next touch is not the initial one but follows a bounce (REDIS.md, Initial touch).
    touched: bool = False
    # Quantities at the last substep's end, with which the next one starts: the position that they are valid for, and the
    # place; for a grounded ship also the velocity and the body's axes that they are valid for, the ground, and the
    # velocity over it.
    ended: tuple | None = field(default=None, repr=False, compare=False)
    # In order of their due time.
    pending: list[Input] = field(default_factory=list)
    applied: Applied | None = None

    @property
    def landed_body_name(self) -> str:
        return "" if self.surface_contact_state == FLYING else self.body.name


@dataclass(slots=True)
class World:
    """The constants that a substep reads."""

    config: Config
    bodies: list[Body]
    terrain_height: TerrainHeight


@dataclass(slots=True)
class Event:
    """An event of a ship in a substep of the interval that begins at `tick`."""

    tick: int
    substep: int
    type: str
    ship: Ship
    body: str
    # For a touch: whether it follows a bounce, and the impact speed, m/s.
    again: bool = False
    impact_speed: float = 0.0


@dataclass(slots=True)
class Change:
    """The controls that a ship flew by from a substep of the interval that begins at `tick` on."""

    tick: int
    substep: int
    ship: Ship
    controls: Controls
