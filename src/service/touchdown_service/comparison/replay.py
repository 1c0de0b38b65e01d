"""Plays cases and prints the result of every substep, so that another implementation can be compared bit by bit.

    python3 -m touchdown_service.comparison.replay < cases.jsonl           one line a case: name, substeps, SHA-256 of all its rows
    python3 -m touchdown_service.comparison.replay --rows < cases.jsonl    one line a row: tick, substep, the row's bytes in hex

A row is the ship after a substep, as little-endian doubles in the columns of src/dynamics/state/layout.ts, then the event's number.
After a tick's last substep comes a row for each body (substep -1): position, velocity, attitude.
"""

import json
import sys
from collections.abc import Callable
from hashlib import sha256
from struct import Struct
from typing import Any

from ..models import ATTITUDE_MODES, SURFACE_CONTACT_STATES, Body, Ship
from ..simulation import run_tick
from .cases import Case, load_case

EVENTS = ("", "ship.contact", "ship.landed", "ship.tipped", "ship.righted", "ship.destroyed")
# The number of an unknown mode is one above the last.
MODE_NUMBERS = {mode: i for i, mode in enumerate(ATTITUDE_MODES)}
SHIP_ROW = Struct("<37d")
BODY_ROW = Struct("<10d")


def ship_row(ship: Ship, case: Case, event: str) -> bytes:
    controls = ship.controls
    return SHIP_ROW.pack(
        *ship.position,
        *ship.velocity,
        *ship.attitude,
        *ship.angular_velocity,
        ship.fuel,
        *ship.wheel_momentum,
        ship.impact_speed,
        SURFACE_CONTACT_STATES.index(ship.surface_contact_state),
        case.world.bodies.index(ship.body),
        ship.crashed,
        0,
        ship.ground_contact_offset,
        controls.thrust_level,
        *controls.translation_input,
        *controls.rotation_input,
        controls.attitude_hold,
        MODE_NUMBERS.get(controls.attitude_mode, len(ATTITUDE_MODES)),
        *controls.target_attitude,
        EVENTS.index(event),
    )


def body_row(body: Body) -> bytes:
    return BODY_ROW.pack(*body.position, *body.velocity, *body.attitude)


def replay(case: Case, take_row: Callable[[int, int, bytes], Any]) -> int:
    """Plays the case from its start; returns the number of substeps."""
    for tick in range(case.ticks):
        run_tick(
            case.world,
            [case.ship],
            case.timing,
            tick,
            after_substep=lambda ship, s, event: take_row(tick, s, ship_row(ship, case, event)),
        )
        for body in case.world.bodies:
            take_row(tick, -1, body_row(body))
    return case.ticks * case.timing.substeps


def main() -> None:
    rows = "--rows" in sys.argv[1:]
    for line in sys.stdin:
        case = load_case(json.loads(line))
        if rows:
            replay(case, lambda tick, s, row: print(tick, s, row.hex()))
            continue
        digest = sha256()
        substeps = replay(case, lambda tick, s, row: digest.update(row))
        print(case.name, substeps, digest.hexdigest(), flush=True)


if __name__ == "__main__":
    main()
