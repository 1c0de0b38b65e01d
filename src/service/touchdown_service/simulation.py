"""Simulates one tick of the world: bodies, ships, inputs, events."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from math import inf

from .config import Timing
from .contact import substep
from .law.vectors import add, axes_of, dot, scale, small_rotation, subtract, turned
from .models import FLYING, Applied, Body, BodyStep, Change, Event, Input, Ship, World

AfterSubstep = Callable[[Ship, int, str], None]

# Number of substeps run ship by ship; bounds the memory of a tick of 100,000 substeps.
BLOCK = 1000


@dataclass(slots=True)
class TickResult:
    """The results of a tick, each list in order."""

    events: list[Event] = field(default_factory=list)
    changes: list[Change] = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class Span:
    """Consecutive substeps of a tick from `first` on, with the reference body's attitude in each."""

    tick: int
    first: int
    dt: float
    # When the tick's end is due, wall s by the clock of Input.arrived.
    due: float
    steps: list[BodyStep]


def run_tick(
    world: World,
    ships: list[Ship],
    timing: Timing,
    tick: int,
    due: float = 0.0,
    after_substep: AfterSubstep | None = None,
) -> TickResult:
    """Moves the world from boundary `tick` to the next.

    Ships do not touch one another, so each runs through all its substeps at once. `after_substep(ship, substep, event)`
    sees every substep.
    """
    for ship in ships:
        choose_reference_body(ship, world.bodies)
    result = TickResult()
    for first in range(0, timing.substeps, BLOCK):
        count = min(BLOCK, timing.substeps - first)
        steps = {body.name: turn_body(body, timing.dt, count) for body in world.bodies}
        for ship in ships:
            span = Span(tick, first, timing.dt, due, steps[ship.body.name])
            run_ship(ship, world, span, result, after_substep)
    for body in world.bodies:
        body.position = add(body.position, scale(body.velocity, timing.tick_seconds))
    # A stable sort keeps the order of ships within a substep.
    result.events.sort(key=lambda event: event.substep)
    result.changes.sort(key=lambda change: change.substep)
    return result


def run_ship(ship: Ship, world: World, span: Span, result: TickResult, after_substep: AfterSubstep | None) -> None:
    """Simulates one ship over consecutive substeps of a tick."""
    tick, dt = span.tick, span.dt
    pending = ship.pending
    for s, step in enumerate(span.steps, span.first):
        while pending and (pending[0].tick, pending[0].substep) <= (tick, s):
            if apply_input(ship, pending.pop(0), (tick, s), span.due):
                result.changes.append(Change(tick, s, ship, ship.controls))
        event = substep(ship, world, step, dt)
        if event:
            result.events.append(event_of(ship, event, tick, s))
        if after_substep:
            after_substep(ship, s, event)


def event_of(ship: Ship, type: str, tick: int, s: int) -> Event:
    again = False
    if type == "ship.contact":
        again = ship.touched
        ship.touched = True
    elif type == "ship.landed":
        ship.touched = False
    return Event(tick, s, type, ship, ship.body.name, again, ship.impact_speed)


def apply_input(ship: Ship, given: Input, at: tuple[int, int], due: float) -> bool:
    """Applies an input unless one with a higher sequence number was applied before; returns whether it did."""
    last = ship.applied
    if given.seq and last and last.session == given.session and given.seq <= last.seq:
        return False
    ship.controls = replace(ship.controls, **given.change)
    if given.seq:
        ship.applied = Applied(given.session, given.seq, *at, due - given.arrived)
    return True


def turn_body(body: Body, dt: float, substeps: int) -> list[BodyStep]:
    """Step 7 for several substeps: turns the body and returns its attitude in each."""
    half_turn = scale(body.angular_velocity, 0.5 * dt)
    turn = small_rotation(half_turn)
    attitude = body.attitude
    axes = axes_of(attitude)
    steps = []
    for _ in range(substeps):
        attitude = turned(attitude, half_turn)
        end_axes = axes_of(attitude)
        steps.append((axes, end_axes, turn))
        axes = end_axes
    body.attitude = attitude
    return steps


def choose_reference_body(ship: Ship, bodies: list[Body]) -> None:
    """Makes the body with the smallest distance / radius a flying ship's reference body (DYNAMICS, Frame)."""
    if ship.surface_contact_state != FLYING or ship.crashed:
        return
    now = ship.body
    least = inf
    best = now
    for body in bodies:
        apart = add(subtract(now.position, body.position), ship.position)
        measure = dot(apart, apart) / (body.radius * body.radius)
        if measure < least:
            least, best = measure, body
    if best is now:
        return
    ship.position = add(subtract(now.position, best.position), ship.position)
    ship.velocity = add(subtract(now.velocity, best.velocity), ship.velocity)
    ship.body = best
