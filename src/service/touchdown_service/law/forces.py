"""Steps 3 to 5 on the ground: load, normal force, friction and linear motion."""

from math import sqrt

from ..config import Config
from ..models import Ship
from .surface import Ground, OverGround, Place
from .vectors import NOTHING, Vec3

# k / m of the contact spring, s^-2.
CONTACT_STIFFNESS = 100
# c / m at critical damping, 1/s.
CRITICAL_DAMPING = 20
# Square of the speed, 1 cm/s, above which only kinetic friction acts, (m/s)^2.
HELD_SPEED_SQUARED = 1e-4


def load_of(mass: float, weight: float, thrust: Vec3, ground: Ground) -> tuple[float, float, Vec3]:
    """Force into the ground, N; the static penetration under it, m; the tangential part of weight n - thrust, N, ICRF."""
    _, sx, sy, sz, cos, lx, ly, lz = ground
    if thrust is NOTHING:
        load = weight * cos
        return load, load / (CONTACT_STIFFNESS * mass), (weight * lx, weight * ly, weight * lz)
    tx, ty, tz = thrust
    off = tx * sx + ty * sy + tz * sz
    load = weight * cos - off
    if not load > 0:
        load = 0.0
    along = (weight * lx - (tx - off * sx), weight * ly - (ty - off * sy), weight * lz - (tz - off * sz))
    return load, load / (CONTACT_STIFFNESS * mass), along


def is_nearly_at_rest(config: Config, ground: Ground, over: OverGround, depth: float) -> bool:
    """Whether normal speed (spring energy included) and slide are below the settle limit."""
    most = config.settle_squared
    speed = over[0]
    sunk = ground[0] * ground[4] - depth
    return speed * speed + CONTACT_STIFFNESS * (sunk * sunk) < most and over[4] < most


def spring_force(config: Config, mass: float, ground: Ground, speed: float, settles: bool) -> float:
    """Step 4: spring and damper, N; critically damped where the contact settles without a bounce."""
    damping = CRITICAL_DAMPING if settles else CRITICAL_DAMPING * config.contact_damping_ratio
    force = mass * (CONTACT_STIFFNESS * (ground[0] * ground[4]) - damping * speed)
    return force if force > 0 else 0.0


def friction(
    ship: Ship,
    config: Config,
    per_speed: tuple[float, float],
    forces: tuple[float, Vec3],
    where: tuple[Place, Ground, OverGround],
) -> Vec3:
    """Static friction if it holds against slide, thrust, slope and the ground's rotation; else kinetic, at most
    the force that ends the slide.

    `per_speed`: mass / dt and mass / 2; `forces`: normal force and `along`, N.
    """
    mass_per_dt, half = per_speed
    force, (ax, ay, az) = forces
    ox, oy, oz = ship.body.angular_velocity
    ux, uy, uz = ship.velocity
    _, (_, sx, sy, sz, _, _, _, _), (_, tx, ty, tz, slide_squared) = where
    dx = tx * mass_per_dt - (ax + half * (oy * uz - oz * uy))
    dy = ty * mass_per_dt - (ay + half * (oz * ux - ox * uz))
    dz = tz * mass_per_dt - (az + half * (ox * uy - oy * ux))
    off = dx * sx + dy * sy + dz * sz
    dx = dx - off * sx
    dy = dy - off * sy
    dz = dz - off * sz
    demand = dx * dx + dy * dy + dz * dz
    held = config.contact_friction_static * force
    kinetic = config.contact_friction_kinetic * force
    if (slide_squared <= HELD_SPEED_SQUARED and demand <= held * held) or demand <= kinetic * kinetic:
        return -dx, -dy, -dz
    share = kinetic / sqrt(demand)
    return -dx * share, -dy * share, -dz * share


def accelerate(
    ship: Ship,
    weight: float,
    per_mass: float,
    forces: tuple[float, Vec3, Vec3],
    where: tuple[Place, Ground, OverGround],
) -> None:
    """u += (F s - weight n + friction + thrust) dt / m."""
    force, (fx, fy, fz), (tx, ty, tz) = forces
    (nx, ny, nz, _, _), (_, sx, sy, sz, _, _, _, _), _ = where
    ux, uy, uz = ship.velocity
    ship.velocity = (
        ux + (force * sx - weight * nx + fx + tx) * per_mass,
        uy + (force * sy - weight * ny + fy + ty) * per_mass,
        uz + (force * sz - weight * nz + fz + tz) * per_mass,
    )


def cap_rise(ship: Ship, ground: Ground, depth: float, dt: float) -> None:
    """Limits the normal speed of a settling ship so that it ends at the static depth; removes the excess along s."""
    penetration, sx, sy, sz, cos, _, _, _ = ground
    ox, oy, oz = ship.body.angular_velocity
    rx, ry, rz = ship.position
    ux, uy, uz = ship.velocity
    vx = ux - (oy * rz - oz * ry)
    vy = uy - (oz * rx - ox * rz)
    vz = uz - (ox * ry - oy * rx)
    speed = vx * sx + vy * sy + vz * sz
    to_rest = (penetration * cos - depth) / dt
    most = to_rest if to_rest > 0 else 0.0
    if speed > most:
        excess = speed - most
        ship.velocity = (ux - excess * sx, uy - excess * sy, uz - excess * sz)


def move(ship: Ship, dt: float) -> None:
    x, y, z = ship.position
    ux, uy, uz = ship.velocity
    ship.position = (x + ux * dt, y + uy * dt, z + uz * dt)
