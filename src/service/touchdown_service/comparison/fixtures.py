"""Writes every scenario as a trajectory for comparison with other implementations.

    python3 -m touchdown_service.comparison.fixtures SCENARIOS FOLDER

SCENARIOS is a file like test/service/scenarios.json. The format is that of test/parity/fixtures/README.md;
`npm run parity -- test/service/fixtures/*.json` replays the files.
"""

import json
import sys
from math import ceil
from pathlib import Path
from typing import Any

from ..law.vectors import add
from ..models import Ship
from ..simulation import run_tick
from .cases import load_case

# Approximate number of states per fixture, so that files stay readable.
STATES = 60


def fixture(data: dict[str, Any]) -> dict[str, Any]:
    """A scenario played to its end."""
    case = load_case(data)
    body = case.ship.body
    timing = case.timing
    every = ceil(case.ticks / STATES)
    initial = state(case.ship, 0)
    states = []
    events = []
    for tick in range(case.ticks):
        for event in run_tick(case.world, [case.ship], case.timing, tick).events:
            events.append({"tick": tick + 1, "event": event.type})
        if (tick + 1) % every == 0 or tick + 1 == case.ticks:
            states.append(state(case.ship, tick + 1))
    if case.ship.body is not body:
        raise ValueError(f"{case.name}: a fixture has one body")
    return {
        "name": data["name"],
        "about": data["about"],
        "tick_seconds": timing.tick_seconds,
        "substeps_per_tick": timing.substeps,
        "terrain": data["terrain"],
        "config": data["settings"],
        "ship_class": data["ship_class"],
        "body": data["bodies"][0],
        "initial": initial,
        "inputs": [
            {"tick": given["tick"], "substep": given["substep"], **given["controls"]} for given in data["inputs"]
        ],
        "states": states,
        "events": events,
    }


def state(ship: Ship, tick: int) -> dict[str, Any]:
    return {
        "tick": tick,
        "relative_position": ship.position,
        "relative_velocity": ship.velocity,
        "position": add(ship.body.position, ship.position),
        "velocity": add(ship.body.velocity, ship.velocity),
        "attitude": ship.attitude,
        "angular_velocity": ship.angular_velocity,
        "fuel": ship.fuel,
        "wheel_momentum": ship.wheel_momentum,
        "surface_contact_state": ship.surface_contact_state,
        "landed_body_name": ship.landed_body_name,
        "impact_speed": ship.impact_speed,
        "crashed": ship.crashed,
    }


def to_text(data: dict[str, Any]) -> str:
    """JSON with one line per field, state and input, so that a diff shows only what changed."""
    fields = []
    for name, value in data.items():
        if isinstance(value, list) and value:
            items = ",\n".join(f"    {json.dumps(item)}" for item in value)
            fields.append(f'  "{name}": [\n{items}\n  ]')
        else:
            fields.append(f'  "{name}": {json.dumps(value)}')
    return "{\n" + ",\n".join(fields) + "\n}\n"


def main() -> None:
    if len(sys.argv) != 3:
        sys.exit("usage: python3 -m touchdown_service.comparison.fixtures SCENARIOS FOLDER")
    folder = Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    scenarios = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))
    for data in scenarios:
        text = to_text(fixture(data))
        (folder / f"{data['name']}.json").write_text(text, encoding="utf-8", newline="\n")
    print(f"{len(scenarios)} fixtures written to {folder}")


if __name__ == "__main__":
    main()
