"""Engine, thrusters and wheels (DYNAMICS, Actuators; ORDER, step 1)."""

from ..models import LANDED, Ship
from .attitude_control import asked_torque
from .surface import Place
from .vectors import Mat3, Vec3

NOTHING: Vec3 = (0.0, 0.0, 0.0)


def actuate(ship: Ship, axes: Mat3, place: Place, factor: float, dt: float) -> tuple[Vec3, Vec3]:
    """Torque in body axes and thrust in ICRF; fills the wheels and burns the fuel."""
    torque = NOTHING
    rcs = 0.0
    controls = ship.controls
    if controls.steers and ship.surface_contact_state != LANDED:
        asked = asked_torque(ship, axes, place, factor)
        if asked is not None:
            torque, rcs = give_torque(ship, asked, dt)
    if not ship.fuel > 0 or not (controls.pushes or rcs != 0):
        return torque, NOTHING
    return torque, push(ship, axes, rcs, dt)


def give_torque(ship: Ship, asked: Vec3, dt: float) -> tuple[Vec3, float]:
    """Divides torque between wheels, up to saturation, and RCS, while there is fuel. Also returns the sum of RCS torque."""
    cls = ship.ship_class
    has_fuel = ship.fuel > 0
    torques = []
    momenta = []
    rcs = 0.0
    for k in (0, 1, 2):
        wanted = asked[k]
        momentum = ship.wheel_momentum[k]
        capacity = cls.wheel_capacity[k]
        size = -wanted if wanted < 0 else wanted
        left = (capacity + momentum if wanted < 0 else capacity - momentum) / dt
        most = cls.reaction_wheel_torque[k]
        if left < most:
            most = left if left > 0 else 0.0
        by_wheel = size if size < most else most
        wheel = -by_wheel if wanted < 0 else by_wheel
        momenta.append(momentum + wheel * dt)
        if has_fuel:
            rest = size - by_wheel
            by_rcs = rest if rest < cls.rcs_torque[k] else cls.rcs_torque[k]
            wheel = wheel - by_rcs if wanted < 0 else wheel + by_rcs
            rcs = rcs + by_rcs
        torques.append(wheel)
    ship.wheel_momentum = tuple(momenta)
    return tuple(torques), rcs


def push(ship: Ship, axes: Mat3, rcs: float, dt: float) -> Vec3:
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
