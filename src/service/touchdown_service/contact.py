"""One substep of one ship, in the order of DYNAMICS; every sum in the order of ORDER."""

from .actuators import actuate
from .forces import Load, is_pinned, move_by_forces, normal_force
from .models import FLYING, LANDED, TIPPED, BodyStep, Ship, World
from .rest import rest_on_side
from .surface import surface_below, turn_attitude_with_ground, turn_place_with_ground
from .topple import turn_by_torques
from .transitions import make_transition
from .vectors import Quat, axes_of, up_of


def substep(ship: Ship, world: World, step: BodyStep, dt: float) -> str:
    """Moves the ship by dt over its body as it turns in `step`. Returns the event's name, or ''."""
    if ship.crashed:  # 0
        return ""
    body_axes, body_end_axes, body_turn = step
    axes = axes_of(ship.attitude)
    start = surface_below(ship, world, body_axes)
    mass = ship.ship_class.dry_mass + ship.fuel
    torque, thrust, lift = actuate(ship, axes, start.normal, dt)  # 1
    load = Load(mass, mass / ship.ship_class.full_mass, mass * start.gravity, thrust, lift)
    if stays_landed(ship, load, body_turn):  # 2
        return ""
    pinned = is_pinned(ship, world, start, load)  # 3
    load.normal_force = normal_force(ship, world, start, load, pinned)  # 4
    if not pinned:
        move_by_forces(ship, world, start, load, dt)  # 5
    turn_by_torques(ship, world, start, load, torque, axes, dt)  # 6
    if pinned:
        turn_place_with_ground(ship, body_turn)  # 8
    up = up_of(ship.attitude)
    end = surface_below(ship, world, body_end_axes)
    if ship.surface_contact_state == TIPPED:
        up = rest_on_side(ship, end.normal, up, dt)  # 8
    return make_transition(ship, world, start, end, load, up, dt)  # 9


def stays_landed(ship: Ship, load: Load, body_turn: Quat) -> bool:
    """Step 2: lift above the weight launches a landed or tipped ship; one that stays landed turns with the ground."""
    if ship.surface_contact_state not in (LANDED, TIPPED):
        return False
    if load.lift > load.weight:
        ship.surface_contact_state = FLYING
        ship.impact_speed = 0.0
        return False
    if ship.surface_contact_state == TIPPED:
        return False
    turn_place_with_ground(ship, body_turn)
    turn_attitude_with_ground(ship, body_turn)
    return True
