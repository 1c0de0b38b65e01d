"""Vectors (x, y, z), quaternions (x, y, z, w) and 3x3 matrices (nine numbers, row by row), each sum in the order of ORDER.md."""

from math import sqrt

Vec3 = tuple[float, float, float]
Quat = tuple[float, float, float, float]
Mat3 = tuple[float, float, float, float, float, float, float, float, float]

# No force or torque; distinguished by identity from one that happens to be zero.
NOTHING: Vec3 = (0.0, 0.0, 0.0)


def dot(a: Vec3, b: Vec3) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vec3, b: Vec3) -> Vec3:
    ax, ay, az = a
    bx, by, bz = b
    return (ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)


def add(a: Vec3, b: Vec3) -> Vec3:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def subtract(a: Vec3, b: Vec3) -> Vec3:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(a: Vec3, s: float) -> Vec3:
    return (a[0] * s, a[1] * s, a[2] * s)


def length(a: Vec3) -> float:
    x, y, z = a
    return sqrt(x * x + y * y + z * z)


def unit(a: Vec3) -> Vec3:
    return scale(a, 1 / length(a))


def rotate(m: Mat3, v: Vec3) -> Vec3:
    """M v: from body axes into ICRF where m is the matrix of an attitude."""
    x, y, z = v
    a, b, c, d, e, f, g, h, i = m
    return (a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + i * z)


def rotate_back(m: Mat3, v: Vec3) -> Vec3:
    """The transpose of M times v: from ICRF into body axes."""
    x, y, z = v
    a, b, c, d, e, f, g, h, i = m
    return (a * x + d * y + g * z, b * x + e * y + h * z, c * x + f * y + i * z)


def axes_of(q: Quat) -> Mat3:
    """The rotation matrix of a unit quaternion; its third column is `up`."""
    x, y, z, w = q
    x2 = x + x
    y2 = y + y
    z2 = z + z
    return (
        1 - (y * y2 + z * z2),
        x * y2 - w * z2,
        x * z2 + w * y2,
        x * y2 + w * z2,
        1 - (x * x2 + z * z2),
        y * z2 - w * x2,
        x * z2 - w * y2,
        y * z2 + w * x2,
        1 - (x * x2 + y * y2),
    )


def up_of(q: Quat) -> Vec3:
    """The third column of axes_of."""
    x, y, z, w = q
    x2 = x + x
    y2 = y + y
    z2 = z + z
    return (x * z2 + w * y2, y * z2 - w * x2, 1 - (x * x2 + y * y2))


def normalize(q: Quat) -> Quat:
    x, y, z, w = q
    p = 1 / sqrt(x * x + y * y + z * z + w * w)
    return (x * p, y * p, z * p, w * p)


def product(a: Quat, b: Quat) -> Quat:
    """The rotation b, then the rotation a; normalized."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return normalize(
        (
            ax * bw + aw * bx + ay * bz - az * by,
            ay * bw + aw * by + az * bx - ax * bz,
            az * bw + aw * bz + ax * by - ay * bx,
            aw * bw - ax * bx - ay * by - az * bz,
        )
    )


def turned(q: Quat, h: Vec3) -> Quat:
    """normalize(q + (h, 0) q), h half an angle's worth of turn: no sine, no cosine."""
    x, y, z, w = q
    hx, hy, hz = h
    return normalize(
        (
            x + (hx * w + hy * z - hz * y),
            y + (hy * w + hz * x - hx * z),
            z + (hz * w + hx * y - hy * x),
            w - (hx * x + hy * y + hz * z),
        )
    )


def small_rotation(h: Vec3) -> Quat:
    """normalize(h, 1)"""
    x, y, z = h
    p = 1 / sqrt(x * x + y * y + z * z + 1)
    return (x * p, y * p, z * p, p)


def perpendicular_axis(a: Vec3) -> Vec3:
    """unit(a x x) of a unit vector, x = (1, 0, 0), or (0, 1, 0) if |a_x| >= 0.9."""
    x, y, z = a
    if x >= 0.9 or x <= -0.9:
        p = 1 / sqrt(z * z + x * x)
        return (-z * p, 0.0, x * p)
    p = 1 / sqrt(z * z + y * y)
    return (0.0, z * p, -y * p)


def shortest_rotation(a: Vec3, b: Vec3) -> Quat:
    """The shortest rotation from unit a to unit b; half a turn if they are opposite."""
    d = dot(a, b)
    if d < -0.999999:
        return (*perpendicular_axis(a), 0.0)
    return normalize((*cross(a, b), 1 + d))
