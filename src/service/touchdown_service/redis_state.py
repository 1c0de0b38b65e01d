"""The world in Redis: read completely at start, then written in one transaction per tick (REDIS.md)."""

import json
from dataclasses import dataclass, field
from datetime import datetime, timedelta, timezone
from secrets import token_hex
from typing import Any

from redis import Redis
from redis.client import Pipeline
from redis.exceptions import RedisError, WatchError

from .runtime import lease as lease_key
from .runtime.galaxy import Changes, Galaxy, make_galaxy
from .runtime.lease import Lease, LeaseLost
from .runtime.tempo import MAX_REQUEST
from .storage.frames import event_record, ship_in_frame, write_events, write_frame
from .storage.key_types import STATUS, check_written
from .storage.records import body_of_record, body_record, input_record, ship_record, to_hash, to_texts
from .storage.stored import CLOCK, MAX_SHIPS, landing_values, load_clock, load_landing, load_pending, ship_of_hash
from .validation.limits import Refusal, listed, parse_json, required

WORLD, BODIES, PENDING = "touchdown:world", "touchdown:bodies", "touchdown:pending"
INBOX = "touchdown:inbox"
COMPLETED = "tick_completed"
REQUESTS = ("game:tick_rate", "game:time_scale", "game:paused", "game:time_sync")

# The fields of landing_values.
LANDING_FIELDS = ("type", "phase", "reason", "started_tick", "updated_tick", "touch_speed")

# Ticks between writes of the body hashes, as in the game (REDIS_WRITE_INTERVAL).
BODY_INTERVAL = 10
INBOX_COUNT = 5000
# Time for which the maneuver of a destroyed ship stays readable, s.
MANEUVER_SECONDS = 60


@dataclass(slots=True)
class Requests:
    """Values of game:* and inbox entries at a boundary, unchecked."""

    values: dict[str, str | None]
    entries: list[tuple[str, dict[str, str]]] = field(default_factory=list)
    refusals: list[str] = field(default_factory=list)


class RedisState:
    def __init__(self, client: Redis, lease: Lease) -> None:
        self.client = client
        self.lease = lease
        # Values already in Redis, which are not written again.
        self.pending_text = ""
        self.landings: dict[str, tuple] = {}
        self.members: set[str] = set()
        # Marker of the last transaction read or written; any other value means that another service wrote.
        self.commit_id: str | None = None
        # Why parts of the world were left out when it was loaded last.
        self.refusals: list[str] = []

    def create(self, definition: dict[str, Any]) -> None:
        """Creates the world if there is none; its bodies are the state at tick 0."""
        bodies = [body_of_record(b, f"bodies[{i}]") for i, b in enumerate(required(definition, "bodies", ""))]
        kept = {name: value for name, value in definition.items() if name != "bodies"}
        make_galaxy(kept, bodies)
        pipe = self.client.pipeline(transaction=True)
        pipe.set(WORLD, json.dumps(kept))
        pipe.set(BODIES, json.dumps([body_record(body) for body in bodies]))
        pipe.execute()

    def load(self) -> Galaxy | None:
        """The world at the last committed tick, or None without one. Raises Refusal if it is invalid."""
        self.refusals = []
        pipe = self.client.pipeline(transaction=True)
        pipe.get(WORLD).get(BODIES).hgetall(CLOCK).get(PENDING)
        definition, bodies, clock, pending = pipe.execute(raise_on_error=False)
        if definition is None and bodies is None:
            return None
        records = listed(parse_json(bodies, BODIES), BODIES)
        galaxy = make_galaxy(
            parse_json(definition, WORLD), [body_of_record(b, f"{BODIES}[{i}]") for i, b in enumerate(records)]
        )
        if not isinstance(clock, dict):
            raise Refusal(f"{CLOCK}: expected a hash")
        check_written(self.client, galaxy)
        self.commit_id = clock.get("commit")
        if clock:
            load_clock(galaxy, clock)
        self.load_ships(galaxy)
        self.pending_text = pending if isinstance(pending, str) else ""
        try:
            load_pending(galaxy, "{}" if pending is None else pending, PENDING)
        except Refusal as refusal:
            # Invalid scheduled inputs must not prevent the world from loading.
            self.refusals.append(str(refusal))
        return galaxy

    def load_ships(self, galaxy: Galaxy) -> None:
        """Leaves an invalid ship out of the simulation but keeps it in Redis; the others continue."""
        key = f"system:{galaxy.system_id}:ships"
        count = self.client.scard(key)
        if count > MAX_SHIPS:
            raise Refusal(f"{key}: expected at most {MAX_SHIPS} ships, got {count}")
        self.members = set(self.client.smembers(key))
        self.landings = {}
        for ship_id in sorted(self.members):
            pipe = self.client.pipeline(transaction=True)
            pipe.hgetall(f"ship:{ship_id}").hgetall(f"maneuver:{ship_id}")
            record, maneuver = pipe.execute(raise_on_error=False)
            try:
                galaxy.ships[ship_id] = ship_of_hash(galaxy, ship_id, record)
                if not isinstance(maneuver, dict):
                    raise Refusal(f"maneuver:{ship_id}: expected a hash")
                if maneuver.get("type") == "landing":
                    galaxy.landings[ship_id] = landing = load_landing(maneuver, f"maneuver:{ship_id}")
                    self.landings[ship_id] = landing_values(landing)
            except Refusal as refusal:
                self.refusals.append(str(refusal))

    def read_requests(self, cursor: str) -> Requests:
        pipe = self.client.pipeline(transaction=False)
        for key in REQUESTS:
            # One byte more than a request may have: the rest of the key is not read.
            pipe.exists(key).getrange(key, 0, MAX_REQUEST)
        pipe.xrange(INBOX, f"({cursor}", "+", INBOX_COUNT)
        answers = pipe.execute(raise_on_error=False)
        for answer in answers:
            if isinstance(answer, RedisError) and not str(answer).startswith("WRONGTYPE"):
                raise answer
        *found, entries = answers
        values = {
            key: value if exists and isinstance(value, str) else None
            for key, exists, value in zip(REQUESTS, found[::2], found[1::2])
        }
        if isinstance(entries, RedisError):
            return Requests(values, refusals=[f"{INBOX}: expected a stream"])
        return Requests(values, entries)

    def commit(self, galaxy: Galaxy, changes: Changes, due: float, requests: Requests, status: dict[str, Any]) -> None:
        """Writes all of a tick or nothing. Raises LeaseLost if another service may have written meanwhile."""
        pipe = self.client.pipeline(transaction=True)
        try:
            # The lease is not watched: its renewal or expiry during a long transaction would abort it.
            pipe.watch(CLOCK)
            holder, commit = pipe.get(lease_key.KEY), pipe.hget(CLOCK, "commit")
            if holder not in (None, self.lease.token) or commit != self.commit_id:
                raise LeaseLost(self.lease.token)
            self.commit_id = token_hex(8)
            pipe.multi()
            ships = self.write_ships(pipe, galaxy, changes)
            self.write_clock(pipe, galaxy, requests)
            self.write_bodies(pipe, galaxy)
            self.write_landings(pipe, galaxy, changes)
            events = [event_record(event) for event in changes.events]
            write_events(pipe, changes.events, events)
            write_frame(pipe, galaxy, changes, due, ships, events)
            if requests.entries:
                ms, number_in_ms = galaxy.cursor.split("-")
                pipe.xtrim(INBOX, minid=f"{ms}-{int(number_in_ms) + 1}", approximate=False)
            pipe.hset(STATUS, mapping=status)
            pipe.set(lease_key.KEY, self.lease.token, px=self.lease.milliseconds)
            pipe.publish(COMPLETED, json.dumps({"tick": galaxy.tick}))
            pipe.execute()
        except WatchError:
            raise LeaseLost(self.lease.token) from None
        finally:
            pipe.reset()

    def write_ships(self, pipe: Pipeline, galaxy: Galaxy, changes: Changes) -> list[str]:
        """Writes the ships' hashes; returns the same data as JSON objects."""
        members = f"system:{galaxy.system_id}:ships"
        ships = []
        for ship_id in sorted(galaxy.ships):
            ship = galaxy.ships[ship_id]
            texts = to_texts(ship_record(ship, galaxy.system_id))
            ships.append(ship_in_frame(ship, texts))
            pipe.execute_command("HSET", f"ship:{ship_id}", *to_hash(texts))
        gone = {ship.ship_id for ship, _ in changes.removed} - set(galaxy.ships)
        if gone:
            pipe.delete(*(f"ship:{ship_id}" for ship_id in gone))
            pipe.srem(members, *gone)
        new = set(galaxy.ships) - self.members
        if new:
            pipe.sadd(members, *new)
        self.members = (self.members | new) - gone
        return ships

    def write_clock(self, pipe: Pipeline, galaxy: Galaxy, requests: Requests) -> None:
        tempo = galaxy.tempo
        now = datetime.fromtimestamp(0, timezone.utc) + timedelta(seconds=galaxy.epoch + galaxy.game_time)
        pipe.set("game:tick", galaxy.tick)
        pipe.set("game:time", now.isoformat(timespec="microseconds"))
        in_force = (
            repr(tempo.tick_rate),
            repr(tempo.requested_scale),
            json.dumps(tempo.paused),
            json.dumps(tempo.time_sync),
        )
        for key, value in zip(REQUESTS, in_force):
            if requests.values.get(key) is None:
                pipe.set(key, value)
        clock = {
            "tick": galaxy.tick,
            "game_time": repr(galaxy.game_time),
            "tick_rate": repr(tempo.tick_rate),
            "time_scale": repr(tempo.time_scale),
            "requested_scale": repr(tempo.requested_scale),
            "time_sync": json.dumps(tempo.time_sync),
            "paused": json.dumps(tempo.paused),
            "cursor": galaxy.cursor,
            "commit": self.commit_id,
        }
        pipe.hset(CLOCK, mapping=clock)
        waiting = {id: [input_record(i) for i in s.pending] for id, s in galaxy.ships.items() if s.pending}
        text = json.dumps(waiting)
        if text != self.pending_text:
            pipe.set(PENDING, text)
            self.pending_text = text

    def write_bodies(self, pipe: Pipeline, galaxy: Galaxy) -> None:
        records = [body_record(body) for body in galaxy.world.bodies]
        pipe.set(BODIES, json.dumps(records))
        if galaxy.tick % BODY_INTERVAL == 0 or galaxy.tempo.paused:
            write_body_hashes(pipe, galaxy)

    def write_bodies_at_end(self, galaxy: Galaxy) -> None:
        """At shutdown: writes the body hashes of the present tick."""
        self.lease.check()
        pipe = self.client.pipeline(transaction=True)
        write_body_hashes(pipe, galaxy)
        pipe.execute()

    def write_landings(self, pipe: Pipeline, galaxy: Galaxy, changes: Changes) -> None:
        for ship_id, landing in list(galaxy.landings.items()):
            key = f"maneuver:{ship_id}"
            values = landing_values(landing)
            if self.landings.get(ship_id) != values:
                pipe.hset(key, mapping=dict(zip(LANDING_FIELDS, values)))
                pipe.persist(key)
                self.landings[ship_id] = values
            if ship_id not in galaxy.ships:
                pipe.expire(key, MANEUVER_SECONDS)
                del galaxy.landings[ship_id], self.landings[ship_id]


def write_body_hashes(pipe: Pipeline, galaxy: Galaxy) -> None:
    for body in galaxy.world.bodies:
        record = body_record(body) | {"tick": galaxy.tick}
        pipe.execute_command("HSET", f"body:{body.name}", *to_hash(to_texts(record)))
    pipe.sadd(f"system:{galaxy.system_id}:bodies", *(body.name for body in galaxy.world.bodies))
