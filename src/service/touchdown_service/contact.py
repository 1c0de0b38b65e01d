"""One substep of one ship, in the order of DYNAMICS; every sum in the order of ORDER."""

from .law.actuators import actuate
from .law.flight import fly
from .law.forces import accelerate, cap_rise, friction, is_nearly_at_rest, load_of, move, spring_force
from .law.moments import ground_torque
from .law.pose import spin_by_torque, turn_attitude_with_ground, turn_by_spin, turn_place_with_ground
from .law.rest import rest_on_side
from .law.surface import Ground, OverGround, Place, ground_of, over_ground, penetration_of, place_of
from .law.transitions import leave_or_change, touch_or_crash
from .law.vectors import NOTHING, Mat3, Quat, Vec3, add, axes_of, dot, up_of
from .models import FLYING, LANDED, TIPPED, BodyStep, Ship, World

NO_AXES: Mat3 = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)

# The actuators' results in a substep: place at its start, the ship's axes, torque (body axes), thrust (ICRF), mass and
# the factor of inertia from before the burn.
Acting = tuple[Place, Mat3, Vec3, Vec3, float, float]
# A ship's place, the ground below it, and its velocity over the ground.
Where = tuple[Place, Ground, OverGround]


def substep(ship: Ship, world: World, step: BodyStep, dt: float) -> str:
    """Advances the ship by dt; `step` has the body's attitudes. Returns the event's name, or ''."""
    if ship.crashed:  # 0
        return ""
    state = ship.surface_contact_state
    controls = ship.controls
    if state == LANDED and not controls.pushes:  # 1, 2: without thrust there is no lift
        return stay_landed(ship, step[2])
    ended = ship.ended
    if ended and ended[0] is ship.position:
        place = ended[1]
    else:
        place = place_of(ship.position, ship.body.mu)
    cls = ship.ship_class
    mass = cls.dry_mass + ship.fuel
    if not controls.is_active:
        if state == FLYING:
            return fly_substep(ship, world, step, (place, NO_AXES, NOTHING, NOTHING, mass, 1.0), dt)
        factor = cls.inertia_at_dry + cls.inertia_per_fuel * ship.fuel
        return ground_substep(ship, world, step, (place, axes_of(ship.attitude), NOTHING, NOTHING, mass, factor), dt)
    factor = cls.inertia_at_dry + cls.inertia_per_fuel * ship.fuel
    axes = axes_of(ship.attitude)
    torque, thrust = actuate(ship, axes, place, factor, dt)  # 1
    if thrust is not NOTHING and is_lifted(ship, thrust, place, mass * place[4]):
        state = ship.surface_contact_state  # 2
    if state == LANDED:
        return stay_landed(ship, step[2])
    acting = (place, axes, torque, thrust, mass, factor)
    if state == FLYING:
        return fly_substep(ship, world, step, acting, dt)
    return ground_substep(ship, world, step, acting, dt)


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
    end_place = fly(ship, place, thrust, mass, dt)  # 5
    ship.ended = (ship.position, end_place)
    if torque is not NOTHING:
        spin_by_torque(ship, torque, axes, dt / factor)  # 6
    turn_by_spin(ship, 0.5 * dt)
    if end_place[3] - ship.ground_contact_offset > ship.body.highest_ground:
        return ""
    body_axes, body_end_axes, _ = step
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
    _, body_end_axes, body_turn = step
    where = ground_at_start(ship, world, step[0], place)
    penetration = where[1][0]
    weight = mass * place[4]
    pinned = False
    if penetration > 0:
        pinned, force = move_on_ground(ship, world, (mass, weight, dt), thrust, where)  # 3, 4, 5
        moment = ground_torque(ship, world.config, axes, where, (force, weight, factor))
        torque = moment if torque is NOTHING else add(torque, moment)  # 6
    else:
        accelerate(ship, weight, dt / mass, (0.0, NOTHING, thrust), where)  # 5
        move(ship, dt)
    spin_by_torque(ship, torque, axes, dt / factor)
    turn_by_spin(ship, 0.5 * dt)
    if pinned:
        turn_place_with_ground(ship, body_turn)  # 8
    end_place = place_of(ship.position, ship.body.mu)
    end_penetration = penetration_of(ship, world, body_end_axes, end_place)
    end_ground = ground_of(ship, world, body_end_axes, end_place, end_penetration)
    over = over_ground(ship, end_ground)
    ship.ended = (ship.position, end_place, ship.velocity, body_end_axes, end_ground, over)
    up = up_of(ship.attitude)
    if ship.surface_contact_state == TIPPED:
        up = rest_on_side(ship, end_ground[1:4], up, dt)  # 8
    end = (end_place, end_ground, over, up, mass, thrust)
    return leave_or_change(ship, world.config, end, (end_penetration - penetration, dt))  # 9


def ground_at_start(ship: Ship, world: World, body_axes: Mat3, place: Place) -> Where:
    """A substep begins with the numbers on which the last one ended, unless something else has moved the ship."""
    ended = ship.ended
    if ended and len(ended) > 2 and ended[0] is ship.position and ended[2] is ship.velocity and ended[3] == body_axes:
        return place, ended[4], ended[5]
    ground = ground_of(ship, world, body_axes, place, penetration_of(ship, world, body_axes, place))
    return place, ground, over_ground(ship, ground)


def move_on_ground(
    ship: Ship, world: World, masses: tuple[float, float, float], thrust: Vec3, where: Where
) -> tuple[bool, float]:
    """Steps 3 to 5 of a ship in the ground: whether it is pinned, and the normal force."""
    config = world.config
    mass, weight, dt = masses
    place, ground, over = where
    tipped = ship.surface_contact_state == TIPPED
    load, depth, along = load_of(mass, weight, thrust, ground)
    if tipped and is_nearly_at_rest(config, ground, over, depth):
        max_friction = config.contact_friction_static * load
        if dot(along, along) <= max_friction * max_friction:
            return True, load
    settles = tipped or ship.impact_speed <= config.contact_bounce_speed
    force = spring_force(config, mass, ground, over[0], settles)
    friction_force = friction(ship, config, (mass / dt, 0.5 * mass), (force, along), where) if force > 0 else NOTHING
    accelerate(ship, weight, dt / mass, (force, friction_force, thrust), where)
    if settles and (thrust is NOTHING or dot(thrust, place[:3]) <= weight):
        cap_rise(ship, ground, depth, dt)
    move(ship, dt)
    return False, force
