"""Moving and turning with the ground, and turning by a torque (ORDER, Turning with the ground; step 6)."""

from math import sqrt

from ..models import Ship
from .vectors import Mat3, Quat, Vec3, product, rotate


def turn_place_with_ground(ship: Ship, turn: Quat) -> None:
    """Landed or pinned: position and velocity turn with the body over the substep."""
    ax, ay, az, aw = turn
    x, y, z = ship.position
    tx = ay * z - az * y
    ty = az * x - ax * z
    tz = ax * y - ay * x
    twice = 2 * aw
    ship.position = (
        x + tx * twice + 2 * (ay * tz - az * ty),
        y + ty * twice + 2 * (az * tx - ax * tz),
        z + tz * twice + 2 * (ax * ty - ay * tx),
    )
    move_with_ground(ship)


def move_with_ground(ship: Ship) -> None:
    """u = Omega x r: the velocity of co-rotating ground at the centre of mass."""
    ox, oy, oz = ship.body.angular_velocity
    x, y, z = ship.position
    ship.velocity = (oy * z - oz * y, oz * x - ox * z, ox * y - oy * x)


def turn_attitude_with_ground(ship: Ship, turn: Quat) -> None:
    """Landed: attitude and spin also follow the body."""
    ship.attitude = product(turn, ship.attitude)
    ship.angular_velocity = ship.body.angular_velocity


def spin_by_torque(ship: Ship, torque: Vec3, axes: Mat3, scaled: float) -> None:
    """w += q.rotate(I^-1 torque) dt; `scaled` = dt / factor."""
    tx, ty, tz = torque
    if tx != 0 or ty != 0 or tz != 0:
        a, b, c, d, e, f, g, h, i = ship.ship_class.inverse_inertia
        change = (
            (a * tx + b * ty + c * tz) * scaled,
            (d * tx + e * ty + f * tz) * scaled,
            (g * tx + h * ty + i * tz) * scaled,
        )
        x, y, z = rotate(axes, change)
        wx, wy, wz = ship.angular_velocity
        ship.angular_velocity = (wx + x, wy + y, wz + z)


def turn_by_spin(ship: Ship, half: float) -> None:
    """q = normalize(q + half (w, 0) q), half = dt / 2: no sine, no cosine."""
    wx, wy, wz = ship.angular_velocity
    x, y, z, w = ship.attitude
    hx = wx * half
    hy = wy * half
    hz = wz * half
    nx = x + (hx * w + hy * z - hz * y)
    ny = y + (hy * w + hz * x - hx * z)
    nz = z + (hz * w + hx * y - hy * x)
    nw = w - (hx * x + hy * y + hz * z)
    p = 1 / sqrt(nx * nx + ny * ny + nz * nz + nw * nw)
    ship.attitude = (nx * p, ny * p, nz * p, nw * p)
