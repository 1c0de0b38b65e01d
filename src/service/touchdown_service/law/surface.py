"""A ship's relation to the ground (DYNAMICS, Quantities; ORDER, Place, Penetration, Ground), as tuples of floats.

Place: n, distance and g. Ground: penetration, the surface normal s, c_s = n . s, and slope = n - c_s s.
"""

from math import sqrt

from ..models import Body, Ship, World
from .vectors import Mat3, Vec3

Place = tuple[float, float, float, float, float]
Ground = tuple[float, float, float, float, float, float, float, float]
# v_s and t: normal and tangential velocity, m/s; slide2: square of the tangential speed.
OverGround = tuple[float, float, float, float, float]

# |n_b . Y| from which the first level direction is taken from X: Y x n_b would be rounding error near the pole Y.
NEAR_POLE = 0.9


def place_of(position: Vec3, mu: float) -> Place:
    rx, ry, rz = position
    squared = rx * rx + ry * ry + rz * rz
    distance = sqrt(squared)
    p = 1 / distance
    return rx * p, ry * p, rz * p, distance, mu / squared


def penetration_of(ship: Ship, world: World, axes: Mat3, place: Place) -> float:
    """m, positive below the surface; `axes`: the body's orientation."""
    body = ship.body
    nx, ny, nz, distance, _ = place
    a, b, c, d, e, f, g, h, i = axes
    height = world.terrain_height(
        body.name, a * nx + d * ny + g * nz, b * nx + e * ny + h * nz, c * nx + f * ny + i * nz
    )
    return body.radius + height + ship.ground_contact_offset - distance


def ground_of(ship: Ship, world: World, axes: Mat3, place: Place, penetration: float) -> Ground:
    nx, ny, nz, _, _ = place
    if not world.config.is_terrain_normal:
        return penetration, nx, ny, nz, 1.0, 0.0, 0.0, 0.0
    a, b, c, d, e, f, g, h, i = axes
    n_b = (a * nx + d * ny + g * nz, b * nx + e * ny + h * nz, c * nx + f * ny + i * nz)
    bx, by, bz = slope_normal(n_b, ship.ship_class.leg_radius, ship.body, world)
    sx = a * bx + b * by + c * bz
    sy = d * bx + e * by + f * bz
    sz = g * bx + h * by + i * bz
    cos = nx * sx + ny * sy + nz * sz
    return penetration, sx, sy, sz, cos, nx - cos * sx, ny - cos * sy, nz - cos * sz


def slope_normal(n_b: Vec3, leg_radius: float, body: Body, world: World) -> Vec3:
    """Normal of the plane through the ground one leg radius ahead and behind in two level directions, body axes."""
    x, y, z = n_b
    if y >= NEAR_POLE or y <= -NEAR_POLE:
        p = 1 / sqrt(z * z + y * y)
        ey, ez = -z * p, y * p
        first = (0.0, ey, ez)
        second = (y * ez - z * ey, -x * ez, x * ey)
    else:
        p = 1 / sqrt(z * z + x * x)
        ex, ez = z * p, -x * p
        first = (ex, 0.0, ez)
        second = (y * ez, z * ex - x * ez, -y * ex)
    arm = leg_radius / body.radius
    l = 1 / sqrt(1 + arm * arm)  # noqa: E741
    spread = arm * l
    at = (x * l, y * l, z * l)
    rise_1 = rise(at, first, spread, leg_radius, (body, world))
    rise_2 = rise(at, second, spread, leg_radius, (body, world))
    sx = x - rise_1 * first[0] - rise_2 * second[0]
    sy = y - rise_1 * first[1] - rise_2 * second[1]
    sz = z - rise_1 * first[2] - rise_2 * second[2]
    p = 1 / sqrt(sx * sx + sy * sy + sz * sz)
    return sx * p, sy * p, sz * p


def rise(at: Vec3, along: Vec3, spread: float, leg_radius: float, where: tuple[Body, World]) -> float:
    """Slope of the ground along a level direction, m/m."""
    body, world = where
    x, y, z = at
    ex, ey, ez = along[0] * spread, along[1] * spread, along[2] * spread
    ahead = world.terrain_height(body.name, x + ex, y + ey, z + ez)
    behind = world.terrain_height(body.name, x - ex, y - ey, z - ez)
    return (ahead - behind) / (2 * leg_radius)


def over_ground(ship: Ship, ground: Ground) -> OverGround:
    rx, ry, rz = ship.position
    ux, uy, uz = ship.velocity
    ox, oy, oz = ship.body.angular_velocity
    _, sx, sy, sz, _, _, _, _ = ground
    vx = ux - (oy * rz - oz * ry)
    vy = uy - (oz * rx - ox * rz)
    vz = uz - (ox * ry - oy * rx)
    speed = vx * sx + vy * sy + vz * sz
    tx = vx - speed * sx
    ty = vy - speed * sy
    tz = vz - speed * sz
    return speed, tx, ty, tz, tx * tx + ty * ty + tz * tz
