"""The landing autopilot: brings a ship down from where it is, lets legs and friction do the touchdown, and ends.

The rules of src/scenarios/autopilot: a vertical descent, top up, no faster than half of the engine's reserve can brake. It
completes when the ship has landed; it aborts when the ship has tipped or crashed, when a touch was hard enough to bounce, or when
its engine cannot hold it.
"""

from dataclasses import dataclass
from math import sqrt

from .law.vectors import Vec3, axes_of, cross, dot, rotate_back, scale, subtract, up_of
from .models import CONTACT, LANDED, NEUTRAL, TIPPED, Controls, Ship, World

DESCENT = "descent"
TOUCHDOWN = "touchdown"
COMPLETE = "complete"
ABORTED = "aborted"
PHASES = (DESCENT, TOUCHDOWN, COMPLETE, ABORTED)

# Descent speed in the last metres, below any bounce, m/s.
TOUCH_SPEED = 1.5
# Maximum descent speed, m/s.
MAX_SPEED = 15
# Height below which the ship descends at TOUCH_SPEED, m.
LAST_METRES = 3
# Share of the engine's excess thrust over weight that braking plans with; the rest is reserve for corrections.
BRAKING_SHARE = 0.5
# Maximum planned braking, m/s^2; more would react too late with ticks a second apart.
MAX_BRAKING = 1
# Gain from speed error to acceleration, 1/s.
RESPONSE = 0.5
# Cosine of the tilt above which the engine waits until the ship is upright.
MIN_UPRIGHT = 0.5
# Height of a hop after contact below which the engine stays off, m.
LOW_HOP = 3

# Controls in contact: engine off, rate damping.
HOLD = Controls(attitude_hold=True)


@dataclass(slots=True)
class Landing:
    """A maneuver in progress."""

    phase: str = DESCENT
    reason: str = ""
    started_tick: int = 0
    updated_tick: int = 0
    # Largest impact speed since the start, m/s; a bounce may begin and end between two steps.
    touch_speed: float = 0.0

    @property
    def is_over(self) -> bool:
        return self.phase in (COMPLETE, ABORTED)


def continue_landing(landing: Landing, ship: Ship, world: World) -> Controls:
    """One step: updates the maneuver's phase and returns the controls until the next step."""
    if landing.is_over:
        return ship.controls
    state = ship.surface_contact_state
    if ship.crashed:
        return abort(landing, f"crashed on {ship.body.name}")
    if state == TIPPED:
        return abort(landing, f"tipped over on {ship.body.name}")
    if landing.touch_speed > world.config.contact_bounce_speed:
        return abort(landing, f"hit {ship.body.name} at {landing.touch_speed:.1f} m/s")
    if state == LANDED:
        landing.phase = COMPLETE
        return NEUTRAL
    if state == CONTACT:
        landing.phase = TOUCHDOWN
        return HOLD
    return fly(landing, ship, world)


def abort(landing: Landing, reason: str) -> Controls:
    landing.phase = ABORTED
    landing.reason = reason
    return HOLD


@dataclass(slots=True)
class Approach:
    """A ship's motion relative to the ground: m, m/s, m/s^2."""

    height: float
    # Positive upward.
    climb: float
    # Along the ground, body axes.
    drift: Vec3
    # Cosine of the tilt.
    upright: float
    gravity: float


def approach_of(ship: Ship, world: World) -> Approach:
    body = ship.body
    distance = sqrt(dot(ship.position, ship.position))
    up = scale(ship.position, 1 / distance)
    over_ground = subtract(ship.velocity, cross(body.angular_velocity, ship.position))
    height = world.terrain_height(body.name, *rotate_back(axes_of(body.attitude), up))
    climb = dot(over_ground, up)
    return Approach(
        height=distance - (body.radius + height + ship.ground_contact_offset),
        climb=climb,
        drift=rotate_back(axes_of(ship.attitude), subtract(over_ground, scale(up, climb))),
        upright=dot(up_of(ship.attitude), up),
        gravity=body.mu / (distance * distance),
    )


def fly(landing: Landing, ship: Ship, world: World) -> Controls:
    approach = approach_of(ship, world)
    if landing.phase == TOUCHDOWN and approach.height < LOW_HOP:
        return HOLD
    weight = (ship.ship_class.dry_mass + ship.fuel) * approach.gravity
    thrust = ship.ship_class.main_engine_thrust if ship.fuel > 0 else 0.0
    if not thrust > weight:
        return abort(landing, f"main engine: {thrust:.0f} N cannot hold a weight of {weight:.0f} N")
    landing.phase = DESCENT
    return descend(approach, ship)


def descend(approach: Approach, ship: Ship) -> Controls:
    """Keeps the ship upright, nulls drift with the thrusters, descends no faster than the engine can brake, and thrusts down if
    gravity is too weak."""
    cls = ship.ship_class
    mass = cls.dry_mass + ship.fuel
    reserve = max(0.0, cls.main_engine_thrust / mass - approach.gravity)
    braking = min(MAX_BRAKING, BRAKING_SHARE * reserve)
    to_brake = max(0.0, approach.height - LAST_METRES)
    planned = sqrt(TOUCH_SPEED * TOUCH_SPEED + 2 * braking * to_brake)
    speed = min(planned, MAX_SPEED)
    # Planned deceleration; 0 at the maximum speed and in the last metres.
    on_curve = to_brake > 0 and planned < MAX_SPEED and approach.climb < 0
    easing = braking * -approach.climb / planned if on_curve else 0.0
    wanted = approach.gravity + easing + RESPONSE * (-speed - approach.climb)
    push = mass * wanted / approach.upright if approach.upright > MIN_UPRIGHT else 0.0
    sideways = -RESPONSE * mass
    rcs_x, rcs_y, rcs_z = cls.rcs_thrust
    return Controls(
        thrust_level=share(max(0.0, push), cls.main_engine_thrust),
        translation_input=(
            share(sideways * approach.drift[0], rcs_x),
            share(sideways * approach.drift[1], rcs_y),
            share(min(0.0, push), rcs_z),
        ),
        attitude_hold=True,
        attitude_mode="radial",
    )


def share(force: float, most: float) -> float:
    """`force` / `most`, clamped to -1 to 1; 0 without thrusters."""
    return max(-1.0, min(1.0, force / most)) if most > 0 else 0.0
