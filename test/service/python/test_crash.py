"""Killed in mid-bounce, the service continues from Redis, bit for bit: no state or event is lost or sent twice."""

import json
import random
import time
import unittest
from typing import Any

from harness import SERVICE_HOME, RedisServer, ServiceProcess, entries, lander, send, until

from touchdown_service.runtime.galaxy import Changes, make_galaxy, run_interval
from touchdown_service.runtime.inbox import apply_entries
from touchdown_service.storage.records import body_of_record, ship_record, to_texts

WORLD = json.loads((SERVICE_HOME / "touchdown_service" / "world.json").read_text(encoding="utf-8"))
RATE = 100
SCALE = 2
KILLS = 20

SHIPS = [
    lander("bounces", height=60, velocity=[4, 1, -25]),
    lander("slides", height=1, velocity=[20, 0, -3], ship_class="fast_frigate"),
    lander("hops", height=30, velocity=[-3, 2, -30], tilt=20),
    lander("crashes", height=1500, velocity=[0, 0, -49]),
]
# (tick after the spawn, substep, controls) of the ship that hops.
FLOWN = [
    (100, 1, {"attitude_mode": "radial"}),
    (700, 0, {"thrust_level": 1.0, "attitude_mode": "radial"}),
    (730, 1, {"thrust_level": 0.0}),
]
TICKS = 2400
# The tick by which the inputs that lie too far ahead at the start are sent.
LATER = 300


def inputs(start: int) -> list[dict[str, Any]]:
    return [
        {"type": "controls", "ship_id": "hops", "session": "page", "seq": str(i), "tick": str(start + tick),
         "substep": str(substep), "controls": json.dumps(controls)}
        for i, (tick, substep, controls) in enumerate(FLOWN, 1)
    ]  # fmt: skip


def play_here(start: int, ticks: int) -> tuple[dict[str, dict[str, str]], list[tuple]]:
    """The same flight without interruption: the ships' hashes at the end, and all events."""
    galaxy = make_galaxy(WORLD, [body_of_record(body, "body") for body in WORLD["bodies"]])
    galaxy.tempo.tick_rate, galaxy.tempo.time_scale = float(RATE), float(SCALE)
    changes = Changes()
    for _ in range(start):
        run_interval(galaxy, 0.0, changes)
    spawns = [{"type": "spawn", "data": json.dumps(order)} for order in SHIPS]
    early, late = inputs(start)[:1], inputs(start)[1:]
    apply_entries(galaxy, [(f"{i}-1", entry) for i, entry in enumerate(spawns + early, 1)], changes)
    for tick in range(ticks):
        if tick == LATER:
            apply_entries(galaxy, [(f"{i}-2", entry) for i, entry in enumerate(late, 1)], changes)
        run_interval(galaxy, 0.0, changes)
    assert all(result["ok"] for result in changes.results), changes.results
    records = {ship_id: to_texts(ship_record(ship, "sol")) for ship_id, ship in galaxy.ships.items()}
    events = [(e.type, e.ship.ship_id, e.tick, e.substep, e.again) for e in changes.events]
    return records, events


class Killed(unittest.TestCase):
    def setUp(self) -> None:
        self.redis = RedisServer()
        self.addCleanup(self.redis.close)
        self.client = self.redis.client()
        self.client.mset({"game:tick_rate": str(RATE), "game:time_scale": str(SCALE), "game:paused": "true"})
        self.start_service()

    def start_service(self) -> None:
        self.service = ServiceProcess(self.redis)
        self.addCleanup(self.service.close)

    def tick(self) -> int:
        return int(self.client.get("game:tick") or 0)

    def begin(self) -> int:
        """Sends all commands while the world is paused; returns the tick at which it resumes."""
        for order in SHIPS:
            send(self.client, "spawn", **order)
        start = self.tick()
        for entry in inputs(start)[:1]:
            self.client.xadd("touchdown:inbox", entry)
        until(lambda: self.client.scard("system:sol:ships") == len(SHIPS), "all are there", self.service)
        self.client.set("game:paused", "false")
        return start

    def fly(self, start: int, kill) -> None:
        """Runs to the end, with kills spread over the flight; inputs more than ten seconds ahead are sent on the way."""
        dice = random.Random(7)
        at = [start + 20 + int((TICKS - 150) * (i + dice.random()) / KILLS) for i in range(KILLS)]
        late = inputs(start)[1:]
        while self.tick() < start + TICKS:
            if late and self.tick() >= start + LATER:
                for entry in late:
                    self.client.xadd("touchdown:inbox", entry)
                late = []
            if at and self.tick() >= at[0]:
                at.pop(0)
                kill(len(at))
            time.sleep(0.002)

    def check(self, start: int) -> None:
        self.client.set("game:paused", "true")
        until(lambda: self.client.hget("touchdown:clock", "paused") == "true", "it is paused", self.service)
        extra = self.tick() - start - TICKS
        self.assertGreaterEqual(extra, 0)
        records, events = play_here(start, TICKS + extra)
        told = [
            (e["event"], e["ship_id"], int(e["tick"]), int(e["substep"]), e.get("again") == "true")
            for e in entries(self.client, "touchdown:events")
        ]
        self.assertEqual(told, events)
        self.assertGreater(len(events), 9)
        published = [(e["event"], e["ship_id"]) for e in entries(self.client, "galaxy:ships")]
        self.assertEqual(published, [event[:2] for event in events if not event[4]])
        for ship_id, record in records.items():
            held = self.client.hgetall(f"ship:{ship_id}")
            # Wall time, which differs between runs.
            held.pop("input_margin")
            record.pop("input_margin")
            self.assertEqual(
                {name: (held.get(name), value) for name, value in record.items() if held.get(name) != value}, {}
            )
            self.assertEqual(set(held), set(record))
        self.assertEqual(self.client.smembers("system:sol:ships"), set(records))

    def test_the_service_twenty_times(self) -> None:
        start = self.begin()

        def kill(_: int) -> None:
            self.service.kill()
            self.start_service()

        self.fly(start, kill)
        self.check(start)

    def test_redis_and_both_together_twenty_times(self) -> None:
        start = self.begin()

        def kill(left: int) -> None:
            self.redis.kill()
            if left % 2:
                self.service.kill()
            self.redis.start()
            if left % 2:
                self.start_service()

        self.fly(start, kill)
        self.check(start)


if __name__ == "__main__":
    unittest.main()
