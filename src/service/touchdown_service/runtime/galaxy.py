"""The service's state between two ticks, and the simulation of one tick."""

from dataclasses import dataclass, field
from typing import Any

from ..config import Timing, load_config, load_timing
from ..ground.terrain import load_ground
from ..maneuver_landing import Landing, abort, continue_landing
from ..models import Body, Change, Event, Ship, ShipClass, World
from ..simulation import run_tick
from ..validation.limits import mapping, number, one_of, required, text
from ..validation.loading import load_ship_class


@dataclass(slots=True)
class Tempo:
    """Tick rate and time scale between two boundaries. `requested_scale` is game:time_scale; time sync varies
    `time_scale` around it."""

    tick_rate: float = 1.0
    time_scale: float = 1.0
    paused: bool = False
    requested_scale: float = 1.0
    time_sync: bool = False

    @property
    def tick_seconds(self) -> float:
        return self.time_scale / self.tick_rate


@dataclass(slots=True)
class Galaxy:
    """Ships by ID, bodies, clock. `definition` is touchdown:world as read."""

    definition: dict[str, Any]
    system_id: str
    epoch: float
    classes: dict[str, ShipClass]
    world: World
    ships: dict[str, Ship] = field(default_factory=dict)
    landings: dict[str, Landing] = field(default_factory=dict)
    tempo: Tempo = field(default_factory=Tempo)
    tick: int = 0
    # Seconds since tick 0.
    game_time: float = 0.0
    # ID of the last inbox entry that was applied.
    cursor: str = "0-0"


@dataclass(slots=True)
class Changes:
    """Changes since the last commit, to be written by the next."""

    events: list[Event] = field(default_factory=list)
    controls: list[Change] = field(default_factory=list)
    # Removed ships, with the reason.
    removed: list[tuple[Ship, str]] = field(default_factory=list)
    results: list[dict[str, Any]] = field(default_factory=list)


def make_galaxy(definition: Any, bodies: list[Body]) -> Galaxy:
    """Raises Refusal with the path of the first invalid field."""
    mapping(definition, "world")
    classes = [
        load_ship_class(given, f"world.ship_classes[{i}]")
        for i, given in enumerate(required(definition, "ship_classes", "world"))
    ]
    terrain_height, highest = load_ground(definition, bodies, "world")
    for body in bodies:
        body.highest_ground = body.radius + highest(body.name)
    world = World(load_config(definition.get("settings", {}), "world.settings"), bodies, terrain_height)
    one_of(definition.get("input_granularity", "substep"), "world.input_granularity", ("substep",))
    return Galaxy(
        definition,
        text(definition.get("system_id", "sol"), "world.system_id"),
        number(definition.get("epoch", 0), "world.epoch"),
        {cls.name: cls for cls in classes},
        world,
    )


def run_interval(galaxy: Galaxy, due: float, changes: Changes) -> None:
    """Simulates from the present boundary to the next, which is due at wall second `due` by Redis's clock."""
    ships = [galaxy.ships[ship_id] for ship_id in sorted(galaxy.ships)]
    fly_landings(galaxy, changes)
    before = {ship_id: galaxy.ships[ship_id].applied for ship_id in galaxy.landings if ship_id in galaxy.ships}
    timing = timing_of(galaxy)
    result = run_tick(galaxy.world, ships, timing, galaxy.tick, due)
    changes.events += result.events
    changes.controls += result.changes
    galaxy.tick += 1
    galaxy.game_time += timing.tick_seconds
    for event in result.events:
        landing = galaxy.landings.get(event.ship.ship_id)
        if event.type == "ship.contact" and landing and not landing.is_over:
            landing.touch_speed = max(landing.touch_speed, event.impact_speed)
    for ship_id, applied in before.items():
        if galaxy.ships[ship_id].applied is not applied:
            end_landing(galaxy, ship_id, "the pilot took the controls")
    for ship in ships:
        if ship.crashed:
            end_landing(galaxy, ship.ship_id, f"crashed on {ship.body.name}")
            remove_ship(galaxy, ship.ship_id, "collision", changes)


def timing_of(galaxy: Galaxy) -> Timing:
    tempo = galaxy.tempo
    return load_timing(tempo.tick_rate, tempo.time_scale, galaxy.world.config.contact_longest_substep)


def fly_landings(galaxy: Galaxy, changes: Changes) -> None:
    for ship_id, landing in galaxy.landings.items():
        if not landing.is_over and ship_id in galaxy.ships:
            ship = galaxy.ships[ship_id]
            ship.controls = continue_landing(landing, ship, galaxy.world)
            changes.controls.append(Change(galaxy.tick, 0, ship, ship.controls))
            landing.updated_tick = galaxy.tick


def end_landing(galaxy: Galaxy, ship_id: str, reason: str) -> None:
    landing = galaxy.landings.get(ship_id)
    if landing and not landing.is_over:
        abort(landing, reason)
        landing.updated_tick = galaxy.tick


def remove_ship(galaxy: Galaxy, ship_id: str, reason: str, changes: Changes) -> None:
    changes.removed.append((galaxy.ships.pop(ship_id), reason))
