"""Engine, thrusters, wheels and attitude control (DYNAMICS, Actuators; ORDER, step 1)."""

from math import sqrt

from .models import FLYING, LANDED, Ship
from .vectors import Mat3, Vec3, add, cross, dot, length, rotate, rotate_back, scale

NO_VECTOR = (0.0, 0.0, 0.0)
ALONG_VELOCITY = {"prograde", "retrograde", "normal", "antinormal"}
REVERSED = {"retrograde", "antinormal", "antiradial"}


def actuate(ship: Ship, axes: Mat3, normal: Vec3, dt: float) -> tuple[Vec3, Vec3, float]:
    """Torque in body axes, thrust in ICRF and lift; burns the fuel."""
    torque = NO_VECTOR
    rcs = 0.0
    if ship.surface_contact_state != LANDED:
        torque = attitude_torque(ship, axes, normal)
        for asked, wheel in zip(torque, ship.ship_class.reaction_wheel_torque):
            by_rcs = abs(asked) - wheel
            if by_rcs > 0:
                rcs = rcs + by_rcs
    thrust = push(ship, axes, rcs, dt)
    return torque, thrust, dot(thrust, normal)


def push(ship: Ship, axes: Mat3, rcs: float, dt: float) -> Vec3:
    """Thrust of main engine and translation thrusters; burns for them and for `rcs` newton metres of torque."""
    cls = ship.ship_class
    controls = ship.controls
    commanded = controls.thrust_level != 0 or any(controls.translation_input) or rcs != 0
    if not ship.fuel > 0 or not commanded:
        return NO_VECTOR
    main = controls.thrust_level * cls.main_engine_thrust
    (ix, iy, iz), (tx, ty, tz) = controls.translation_input, cls.rcs_thrust
    fx = ix * tx
    fy = iy * ty
    fz = iz * tz
    burn = abs(fx) + abs(fy) + abs(fz) + rcs * cls.force_per_torque
    left = ship.fuel - (main * cls.main_flow + burn * cls.rcs_flow) * dt
    ship.fuel = left if left > 0 else 0.0
    return rotate(axes, (fx, fy, fz + main))


def attitude_torque(ship: Ship, axes: Mat3, normal: Vec3) -> Vec3:
    """What stick or attitude control asks for, as far as wheels and RCS can give it."""
    controls = ship.controls
    cls = ship.ship_class
    available = cls.full_torque if ship.fuel > 0 else cls.reaction_wheel_torque
    stick = controls.rotation_input
    if stick[0] != 0 or stick[1] != 0 or stick[2] != 0:
        return (stick[0] * available[0], stick[1] * available[1], stick[2] * available[2])
    mode = controls.attitude_mode
    damps = controls.attitude_hold
    if mode in ALONG_VELOCITY and ship.surface_contact_state != FLYING:
        mode, damps = "none", True
    if mode == "none" and not damps:
        return NO_VECTOR
    wish = scale(rotate_back(axes, ship.angular_velocity), -4)
    if mode == "hold":
        wish = add(wish, scale(rotate_back(axes, error_to_target(ship)), 4))
    elif mode != "none":
        wish = steer_to_direction(wish, direction(ship, mode, normal), axes)
    ratio = (cls.dry_mass + ship.fuel) / cls.full_mass
    return tuple(
        clamp(ratio * moment, most) for moment, most in zip(rotate(cls.inertia, wish), available)
    )


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


def direction(ship: Ship, mode: str, normal: Vec3) -> Vec3 | None:
    """The unit direction of a pointing mode, ICRF; None where a zero vector has none."""
    if mode in ("prograde", "retrograde"):
        along = ship.velocity
    elif mode in ("normal", "antinormal"):
        along = cross(ship.position, ship.velocity)
    else:
        along = normal
    size = length(along)
    if not size > 0:
        return None
    return scale(along, (-1 if mode in REVERSED else 1) / size)


def steer_to_direction(wish: Vec3, towards: Vec3 | None, axes: Mat3) -> Vec3:
    """a + 4 e, e = up x d; in body axes up is z, so e = (-d_y, d_x, 0)."""
    if towards is None:
        return wish
    dx, dy, dz = rotate_back(axes, towards)
    ex = -dy
    ey = dx
    if dz < 0:
        size = sqrt(ex * ex + ey * ey)
        ex, ey = (1, 0) if size <= 1e-6 else (ex / size, ey / size)
    return (wish[0] + 4 * ex, wish[1] + 4 * ey, wish[2])


def clamp(torque: float, most: float) -> float:
    if torque > most:
        return most
    return -most if torque < -most else torque
