"""Cost of the law in Python: microseconds per substep, by the ship's state.

    python3 -m touchdown_service.benchmark [--json]    a table, or one JSON object per line

Each figure is the median of rounds, with the least and the greatest; the least is the one that a busy machine disturbs least.
"""

import json
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from statistics import median
from time import perf_counter

from .config import Config, timing_of_tick
from .ground.terrain import TERRAINS, flat
from .models import CONTACT, FLYING, LANDED, NEUTRAL, TIPPED, Controls, Ship, TerrainHeight, World
from .runtime.galaxy import make_galaxy
from .runtime.spawning import ship_of_order
from .simulation import run_tick
from .storage.records import body_of_record, ship_record, to_hash, to_object, to_texts

SUBSTEPS = 50
ROUNDS = 40
TICK = timing_of_tick(SUBSTEPS * 0.01, 0.01)
BODY = "Luna"
SITE = [0.6, 0.48, 0.64]

# name, place, state, controls
CASES: list[tuple[str, dict, str, Controls]] = [
    ("coasting", {"height": 2000, "velocity": [30, 0, 0]}, FLYING, NEUTRAL),
    ("coasting near ground", {"height": 300, "velocity": [30, 0, 0]}, FLYING, NEUTRAL),
    ("under power", {"height": 300}, FLYING, Controls(thrust_level=0.3, attitude_mode="radial")),
    ("in contact", {"height": -0.016, "velocity": [30, 0, 0]}, CONTACT, NEUTRAL),
    ("held upright", {"height": -0.016, "velocity": [30, 0, 0]}, CONTACT, Controls(attitude_mode="radial")),
    ("tipped", {"height": -0.016, "velocity": [5, 0, 0], "tilt": 88}, TIPPED, NEUTRAL),
    ("landed", {"height": -0.016}, LANDED, NEUTRAL),
]


def main() -> None:
    as_json = "--json" in sys.argv[1:]
    for name, measured in figures():
        middle, least, most = median(measured), min(measured), max(measured)
        if as_json:
            figure = {"name": name, "unit": "us", "median": middle, "min": least, "max": most}
            print(json.dumps({key: round(v, 3) if isinstance(v, float) else v for key, v in figure.items()}))
        else:
            print(f"{name:34} {middle:8.2f} us  ({least:.2f} to {most:.2f})")


def figures():
    definition = json.loads(Path(__file__).with_name("world.json").read_text(encoding="utf-8"))
    for terrain_name, terrain in (("flat", flat), ("hills", rough)):
        for name, place, state, controls in CASES:
            yield f"{name}, {terrain_name}", time_substeps(definition, terrain, Config(), (place, state, controls))
    slopes = Config(surface_normal="terrain")
    place, state, controls = CASES[3][1:]
    yield "in contact, hills, own slope", time_substeps(definition, rough, slopes, (place, state, controls))
    yield "hash and frame of a ship", time_records(definition)


def rough(body_name: str, nx: float, ny: float, nz: float) -> float:
    """The hills away from their level site, which is cheap to look up."""
    return TERRAINS["hills"](body_name, ny, nz, nx)


def ship_at(definition: dict, terrain: TerrainHeight, config: Config, case: tuple) -> tuple[World, Ship]:
    place, state, controls = case
    bodies = [body_of_record(body, "body") for body in definition["bodies"]]
    galaxy = make_galaxy(definition, bodies)
    order = {"ship_id": "bench", "ship_class": "planetary_lander", "body": BODY, "direction": SITE} | place
    ship = ship_of_order(order, galaxy.classes, bodies, terrain)
    ship.surface_contact_state = state
    ship.controls = controls
    # Only the ship's own body: turning the others is a cost shared by all ships.
    return World(config, [ship.body], terrain), ship


def time_substeps(definition: dict, terrain: TerrainHeight, config: Config, case: tuple) -> list[float]:
    world, start = ship_at(definition, terrain, config, case)
    body = replace(start.body)

    def run() -> None:
        world.bodies[0].attitude, world.bodies[0].position = body.attitude, body.position
        run_tick(world, [replace(start, pending=[])], TICK, 0)

    return rounds(run, SUBSTEPS)


def time_records(definition: dict) -> list[float]:
    _, ship = ship_at(definition, flat, Config(), CASES[0][1:])

    def run() -> None:
        for _ in range(SUBSTEPS):
            texts = to_texts(ship_record(ship, "sol"))
            to_hash(texts)
            to_object(texts)

    return rounds(run, SUBSTEPS)


def rounds(run: Callable[[], None], each: int) -> list[float]:
    run()
    measured = []
    for _ in range(ROUNDS):
        started = perf_counter()
        run()
        measured.append(1e6 * (perf_counter() - started) / each)
    return measured


if __name__ == "__main__":
    main()
