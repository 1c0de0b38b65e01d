"""Reads clock, ships, maneuvers and queued inputs from Redis; checks them like any other input."""

import re
from typing import Any

from ..config import TICK_RATE, TIME_SCALE
from ..maneuver_landing import PHASES, Landing
from ..models import Ship
from ..runtime.galaxy import Galaxy, Tempo
from ..validation.limits import (
    SPEED,
    Refusal,
    boolean,
    listed,
    mapping,
    number,
    one_of,
    parse_json,
    required,
    shown,
    text,
    whole,
)
from .records import from_hash, input_of_record, ship_of_record

CLOCK = "touchdown:clock"
# Ships of a system.
MAX_SHIPS = 10_000
ENTRY_ID = re.compile(r"[0-9]{1,16}-[0-9]{1,16}")


def load_clock(galaxy: Galaxy, clock: dict[str, str]) -> None:
    data = from_hash({name: value for name, value in clock.items() if name not in ("cursor", "commit")}, CLOCK)
    mapping(data, CLOCK)
    galaxy.tick = whole(required(data, "tick", CLOCK), f"{CLOCK}.tick")
    galaxy.game_time = number(required(data, "game_time", CLOCK), f"{CLOCK}.game_time")
    galaxy.cursor = required(clock, "cursor", CLOCK)
    if not ENTRY_ID.fullmatch(galaxy.cursor):
        raise Refusal(f"{CLOCK}.cursor: expected a stream ID, got {shown(galaxy.cursor)}")
    galaxy.tempo = Tempo(
        number(required(data, "tick_rate", CLOCK), f"{CLOCK}.tick_rate", TICK_RATE),
        number(required(data, "time_scale", CLOCK), f"{CLOCK}.time_scale", TIME_SCALE),
        boolean(required(data, "paused", CLOCK), f"{CLOCK}.paused"),
        number(required(data, "requested_scale", CLOCK), f"{CLOCK}.requested_scale", TIME_SCALE),
        boolean(required(data, "time_sync", CLOCK), f"{CLOCK}.time_sync"),
    )


def load_landing(fields: dict[str, str], path: str) -> Landing:
    """Raises Refusal with the invalid field below `path`."""
    ticks = [whole(fields.get(name, "0"), f"{path}.{name}") for name in ("started_tick", "updated_tick")]
    data = from_hash({"touch_speed": fields.get("touch_speed", "0")}, path)
    touch_speed = number(data["touch_speed"], f"{path}.touch_speed", SPEED)
    phase = one_of(fields.get("phase"), f"{path}.phase", PHASES)
    reason = text(fields.get("reason", ""), f"{path}.reason", may_be_empty=True)
    return Landing(phase, reason, *ticks, touch_speed)


def landing_values(landing: Landing) -> tuple:
    ticks = landing.started_tick, landing.updated_tick
    return ("landing", landing.phase, landing.reason, *ticks, repr(landing.touch_speed))


def ship_of_hash(galaxy: Galaxy, ship_id: str, record: Any) -> Ship:
    path = f"ship:{ship_id}"
    if not isinstance(record, dict) or not record:
        raise Refusal(f"{path}: expected a hash")
    ship = ship_of_record(from_hash(record, path), galaxy.classes, galaxy.world.bodies, path)
    if ship.ship_id != ship_id:
        raise Refusal(f"{path}.ship_id: expected {ship_id}, got {shown(ship.ship_id)}")
    return ship


def load_pending(galaxy: Galaxy, given: Any, path: str) -> None:
    """Raises Refusal with the first invalid input; ships before it keep their inputs."""
    for ship_id, inputs in mapping(parse_json(given, path), path).items():
        if ship_id in galaxy.ships:
            at = f"{path}.{ship_id}"
            galaxy.ships[ship_id].pending = [input_of_record(one, at) for one in listed(inputs, at)]
