"""Step 6: the ground's moments on a penetrating ship, ICRF axes."""

from math import sqrt

from ..config import Config
from ..models import TIPPED, Ship
from .surface import Ground, OverGround, Place
from .vectors import Mat3, Vec3

# Per unit of inertia, s^-2 and 1/s: critically damped, like the contact spring.
SUPPORT_STIFFNESS = 100
SUPPORT_DAMPING = 20
SCRUB_DAMPING = 20


def ground_torque(
    ship: Ship, config: Config, axes: Mat3, where: tuple[Place, Ground, OverGround], forces: tuple[float, float, float]
) -> Vec3:
    """Gravity about the feet, the legs' support and the feet's scrub, N m, turned into body axes.

    `forces`: normal force, weight, and the factor of the inertia tensor.
    """
    cls = ship.ship_class
    (nx, ny, nz, _, _), (_, sx, sy, sz, cos, _, _, _), _ = where
    force, weight, factor = forces
    a, b, upx, d, e, upy, g, h, upz = axes
    wx, wy, wz = ship.angular_velocity
    ox, oy, oz = ship.body.angular_velocity
    rx = wx - ox
    ry = wy - oy
    rz = wz - oz
    yaw = rx * sx + ry * sy + rz * sz
    yaw_x = yaw * sx
    yaw_y = yaw * sy
    yaw_z = yaw * sz
    # Normal force, at most the weight's normal component; and the weight that it balances.
    most = weight * cos
    held = force if force < most else most
    carried = held / cos
    toppling = carried * ship.ground_contact_offset

    # Support, limited by the weight's lever arm at the footprint's edge.
    support = cls.support_inertia * factor
    stiffness = -SUPPORT_STIFFNESS * support
    damping = SUPPORT_DAMPING * support
    mx = stiffness * (sy * upz - sz * upy) - damping * (rx - yaw_x)
    my = stiffness * (sz * upx - sx * upz) - damping * (ry - yaw_y)
    mz = stiffness * (sx * upy - sy * upx) - damping * (rz - yaw_z)
    level = nx * upx + ny * upy + nz * upz
    limit = carried * cls.leg_radius * level if level > 0 else 0.0
    squared = mx * mx + my * my + mz * mz
    if squared > limit * limit:
        share = limit / sqrt(squared)
        mx, my, mz = mx * share, my * share, mz * share

    # Scrub of the yaw about s, and of a tipped hull's roll about up as well.
    roll = rx * upx + ry * upy + rz * upz if ship.surface_contact_state == TIPPED else 0.0
    scrubbing = -SCRUB_DAMPING * (cls.scrub_inertia * factor)
    kx = scrubbing * (yaw_x + roll * upx)
    ky = scrubbing * (yaw_y + roll * upy)
    kz = scrubbing * (yaw_z + roll * upz)
    limit = config.contact_friction_kinetic * held * cls.leg_radius
    squared = kx * kx + ky * ky + kz * kz
    if squared > limit * limit:
        share = limit / sqrt(squared)
        kx, ky, kz = kx * share, ky * share, kz * share

    # Gravity about the feet.
    mx = toppling * (ny * upz - nz * upy) + mx + kx
    my = toppling * (nz * upx - nx * upz) + my + ky
    mz = toppling * (nx * upy - ny * upx) + mz + kz
    return (
        a * mx + d * my + g * mz,
        b * mx + e * my + h * mz,
        upx * mx + upy * my + upz * mz,
    )
