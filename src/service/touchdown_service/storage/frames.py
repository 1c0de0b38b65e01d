"""The output of a tick: each event, and the whole world as one frame (REDIS.md)."""

import json
from typing import Any

from redis.client import Pipeline

from ..models import Change, Event, Ship
from ..runtime.galaxy import Changes, Galaxy
from .records import body_record, controls_record, to_object

FRAMES, EVENTS, GALAXY_SHIPS = "touchdown:frames", "touchdown:events", "galaxy:ships"
EVENTS_KEPT = 10_000
GALAXY_EVENTS_KEPT = 100_000
FRAMES_KEPT = 64
# Maximum total size of stored frames, bytes.
FRAME_BYTES = 32 * 2**20


def write_events(pipe: Pipeline, events: list[Event], records: list[dict[str, Any]]) -> None:
    for event, record in zip(events, records):
        kept = {name: value if isinstance(value, str) else json.dumps(value) for name, value in record.items()}
        kept["event"] = kept.pop("type")
        pipe.xadd(EVENTS, kept, maxlen=EVENTS_KEPT)
        if event.again:
            continue
        published = {name: kept[name] for name in ("event", "ship_id", "player_id", "body", "reason") if name in kept}
        pipe.xadd(GALAXY_SHIPS, published, maxlen=GALAXY_EVENTS_KEPT)


def write_frame(
    pipe: Pipeline,
    galaxy: Galaxy,
    changes: Changes,
    due: float,
    ships: list[str],
    events: list[dict[str, Any]],
) -> None:
    """`ships`: each as a JSON object."""
    tempo = galaxy.tempo
    told = json.dumps(
        {
            "tick": galaxy.tick,
            "tick_rate": tempo.tick_rate,
            "time_scale": tempo.time_scale,
            "paused": tempo.paused,
            "game_time": galaxy.game_time,
            "due": due,
            "bodies": [body_record(body) for body in galaxy.world.bodies],
            "events": events,
            "inputs": [change_record(change) for change in changes.controls],
            "removed": [removed_record(ship, reason) for ship, reason in changes.removed],
            "results": changes.results,
        }
    )
    frame = f'{told[:-1]}, "ships": [{", ".join(ships)}]}}'
    kept = max(2, min(FRAMES_KEPT, FRAME_BYTES // len(frame)))
    pipe.xadd(FRAMES, {"tick": galaxy.tick, "frame": frame}, maxlen=kept, approximate=False)


def ship_in_frame(ship: Ship, texts: dict[str, str]) -> str:
    applied = ship.applied
    if applied is None:
        return to_object(texts)
    last = {name: getattr(applied, name) for name in ("session", "seq", "tick", "substep", "margin")}
    return f'{to_object(texts)[:-1]}, "last_input": {json.dumps(last)}}}'


def event_record(event: Event) -> dict[str, Any]:
    ship = event.ship
    record: dict[str, Any] = {
        "type": event.type,
        "ship_id": ship.ship_id,
        "ship_name": ship.name,
        "player_id": ship.player_id,
        "body": event.body,
        "tick": event.tick,
        "substep": event.substep,
    }
    if event.type == "ship.contact":
        record |= {"again": event.again, "impact_speed": event.impact_speed}
    if event.type == "ship.destroyed":
        record["reason"] = "collision"
    return record


def change_record(change: Change) -> dict[str, Any]:
    said = {"ship_id": change.ship.ship_id, "tick": change.tick, "substep": change.substep}
    return said | controls_record(change.controls)


def removed_record(ship: Ship, reason: str) -> dict[str, str]:
    return {"ship_id": ship.ship_id, "player_id": ship.player_id, "name": ship.name, "reason": reason}
