"""Step 9: the first transition that applies to the state at the substep's end, at most one."""

from .forces import Load, static_depth, vertical_squared
from .models import CONTACT, FLYING, LANDED, TIPPED, Ship, World
from .surface import Surface, ground_velocity
from .vectors import Vec3, cross, dot, product, shortest_rotation, subtract

# m: let go of, where the ground fell away
FELL_AWAY = -0.1


def make_transition(
    ship: Ship, world: World, start: Surface, end: Surface, load: Load, up: Vec3, dt: float
) -> str:
    """Changes the surface state; returns the event's name, or ''."""
    config = world.config
    touching = end.penetration > 0
    if ship.surface_contact_state == FLYING:
        return touch(ship, world, end, up, impact_speed(start, end, dt)) if touching else ""
    if touching and impact_speed(start, end, dt) > config.contact_crash_speed:
        return crash(ship)
    if (end.penetration <= 0 and end.radial_speed > 0) or end.penetration < FELL_AWAY:
        return leave(ship)
    cos_tilt = dot(end.normal, up)
    if ship.surface_contact_state == TIPPED:
        rights = cos_tilt > config.cos_tipped_angle and is_righting(ship, end.normal, up)
        return right(ship) if rights else ""
    if not touching:
        return ""
    if cos_tilt < config.cos_tipped_angle:
        ship.surface_contact_state = TIPPED
        return "ship.tipped"
    return land(ship) if cos_tilt > config.cos_settle_tilt and is_settled(ship, world, end, load) else ""


def impact_speed(start: Surface, end: Surface, dt: float) -> float:
    """How fast ship and ground close, m/s; the second sees ground that rises ahead of a fast ship."""
    return max((end.penetration - start.penetration) / dt, -end.radial_speed)


def touch(ship: Ship, world: World, end: Surface, up: Vec3, impact: float) -> str:
    if impact > world.config.contact_crash_speed:
        return crash(ship)
    if not impact > 0:
        return ""
    ship.surface_contact_state = CONTACT
    ship.impact_speed = impact
    if world.config.touchdown_attitude == "aligned":
        ship.angular_velocity = ship.body.angular_velocity
        ship.attitude = product(shortest_rotation(up, end.normal), ship.attitude)
    return "ship.contact"


def crash(ship: Ship) -> str:
    """A result, not a state: the rest stays as it was, and the ship is out of the simulation."""
    ship.crashed = True
    ship.surface_contact_state = FLYING
    return "ship.crashed"


def leave(ship: Ship) -> str:
    ship.surface_contact_state = FLYING
    ship.impact_speed = 0.0
    return ""


def right(ship: Ship) -> str:
    ship.surface_contact_state = CONTACT
    ship.impact_speed = 0.0
    return "ship.righted"


def is_righting(ship: Ship, normal: Vec3, up: Vec3) -> bool:
    """It turns back towards upright."""
    return dot(relative_spin(ship), cross(normal, up)) < 0


def is_settled(ship: Ship, world: World, end: Surface, load: Load) -> bool:
    """Spin, vertical speed and slide below the settle limits."""
    config = world.config
    spin = relative_spin(ship)
    if not dot(spin, spin) < config.contact_settle_angular_vel * config.contact_settle_angular_vel:
        return False
    settle = config.contact_settle_linear_vel
    if not end.tangential_speed < settle:
        return False
    mass = ship.ship_class.dry_mass + ship.fuel
    depth = static_depth(mass * end.gravity - load.lift, mass)
    return vertical_squared(end, depth) < settle * settle


def relative_spin(ship: Ship) -> Vec3:
    """rad/s, ICRF axes, relative to the ground."""
    return subtract(ship.angular_velocity, ship.body.angular_velocity)


def land(ship: Ship) -> str:
    ship.surface_contact_state = LANDED
    ship.velocity = ground_velocity(ship)
    ship.angular_velocity = ship.body.angular_velocity
    return "ship.landed"
