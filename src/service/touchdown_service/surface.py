"""Where a ship stands to the ground (DYNAMICS, Quantities; ORDER, step 0), and turning with it."""

from dataclasses import dataclass
from math import sqrt

from .models import Ship, World
from .vectors import Mat3, Quat, Vec3, cross, product, rotate_back


@dataclass(slots=True)
class Surface:
    """Quantities relative to the rotating ground below the ship."""

    normal: Vec3
    # m, positive below the surface
    penetration: float
    # m/s, positive upward
    radial_speed: float
    # m/s, ICRF axes, and its length
    tangential_velocity: Vec3
    tangential_speed: float
    # m/s^2
    gravity: float


def surface_below(ship: Ship, world: World, body_axes: Mat3) -> Surface:
    """From the ship's position and velocity as they are now; body_axes: how the body lies under it."""
    body = ship.body
    rx, ry, rz = ship.position
    squared = rx * rx + ry * ry + rz * rz
    distance = sqrt(squared)
    p = 1 / distance
    nx, ny, nz = normal = (rx * p, ry * p, rz * p)
    height = world.terrain_height(body.name, *rotate_back(body_axes, normal))
    penetration = body.radius + height + ship.ship_class.ground_contact_offset - distance
    ux, uy, uz = ship.velocity
    gx, gy, gz = cross(body.angular_velocity, ship.position)
    vx = ux - gx
    vy = uy - gy
    vz = uz - gz
    radial = vx * nx + vy * ny + vz * nz
    tx = vx - radial * nx
    ty = vy - radial * ny
    tz = vz - radial * nz
    slide = sqrt(tx * tx + ty * ty + tz * tz)
    return Surface(normal, penetration, radial, (tx, ty, tz), slide, body.mu / squared)


def turn_place_with_ground(ship: Ship, turn: Quat) -> None:
    """Landed or pinned: position and velocity turn with the body over the substep."""
    ax, ay, az, aw = turn
    x, y, z = ship.position
    tx, ty, tz = cross((ax, ay, az), ship.position)
    cx, cy, cz = cross((ax, ay, az), (tx, ty, tz))
    twice = 2 * aw
    ship.position = (x + tx * twice + 2 * cx, y + ty * twice + 2 * cy, z + tz * twice + 2 * cz)
    ship.velocity = ground_velocity(ship)


def turn_attitude_with_ground(ship: Ship, turn: Quat) -> None:
    """Landed: attitude and spin go with the body too."""
    ship.attitude = product(turn, ship.attitude)
    ship.angular_velocity = ship.body.angular_velocity


def ground_velocity(ship: Ship) -> Vec3:
    """Of the ground at the ship's centre of mass, relative to the body's centre."""
    return cross(ship.body.angular_velocity, ship.position)
