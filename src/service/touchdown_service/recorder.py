"""Records a ship of a running service as a trajectory that `npm run parity` replays on the browser's law.

    python3 -m touchdown_service.recorder --redis URL --ship ID --ticks N FILE

Reads touchdown:world and touchdown:frames alone; the service does not notice. A recording is of one body and one tick length: it
ends before N ticks when the ship is gone, goes over to another body, or the tick changes, and says so. The format is that of
test/parity/fixtures/README.md.
"""

import argparse
import json
import sys
from pathlib import Path
from typing import Any

from redis import Redis
from redis.exceptions import RedisError

from .comparison.fixtures import to_text
from .config import load_config, timing_of_tick
from .redis_state import WORLD
from .runtime.galaxy import Tempo
from .storage.frames import FRAMES
from .storage.records import w_last
from .storage.key_types import check_types
from .validation.limits import Refusal, parse_json

# Timeout for the next frame, wall ms: twice the longest interval.
PATIENCE = 20_000
STATE_FIELDS = (
    "relative_position", "relative_velocity", "position", "velocity", "angular_velocity", "fuel", "wheel_momentum",
    "surface_contact_state", "landed_body_name",
)  # fmt: skip
CONTROL_FIELDS = ("thrust_level", "translation_input", "rotation_input", "attitude_hold", "attitude_mode")


class Recording:
    """A trajectory being recorded: takes frames in order until one does not continue it."""

    def __init__(self, ship_id: str, world: dict[str, Any], first: dict[str, Any]) -> None:
        ship = ship_in(first, ship_id)
        if ship is None:
            raise Refusal(f"ship: no ship named {ship_id} at tick {first['tick']}")
        self.ship_id = ship_id
        self.last = first
        self.body = ship["reference_body"]
        self.ended = ""
        classes = {cls["name"]: cls for cls in world["ship_classes"]}
        seconds = Tempo(first["tick_rate"], first["time_scale"]).tick_seconds
        longest = load_config(world.get("settings", {})).contact_longest_substep
        self.data: dict[str, Any] = {
            "name": ship["name"],
            "about": f"Recorded from a running service, from tick {first['tick']} on.",
            "tick_seconds": seconds,
            "substeps_per_tick": timing_of_tick(seconds, longest).substeps,
            "terrain": {"name": world["terrain"]},
            "config": world.get("settings", {}),
            "ship_class": classes[ship["ship_class"]] | {"ground_contact_offset": ship["ground_contact_offset"]},
            "body": body_in(first, self.body),
            "initial": state_of(ship, first["tick"]),
            "inputs": [input_of(ship, first["tick"], 0)],
            "states": [],
            "events": [],
        }

    def take(self, frame: dict[str, Any]) -> bool:
        """Whether the frame continues the last one; if not, the recording ends with a reason."""
        ship = ship_in(frame, self.ship_id)
        tick = frame["tick"]
        if tick == self.last["tick"]:
            return True  # repeated while the world is paused
        if ship is None:
            self.ended = "the ship is gone"
        elif tick != self.last["tick"] + 1:
            self.ended = f"frames are missing after tick {self.last['tick']}"
        elif ship["reference_body"] != self.body:
            self.ended = "another body"
        else:
            self.data["inputs"] += [input_of(i, i["tick"], i["substep"]) for i in self.of_ship(frame["inputs"])]
            self.data["states"].append(state_of(ship, tick))
            self.data["events"] += [{"tick": tick, "event": e["type"]} for e in self.of_ship(frame["events"])]
            if (frame["tick_rate"], frame["time_scale"]) != (self.last["tick_rate"], self.last["time_scale"]):
                self.ended = "another tick"
            self.last = frame
        return self.ended == ""

    def of_ship(self, items: list[dict[str, Any]]) -> list[dict[str, Any]]:
        return [item for item in items if item["ship_id"] == self.ship_id]


def ship_in(frame: dict[str, Any], ship_id: str) -> dict[str, Any] | None:
    return next((ship for ship in frame["ships"] if ship["ship_id"] == ship_id), None)


def body_in(frame: dict[str, Any], name: str) -> dict[str, Any]:
    body = next(body for body in frame["bodies"] if body["name"] == name)
    return body | {"attitude": w_last(body["attitude"], "attitude")}


def state_of(ship: dict[str, Any], tick: int) -> dict[str, Any]:
    state = {"tick": tick} | {name: ship[name] for name in STATE_FIELDS}
    attitude = w_last(ship["attitude"], "attitude")
    return state | {"attitude": attitude, "impact_speed": ship["contact_impact_speed"], "crashed": False}


def input_of(given: dict[str, Any], tick: int, substep: int) -> dict[str, Any]:
    said = {"tick": tick, "substep": substep} | {name: given[name] for name in CONTROL_FIELDS}
    return said | {"target_attitude": w_last(given["target_attitude"], "target_attitude")}


def record(client: Redis, ship_id: str, ticks: int) -> Recording:
    """Waits for the frames of `ticks` intervals from the newest one on. Raises Refusal if there is nothing to record."""
    check_types(client, {WORLD: "string", FRAMES: "stream"})
    definition = client.get(WORLD)
    newest = client.xrevrange(FRAMES, count=1)
    if definition is None or not newest:
        raise Refusal("touchdown:frames: no service has written here")
    cursor, entry = newest[0]
    recording = Recording(ship_id, parse_json(definition, WORLD), parse_json(entry.get("frame"), FRAMES))
    while len(recording.data["states"]) < ticks:
        answer = client.xread({FRAMES: cursor}, block=PATIENCE)
        if not answer:
            recording.ended = "no frame came any more"
            return recording
        for cursor, entry in answer[0][1]:
            if len(recording.data["states"]) >= ticks or not recording.take(parse_json(entry.get("frame"), FRAMES)):
                return recording
    return recording


def main() -> None:
    parser = argparse.ArgumentParser(prog="python3 -m touchdown_service.recorder", description=__doc__.split("\n")[0])
    parser.add_argument("--redis", default="redis://127.0.0.1:6379/0")
    parser.add_argument("--ship", required=True)
    parser.add_argument("--ticks", type=int, default=60)
    parser.add_argument("file", type=Path)
    args = parser.parse_args()
    try:
        client = Redis.from_url(args.redis, decode_responses=True, encoding_errors="replace")
        recording = record(client, args.ship, args.ticks)
    except (Refusal, RedisError) as error:
        sys.exit(f"recorder: {error}")
    args.file.write_text(to_text(recording.data), encoding="utf-8", newline="\n")
    said = f"; ended: {recording.ended}" if recording.ended else ""
    print(f"{len(recording.data['states'])} ticks written to {args.file}{said}")


if __name__ == "__main__":
    main()
