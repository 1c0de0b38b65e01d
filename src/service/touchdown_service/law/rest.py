"""Step 8: the hull of a tipped ship rests on its side."""

from ..models import Ship
from .vectors import (
    Mat3,
    Vec3,
    axes_of,
    cross,
    dot,
    length,
    perpendicular_axis,
    product,
    rotate,
    rotate_back,
    scale,
    shortest_rotation,
    small_rotation,
    subtract,
    unit,
    up_of,
)


def rest_on_side(ship: Ship, normal: Vec3, up: Vec3, dt: float) -> Vec3:
    """Past 90 degrees of tilt, stops further tilting and turns the ship back to 90 degrees. Returns the new up."""
    cos_tilt = dot(normal, up)
    if not cos_tilt < 0:
        return up
    axis = tipping_axis(normal, up)
    stop_further_tilt(ship, axis, axes_of(ship.attitude))
    if -cos_tilt > dt:
        rotation = small_rotation(scale(axis, -0.5 * dt))
    else:
        rotation = shortest_rotation(up, unit(subtract(up, scale(normal, cos_tilt))))
    ship.attitude = product(rotation, ship.attitude)
    return up_of(ship.attitude)


def tipping_axis(normal: Vec3, up: Vec3) -> Vec3:
    """unit(s x up), the tipping axis; any axis along the ground if the ship is upside down."""
    across = cross(normal, up)
    size = length(across)
    return perpendicular_axis(normal) if size <= 1e-6 else scale(across, 1 / size)


def stop_further_tilt(ship: Ship, axis: Vec3, axes: Mat3) -> None:
    """An impulse of the ground about the axis. Removing the spin along the axis instead would feed other axes of a full tensor."""
    spin = dot(subtract(ship.angular_velocity, ship.body.angular_velocity), axis)
    if not spin > 0:
        return
    j = rotate(axes, rotate(ship.ship_class.inverse_inertia, rotate_back(axes, axis)))
    ship.angular_velocity = subtract(ship.angular_velocity, scale(j, spin / dot(j, axis)))
