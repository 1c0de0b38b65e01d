"""Steps 3 to 5: how settled a ship is, the normal force, friction and the linear motion."""

from dataclasses import dataclass

from .models import FLYING, TIPPED, Ship, World
from .surface import Surface, ground_velocity
from .vectors import Vec3, dot, length, scale, subtract

# k / m, s^-2: the contact spring
STIFFNESS = 100
# c / m of critical damping, 1/s
CRITICAL = 20
# m/s: below it static friction may hold
STICTION_SPEED = 0.01


@dataclass(slots=True)
class Load:
    """What a substep carries from its actuators to its end: kg, N, m."""

    mass: float
    ratio: float
    weight: float
    thrust: Vec3
    lift: float
    depth: float = 0.0
    normal_force: float = 0.0


def static_depth(net_weight: float, mass: float) -> float:
    """Penetration at rest under what the thrust leaves of the weight, m."""
    return net_weight / (STIFFNESS * mass) if net_weight > 0 else 0.0


def vertical_squared(surface: Surface, depth: float) -> float:
    """Vertical speed squared, the spring's stored energy counted in, m^2/s^2."""
    sunk = surface.penetration - depth
    return surface.radial_speed * surface.radial_speed + STIFFNESS * (sunk * sunk)


def is_pinned(ship: Ship, world: World, start: Surface, load: Load) -> bool:
    """Step 3: finds the static depth, and whether the ground holds a tipped ship where it stands."""
    if ship.surface_contact_state == FLYING:
        return False
    net_weight = load.weight - load.lift
    load.depth = static_depth(net_weight, load.mass)
    if ship.surface_contact_state != TIPPED or not start.penetration > 0:
        return False
    settle = world.config.contact_settle_linear_vel
    if not vertical_squared(start, load.depth) < settle * settle or not start.tangential_speed < settle:
        return False
    along_ground = subtract(load.thrust, scale(start.normal, load.lift))
    return length(along_ground) <= world.config.contact_friction_static * max(0.0, net_weight)


def settles_without_bounce(ship: Ship, world: World) -> bool:
    return (
        ship.surface_contact_state == TIPPED or ship.impact_speed <= world.config.contact_bounce_speed
    )


def normal_force(ship: Ship, world: World, start: Surface, load: Load, pinned: bool) -> float:
    """Step 4: spring and damper, N; what is left of the weight where the ship is pinned."""
    if pinned:
        return max(0.0, load.weight - load.lift)
    if ship.surface_contact_state == FLYING or not start.penetration > 0:
        return 0.0
    settles = settles_without_bounce(ship, world)
    damping = CRITICAL if settles else CRITICAL * world.config.contact_damping_ratio
    return max(0.0, load.mass * (STIFFNESS * start.penetration - damping * start.radial_speed))


def move_by_forces(ship: Ship, world: World, start: Surface, load: Load, dt: float) -> None:
    """Step 5: friction, semi-implicit Euler, no bounce out of a settling contact."""
    friction = friction_per_speed(world, start.tangential_speed, load, dt)
    per_mass = dt / load.mass
    radial = load.normal_force - load.weight
    nx, ny, nz = start.normal
    sx, sy, sz = start.tangential_velocity
    tx, ty, tz = load.thrust
    ux, uy, uz = ship.velocity
    ship.velocity = (
        ux + (radial * nx - friction * sx + tx) * per_mass,
        uy + (radial * ny - friction * sy + ty) * per_mass,
        uz + (radial * nz - friction * sz + tz) * per_mass,
    )
    grounded = ship.surface_contact_state != FLYING and start.penetration > 0
    if grounded and load.lift <= load.weight and settles_without_bounce(ship, world):
        cap_rise(ship, start, load.depth, dt)
    x, y, z = ship.position
    ux, uy, uz = ship.velocity
    ship.position = (x + ux * dt, y + uy * dt, z + uz * dt)


def friction_per_speed(world: World, speed: float, load: Load, dt: float) -> float:
    """Size of the friction over the sliding speed, N s/m."""
    if not (load.normal_force > 0 and speed > 0):
        return 0.0
    stop = load.mass * speed / dt
    kinetic = world.config.contact_friction_kinetic * load.normal_force
    if speed > STICTION_SPEED:
        return min(kinetic, stop) / speed
    return (stop if stop <= world.config.contact_friction_static * load.normal_force else kinetic) / speed


def cap_rise(ship: Ship, start: Surface, depth: float, dt: float) -> None:
    """The upward speed of a settling ship ends at the static depth."""
    rise = dot(subtract(ship.velocity, ground_velocity(ship)), start.normal)
    most = max(0.0, (start.penetration - depth) / dt)
    if rise > most:
        ship.velocity = subtract(ship.velocity, scale(start.normal, rise - most))
