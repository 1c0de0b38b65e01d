"""One substep of one ship, in the order of DYNAMICS; every sum in the order of ORDER."""

from .law.actuators import actuate
from .law.flight import fly
from .law.forces import (
    accelerate,
    along_ground,
    cap_rise,
    depth_of,
    friction,
    is_nearly_at_rest,
    move,
    settles_without_bounce,
    spring_force,
)
from .law.moments import ground_torque
from .law.pose import spin_by_torque, turn_attitude_with_ground, turn_by_spin, turn_place_with_ground
from .law.rest import rest_on_side
from .law.surface import Ground, Place, ground_of, over_ground, penetration_of, place_of
from .law.transitions import End, leave_or_change, touch_or_crash
from .law.vectors import Mat3, Quat, Vec3, add, axes_of, dot, up_of
from .models import FLYING, LANDED, TIPPED, BodyStep, Ship, World

NOTHING: Vec3 = (0.0, 0.0, 0.0)
NO_AXES: Mat3 = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)


def substep(ship: Ship, world: World, step: BodyStep, dt: float) -> str:
    """Advances the ship by dt; `step` has the body's attitudes. Returns the event's name, or ''."""
    if ship.crashed:  # 0
        return ""
    state = ship.surface_contact_state
    controls = ship.controls
    if state == LANDED and not controls.pushes:  # 1, 2: without thrust there is no lift
        return stay_landed(ship, step[2])
    standing = ship.standing
    if standing and standing[0] is ship.position:
        place = standing[2]
    else:
        place = place_of(ship.position, ship.body.mu)
    mass = ship.ship_class.dry_mass + ship.fuel
    if state == FLYING and not controls.is_active:
        return fly_substep(ship, world, step, (place, NO_AXES, NOTHING, NOTHING, mass, 1.0), dt)
    axes = axes_of(ship.attitude)
    factor = ship.ship_class.inertia_at_dry + ship.ship_class.inertia_per_fuel * ship.fuel
    torque, thrust = actuate(ship, axes, place, factor, dt)  # 1
    if thrust is not NOTHING and is_lifted(ship, thrust, place, mass * place[4]):
        state = ship.surface_contact_state  # 2
    if state == LANDED:
        return stay_landed(ship, step[2])
    acting = (place, axes, torque, thrust, mass, factor)
    if state == FLYING:
        return fly_substep(ship, world, step, acting, dt)
    return ground_substep(ship, world, step, acting, dt)


# What the actuators do in a substep: place at its start, the ship's axes, torque (body axes), thrust (ICRF), mass and
# the factor of inertia from before the burn.
Acting = tuple[Place, Mat3, Vec3, Vec3, float, float]
# What a grounded ship's substep ended on: the position and the body's axes for which it holds, the place, the ground.
# The next substep begins with the same numbers, unless something else has moved the ship.
Standing = tuple[Vec3, Mat3, Place, Ground]


def stay_landed(ship: Ship, turn: Quat) -> str:
    turn_place_with_ground(ship, turn)
    turn_attitude_with_ground(ship, turn)
    return ""


def is_lifted(ship: Ship, thrust: Vec3, place: Place, weight: float) -> bool:
    """Step 2: a landed or tipped ship launches if lift exceeds weight, and starts a new approach."""
    normal = place[:3]
    if not dot(thrust, normal) > weight:
        return False
    state = ship.surface_contact_state
    if dot(ship.velocity, normal) > 0:
        ship.touched = False
    if state == LANDED or state == TIPPED:
        ship.surface_contact_state = FLYING
        ship.impact_speed = 0.0
        ship.touched = False
    return True


def fly_substep(ship: Ship, world: World, step: BodyStep, acting: Acting, dt: float) -> str:
    """Steps 5 to 9 in the air."""
    place, axes, torque, thrust, mass, factor = acting
    body_axes, body_end_axes, _ = step
    end_place = fly(ship, place, thrust, mass, dt)  # 5
    if torque is not NOTHING:
        spin_by_torque(ship, torque, axes, dt / factor)  # 6
    turn_by_spin(ship, 0.5 * dt)
    end_penetration = penetration_of(ship, world, body_end_axes, end_place)
    if not end_penetration > 0:
        return ""
    start_penetration = penetration_of(ship, world, body_axes, place)
    ground = ground_of(ship, world, body_end_axes, end_place, end_penetration)
    over = over_ground(ship, ground)
    return touch_or_crash(ship, world.config, ground, over[0], (end_penetration - start_penetration, dt))  # 9


def ground_substep(ship: Ship, world: World, step: BodyStep, acting: Acting, dt: float) -> str:
    """Steps 3 to 9 in contact or tipped."""
    place, axes, torque, thrust, mass, factor = acting
    body_axes, body_end_axes, body_turn = step
    config = world.config
    weight = mass * place[4]
    ground = standing_ground(ship, body_axes)
    penetration = ground[0] if ground else penetration_of(ship, world, body_axes, place)
    force = 0.0
    pinned = False
    if penetration > 0:
        ground = ground or ground_of(ship, world, body_axes, place, penetration)
        pinned, force = press(ship, world, (mass, weight, dt), thrust, (place, ground))  # 3, 4, 5
        torque = add(torque, ground_torque(ship, config, axes, (place, ground), (force, weight, factor)))  # 6
    else:
        no_ground = (penetration, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0)
        accelerate(ship, weight, dt / mass, (0.0, NOTHING, thrust), (place, no_ground))  # 5
        move(ship, dt)
    spin_by_torque(ship, torque, axes, dt / factor)
    turn_by_spin(ship, 0.5 * dt)
    if pinned:
        turn_place_with_ground(ship, body_turn)  # 8
    end_place = place_of(ship.position, ship.body.mu)
    end_penetration = penetration_of(ship, world, body_end_axes, end_place)
    end_ground = ground_of(ship, world, body_end_axes, end_place, end_penetration)
    ship.standing = (ship.position, body_end_axes, end_place, end_ground)
    over = over_ground(ship, end_ground)
    up = up_of(ship.attitude)
    if ship.surface_contact_state == TIPPED:
        up = rest_on_side(ship, end_ground[1:4], up, dt)  # 8
    end = End(end_place, end_ground, over, up, mass, thrust)
    return leave_or_change(ship, config, end, (end_penetration - penetration, dt))  # 9


def standing_ground(ship: Ship, body_axes: Mat3) -> Ground | None:
    standing = ship.standing
    if standing and standing[0] is ship.position and standing[1] is body_axes:
        return standing[3]
    return None


def press(
    ship: Ship, world: World, masses: tuple[float, float, float], thrust: Vec3, where: tuple[Place, Ground]
) -> tuple[bool, float]:
    """Steps 3 to 5 of a ship in the ground: whether it is pinned, and the normal force."""
    config = world.config
    mass, weight, dt = masses
    place, ground = where
    over = over_ground(ship, ground)
    load, depth = depth_of(mass, weight, thrust, ground)
    along = along_ground(weight, thrust, ground)
    if ship.surface_contact_state == TIPPED and is_nearly_at_rest(config, ground, over, depth):
        most = config.contact_friction_static * load
        if dot(along, along) <= most * most:
            return True, load
    force = spring_force(ship, config, mass, ground, over[0])
    rubbing = NOTHING
    if force > 0:
        rubbing = friction(ship, config, (mass / dt, 0.5 * mass), (force, along), ground, over)
    accelerate(ship, weight, dt / mass, (force, rubbing, thrust), where)
    if settles_without_bounce(ship, config) and dot(thrust, place[:3]) <= weight:
        cap_rise(ship, ground, depth, dt)
    move(ship, dt)
    return False, force
