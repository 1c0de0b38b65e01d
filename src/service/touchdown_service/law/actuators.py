"""Engine, thrusters and wheels (DYNAMICS, Actuators; ORDER, step 1)."""

from ..models import LANDED, Ship
from .attitude_control import commanded_torque
from .surface import Place
from .vectors import NOTHING, Mat3, Vec3


def actuate(ship: Ship, axes: Mat3, place: Place, factor: float, dt: float) -> tuple[Vec3, Vec3]:
    """Torque in body axes and thrust in ICRF; fills the wheels and burns the fuel."""
    torque = NOTHING
    rcs = 0.0
    controls = ship.controls
    if controls.steers and ship.surface_contact_state != LANDED:
        asked = commanded_torque(ship, axes, place, factor)
        if asked is not None:
            torque, rcs = allocate_torque(ship, asked, dt)
    if not ship.fuel > 0 or not (controls.pushes or rcs != 0):
        return torque, NOTHING
    return torque, apply_thrust(ship, axes, rcs, dt)


def allocate_torque(ship: Ship, asked: Vec3, dt: float) -> tuple[Vec3, float]:
    """Divides torque between wheels, up to saturation, and RCS, while there is fuel. Also returns the sum of RCS torque."""
    cls = ship.ship_class
    ax, ay, az = asked
    px, py, pz = ship.wheel_momentum
    cx, cy, cz = cls.wheel_capacity
    wx, wy, wz = cls.reaction_wheel_torque
    rx, ry, rz = cls.rcs_torque if ship.fuel > 0 else NOTHING
    tx, px, x = torque_about(ax, px, (cx, wx, rx), dt)
    ty, py, y = torque_about(ay, py, (cy, wy, ry), dt)
    tz, pz, z = torque_about(az, pz, (cz, wz, rz), dt)
    ship.wheel_momentum = (px, py, pz)
    return (tx, ty, tz), x + y + z


def torque_about(
    asked: float, momentum: float, limits: tuple[float, float, float], dt: float
) -> tuple[float, float, float]:
    """Torque about one axis, the wheel's momentum after it, and the thrusters' part in the torque.

    `limits`: the wheel's capacity, its torque and the thrusters' torque.
    """
    capacity, most, most_rcs = limits
    is_negative = asked < 0
    size = -asked if is_negative else asked
    left = (capacity + momentum if is_negative else capacity - momentum) / dt
    if left < most:
        most = left if left > 0 else 0.0
    by_wheel = size if size < most else most
    rest = size - by_wheel
    by_rcs = rest if rest < most_rcs else most_rcs
    if is_negative:
        return -by_wheel - by_rcs, momentum - by_wheel * dt, by_rcs
    return by_wheel + by_rcs, momentum + by_wheel * dt, by_rcs


def apply_thrust(ship: Ship, axes: Mat3, rcs: float, dt: float) -> Vec3:
    """Thrust of main engine and translation thrusters; burns their fuel and that of `rcs` N m of torque."""
    cls = ship.ship_class
    controls = ship.controls
    main = controls.thrust_level * cls.main_engine_thrust
    ix, iy, iz = controls.translation_input
    tx, ty, tz = cls.rcs_thrust
    fx = ix * tx
    fy = iy * ty
    fz = iz * tz
    burn = abs(fx) + abs(fy) + abs(fz) + rcs * cls.force_per_torque
    left = ship.fuel - (main * cls.main_flow + burn * cls.rcs_flow) * dt
    ship.fuel = left if left > 0 else 0.0
    along = fz + main
    a, b, c, d, e, f, g, h, i = axes
    return (a * fx + b * fy + c * along, d * fx + e * fy + f * along, g * fx + h * fy + i * along)
