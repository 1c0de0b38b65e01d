"""Step 9: the first transition that applies to the state at the substep's end, at most one."""

from math import sqrt

from ..config import Config
from ..models import CONTACT, FLYING, LANDED, TIPPED, Ship
from .forces import is_nearly_at_rest, load_of
from .pose import move_with_ground
from .surface import Ground, OverGround, Place
from .vectors import Vec3, cross, dot, product, shortest_rotation, subtract, up_of

# Height of the feet above which a grounded ship has left the ground although it does not rise, m.
FELL_AWAY = -0.1

# Increase of penetration in the substep, m, and the substep, s.
Sinking = tuple[float, float]


# The values that decide a grounded ship's transition: place, ground, velocity over it and up at the end; mass, kg, and
# thrust, N, from step 1.
End = tuple[Place, Ground, OverGround, Vec3, float, Vec3]


def impact_speed(ground: Ground, speed: float, sinking: Sinking) -> float:
    """Closing speed, m/s: the larger of -v_s and the rate of penetration, which includes ground rising ahead of the ship."""
    sunk, dt = sinking
    falling = -speed
    closing = (sunk * ground[4]) / dt
    return falling if falling > closing else closing


def touch_or_crash(ship: Ship, config: Config, ground: Ground, speed: float, sinking: Sinking) -> str:
    """Transition of a flying ship that penetrates the ground."""
    impact = impact_speed(ground, speed, sinking)
    if impact > config.contact_crash_speed:
        return crash(ship)
    if not impact > 0:
        return ""
    ship.surface_contact_state = CONTACT
    ship.impact_speed = impact
    if config.touchdown_attitude == "aligned":
        ship.angular_velocity = ship.body.angular_velocity
        ship.attitude = product(shortest_rotation(up_of(ship.attitude), ground[1:4]), ship.attitude)
    return "ship.contact"


def leave_or_change(ship: Ship, config: Config, end: End, sinking: Sinking) -> str:
    """Transition of a ship in contact or tipped."""
    _, ground, over, up, _, _ = end
    penetration, sx, sy, sz, _, _, _, _ = ground
    speed = over[0]
    touching = penetration > 0
    if touching and impact_speed(ground, speed, sinking) > config.contact_crash_speed:
        return crash(ship)
    if (penetration <= 0 and speed > 0) or penetration < FELL_AWAY:
        ship.surface_contact_state = FLYING
        ship.impact_speed = 0.0
        return ""
    cos_tilt = sx * up[0] + sy * up[1] + sz * up[2]
    if ship.surface_contact_state == TIPPED:
        rights = cos_tilt > config.cos_tipped_angle and is_righting(ship, (sx, sy, sz), up)
        return right(ship) if rights else ""
    if not touching:
        return ""
    if cos_tilt < config.cos_tipped_angle:
        ship.surface_contact_state = TIPPED
        return "ship.tipped"
    return land(ship) if cos_tilt > config.cos_settle_tilt and is_settled(ship, config, end) else ""


def crash(ship: Ship) -> str:
    """A crash is an outcome, not a surface state: the ship's state is kept, and it is no longer simulated."""
    ship.crashed = True
    ship.surface_contact_state = FLYING
    return "ship.destroyed"


def right(ship: Ship) -> str:
    ship.surface_contact_state = CONTACT
    ship.impact_speed = 0.0
    return "ship.righted"


def is_righting(ship: Ship, normal: Vec3, up: Vec3) -> bool:
    """Whether the ship turns back towards upright."""
    return dot(relative_spin(ship), cross(normal, up)) < 0


def is_settled(ship: Ship, config: Config, end: End) -> bool:
    """Whether spin, normal speed and slide are below the settle limits, and the ground holds the ship."""
    spin = relative_spin(ship)
    if not dot(spin, spin) < config.contact_settle_angular_vel * config.contact_settle_angular_vel:
        return False
    place, ground, over, up, mass, thrust = end
    _, depth, _ = load_of(mass, mass * place[4], thrust, ground)
    return is_nearly_at_rest(config, ground, over, depth) and is_held(ship, config, place, ground, up)


def is_held(ship: Ship, config: Config, place: Place, ground: Ground, up: Vec3) -> bool:
    """Whether static friction holds the ship on the slope, and its weight acts within its footprint."""
    _, _, _, _, cos, lx, ly, lz = ground
    if not sqrt(lx * lx + ly * ly + lz * lz) <= config.contact_friction_static * cos:
        return False
    normal = place[:3]
    x, y, z = cross(normal, up)
    lever = ship.ground_contact_offset * sqrt(x * x + y * y + z * z)
    return lever <= ship.ship_class.leg_radius * dot(normal, up)


def relative_spin(ship: Ship) -> Vec3:
    """rad/s, ICRF axes, relative to the ground."""
    return subtract(ship.angular_velocity, ship.body.angular_velocity)


def land(ship: Ship) -> str:
    ship.surface_contact_state = LANDED
    move_with_ground(ship)
    ship.angular_velocity = ship.body.angular_velocity
    return "ship.landed"
