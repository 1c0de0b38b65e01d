"""The world loop of the physics service: bodies, ships, inputs due, events."""

from collections.abc import Callable
from dataclasses import dataclass

from .config import Timing
from .contact import substep
from .models import FLYING, Body, Controls, Ship, World
from .vectors import add, axes_of, dot, scale, small_rotation, subtract, turned


@dataclass(slots=True)
class Input:
    """Controls that hold from the start of a substep on."""

    tick: int
    substep: int
    controls: Controls


@dataclass(slots=True)
class Event:
    """What happened in a substep of the interval that begins at `tick`."""

    tick: int
    substep: int
    type: str


def run_tick(
    ship: Ship,
    world: World,
    timing: Timing,
    tick: int,
    inputs: list[Input],
    after_substep: Callable[[int, str], None],
) -> None:
    """One tick of one ship; takes the inputs that are due from the front of `inputs`."""
    choose_reference_body(ship, world.bodies)
    for s in range(timing.substeps):
        while inputs and (inputs[0].tick, inputs[0].substep) <= (tick, s):
            ship.controls = inputs.pop(0).controls
        for body in world.bodies:
            turn_body(body, timing.dt)
        event = substep(ship, world, timing.dt)
        for body in world.bodies:
            body.attitude = body.end_attitude
            body.axes = body.end_axes
        after_substep(s, event)
    for body in world.bodies:
        body.position = add(body.position, scale(body.velocity, timing.tick_seconds))


def turn_body(body: Body, dt: float) -> None:
    """Step 7: where the body's attitude will be at the substep's end."""
    half_turn = scale(body.angular_velocity, 0.5 * dt)
    body.turn = small_rotation(half_turn)
    body.end_attitude = turned(body.attitude, half_turn)
    body.end_axes = axes_of(body.end_attitude)


def choose_reference_body(ship: Ship, bodies: list[Body]) -> None:
    """A flying ship goes over to the body whose gravity is the strongest at the ship (DYNAMICS, Frame)."""
    if ship.surface_contact_state != FLYING or ship.crashed:
        return
    now = ship.body
    strongest = -1.0
    best = now
    for body in bodies:
        apart = add(subtract(now.position, body.position), ship.position)
        gravity = body.mu / dot(apart, apart)
        if gravity > strongest:
            strongest, best = gravity, body
    if best is now:
        return
    ship.position = add(subtract(now.position, best.position), ship.position)
    ship.velocity = add(subtract(now.velocity, best.velocity), ship.velocity)
    ship.body = best
