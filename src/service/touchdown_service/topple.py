"""Step 6: the ground's moments on a ship whose feet are in it, then spin and attitude."""

from math import sqrt

from .forces import Load
from .models import FLYING, TIPPED, Ship, World
from .surface import Surface
from .vectors import Mat3, Vec3, add, dot, rotate, rotate_back, scale, subtract, turned

# s^-2 and 1/s per unit of inertia: the rotational twin of the spring-damper, critical
SUPPORT_STIFFNESS = 100
SUPPORT_DAMPING = 20
SCRUB_DAMPING = 20


def turn_by_torques(
    ship: Ship, world: World, start: Surface, load: Load, torque: Vec3, axes: Mat3, dt: float
) -> None:
    """Semi-implicit Euler with the actuators' torque and the ground's, both in body axes."""
    if ship.surface_contact_state != FLYING and start.penetration > 0:
        torque = add_ground_torques(ship, world, start, load, torque, axes)
    if torque[0] != 0 or torque[1] != 0 or torque[2] != 0:
        change = scale(rotate(ship.ship_class.inverse_inertia, torque), dt / load.ratio)
        ship.angular_velocity = add(ship.angular_velocity, rotate(axes, change))
    ship.attitude = turned(ship.attitude, scale(ship.angular_velocity, 0.5 * dt))


def add_ground_torques(
    ship: Ship, world: World, start: Surface, load: Load, torque: Vec3, axes: Mat3
) -> Vec3:
    """torque + gravity about the feet, the legs' support and the feet's scrub; body axes, where up is z."""
    cls = ship.ship_class
    bx, by, bz = rotate_back(axes, start.normal)
    wx, wy, wz = rotate_back(axes, subtract(ship.angular_velocity, ship.body.angular_velocity))
    yaw = wx * bx + wy * by + wz * bz
    held = min(load.weight, load.normal_force)
    toppling = held * cls.ground_contact_offset
    reach = held * cls.leg_radius
    support = (
        -SUPPORT_STIFFNESS * by - SUPPORT_DAMPING * (wx - yaw * bx),
        SUPPORT_STIFFNESS * bx - SUPPORT_DAMPING * (wy - yaw * by),
        -SUPPORT_DAMPING * (wz - yaw * bz),
    )
    roll = wz if ship.surface_contact_state == TIPPED else 0.0
    scrub = (
        -SCRUB_DAMPING * (yaw * bx),
        -SCRUB_DAMPING * (yaw * by),
        -SCRUB_DAMPING * (yaw * bz + roll),
    )
    most_support = reach * bz if bz > 0 else 0.0
    most_scrub = world.config.contact_friction_kinetic * reach
    sx, sy, sz = capped(scale(rotate(cls.inertia, support), load.ratio), most_support)
    kx, ky, kz = capped(scale(rotate(cls.inertia, scrub), load.ratio), most_scrub)
    return (
        torque[0] + toppling * by + sx + kx,
        torque[1] - toppling * bx + sy + ky,
        torque[2] + sz + kz,
    )


def capped(moment: Vec3, most: float) -> Vec3:
    """The moment, its length at most `most`, N m."""
    squared = dot(moment, moment)
    return scale(moment, most / sqrt(squared)) if squared > most * most else moment
