"""Torque commanded by stick or attitude controller (DYNAMICS, Actuators; ORDER, step 1)."""

from math import sqrt

from ..models import ATTITUDE_MODES, FLYING, Ship
from .surface import Place
from .vectors import Mat3, Vec3, add, cross, length, rotate, rotate_back, scale, subtract

ALONG_VELOCITY = frozenset({"prograde", "retrograde", "surface_retrograde", "normal", "antinormal"})
KNOWN_MODES = frozenset(ATTITUDE_MODES)

# Speed below which the direction of the velocity is rounding error, m/s.
MIN_SPEED = 1e-3
# |r x u| / (|r| |u|) below which the direction of r x u is rounding error.
MIN_SINE = 1e-6
# Ground speed below which the game keeps its last direction, m/s. Here rates are damped, which needs no memory and stays close to it.
MIN_SURFACE_SPEED = 0.1


def commanded_torque(ship: Ship, axes: Mat3, place: Place, factor: float) -> Vec3 | None:
    """Commanded torque, N m, body axes; None if neither is active. `factor`: on the inertia tensor, at the present fuel."""
    controls = ship.controls
    cls = ship.ship_class
    stick = controls.rotation_input
    if stick[0] != 0 or stick[1] != 0 or stick[2] != 0:
        available = cls.full_torque if ship.fuel > 0 else cls.reaction_wheel_torque
        return (stick[0] * available[0], stick[1] * available[1], stick[2] * available[2])
    mode = controls.attitude_mode
    if mode == "none" and not controls.attitude_hold:
        return None
    wish = scale(rotate_back(axes, ship.angular_velocity), -cls.attitude_damping)
    if mode == "hold":
        wish = add(wish, scale(rotate_back(axes, error_to_target(ship)), cls.attitude_stiffness))
    elif points(mode, ship.surface_contact_state):
        wish = steer_to_direction(wish, direction(ship, mode, place), axes, cls.attitude_stiffness)
    return scale(rotate(cls.inertia, wish), factor)


def points(mode: str, state: str) -> bool:
    """Rate damping for unknown modes, and for velocity modes on the ground."""
    if mode == "none" or mode not in KNOWN_MODES:
        return False
    return state == FLYING or mode not in ALONG_VELOCITY


def error_to_target(ship: Ship) -> Vec3:
    """+-2 x vector part of target * attitude^-1, ICRF."""
    qx, qy, qz, qw = ship.attitude
    tx, ty, tz, tw = ship.controls.target_attitude
    sign = 2 if tw * qw + tx * qx + ty * qy + tz * qz >= 0 else -2
    return (
        sign * (tx * qw - tw * qx - ty * qz + tz * qy),
        sign * (ty * qw - tw * qy - tz * qx + tx * qz),
        sign * (tz * qw - tw * qz - tx * qy + ty * qx),
    )


def direction(ship: Ship, mode: str, place: Place) -> Vec3 | None:
    """Unit direction of a pointing mode, ICRF; None if it would be rounding error."""
    nx, ny, nz, distance, _ = place
    if mode == "radial":
        return (nx, ny, nz)
    if mode == "antiradial":
        return (-nx, -ny, -nz)
    if mode == "surface_retrograde":
        over = subtract(ship.velocity, cross(ship.body.angular_velocity, ship.position))
        speed = length(over)
        return None if speed < MIN_SURFACE_SPEED else scale(over, -1 / speed)
    speed = length(ship.velocity)
    if speed < MIN_SPEED:
        return None
    if mode in ("prograde", "retrograde"):
        return scale(ship.velocity, (1 if mode == "prograde" else -1) / speed)
    across = cross(ship.position, ship.velocity)
    size = length(across)
    if size < MIN_SINE * distance * speed:
        return None
    return scale(across, (1 if mode == "normal" else -1) / size)


def steer_to_direction(wish: Vec3, towards: Vec3 | None, axes: Mat3, stiffness: float) -> Vec3:
    """a + stiffness e, e = up x d; in body axes up is z, so e = (-d_y, d_x, 0)."""
    if towards is None:
        return wish
    dx, dy, dz = rotate_back(axes, towards)
    ex = -dy
    ey = dx
    if dz < 0:
        # The error is 1 beyond 90 degrees, so that control does not stall when the ship points directly away; about x there.
        size = sqrt(ex * ex + ey * ey)
        ex, ey = (1.0, 0.0) if size <= 1e-6 else (ex / size, ey / size)
    return (wish[0] + stiffness * ex, wish[1] + stiffness * ey, wish[2])
