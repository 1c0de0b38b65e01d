"""Whatever Redis holds where the service reads: it is refused by name, and never ends the service with a traceback."""

import json
import logging
import random
import time
import unittest

from harness import SERVICE_HOME, RedisServer, ServiceProcess, control, lander, send, until
from redis import Redis
from touchdown_service.runtime.connection import connect
from touchdown_service.runtime.galaxy import Changes
from touchdown_service.runtime.inbox import HANDLERS, apply_entries
from touchdown_service.runtime.service import Service
from touchdown_service.validation.limits import Refusal

TEXTS = [
    "", "nan", "1e999", "{}", "[]", "null", "true", '"x"', "-1", '{"a":', "[" * 3000, "9" * 5000, "[1,2]", "\ufffd",
    '{"s1":[[1,2]]}', '{"s1":[[0,0,{},"",1,null]]}', '{"s1":5}', "[null]", "[{}]", '{"settings":5}', "x" * 200_000,
]  # fmt: skip
# Unreadable, the world itself is; a ship, its maneuver and its inputs are left out, and the others fly on.
ESSENTIAL = ("touchdown:world", "touchdown:bodies", "touchdown:clock", "system:sol:ships")
USABLE = [("touchdown:bodies", "[]"), ("touchdown:pending", "{}"), ("touchdown:pending", '{"settings":5}')]
DEFINITION = json.loads((SERVICE_HOME / "touchdown_service" / "world.json").read_text(encoding="utf-8"))


class Stored(unittest.TestCase):
    """A world of two ships, one under the autopilot and one with a waiting input, as stored in Redis."""

    @classmethod
    def setUpClass(cls) -> None:
        logging.disable()
        cls.addClassCleanup(logging.disable, logging.NOTSET)
        cls.redis = RedisServer("no")
        cls.addClassCleanup(cls.redis.close)
        cls.client = connect(cls.redis.url)
        cls.raw = Redis(port=cls.redis.port)
        # Two substeps an interval: what is refused does not depend on their number.
        cls.client.set("game:tick_rate", "50")
        service = Service(cls.client, DEFINITION)
        service.lease.take_over()
        galaxy = service.load()
        for ship_id in ("s1", "s2"):
            send(cls.client, "spawn", **lander(ship_id))
        send(cls.client, "maneuver", ship_id="s2", maneuver="landing")
        control(cls.client, 1, {"thrust_level": 0.1}, tick=5)
        service.run_boundary(galaxy, time.monotonic())
        cls.raw.delete("touchdown:lease")
        cls.dumps = {key: cls.raw.dump(key) for key in cls.raw.keys()}

    def setUp(self) -> None:
        self.restore()

    def restore(self) -> None:
        pipe = self.raw.pipeline().flushall()
        for key, dump in self.dumps.items():
            pipe.restore(key, 0, dump)
        pipe.execute()

    def load(self, what: str) -> str:
        """The refusal, of all of it or of a part without effect on the rest; '' for none."""
        service = Service(self.client, DEFINITION)
        try:
            galaxy = service.load()
        except Refusal as refusal:
            known = ("touchdown:", "system:", "world", "galaxy:", "body:")
            self.assertTrue(str(refusal).startswith(known), f"{what}: {refusal}")
            return str(refusal)
        except Exception as error:
            raise AssertionError(f"{what}: {type(error).__name__}: {error}") from error
        with self.subTest(what):
            service.lease.take_over()
            service.run_boundary(galaxy, time.monotonic())
            self.raw.delete("touchdown:lease")
        return "; ".join(service.state.refusals)

    def test_a_text_that_is_none_of_its_own_is_refused(self) -> None:
        for key in ("touchdown:world", "touchdown:bodies", "touchdown:pending"):
            for text in TEXTS:
                self.client.set(key, text)
                refused = self.load(f"{key} = {text[:30]}")
                # A world without bodies is one; so are inputs of no ship, or of one that is gone.
                if (key, text) not in USABLE:
                    self.assertIn(key.split(":")[1], refused, text[:30])
                self.restore()

    def test_a_field_that_is_none_of_its_own_is_refused(self) -> None:
        for key in ("touchdown:clock", "ship:s1", "maneuver:s2"):
            for name in self.client.hkeys(key):
                for text in TEXTS:
                    self.client.hset(key, name, text)
                    self.load(f"{key}.{name} = {text[:30]}")
                    self.restore()
                self.client.hdel(key, name)
                self.load(f"{key} without {name}")
                self.restore()

    def test_a_key_of_another_type_is_refused(self) -> None:
        # The last two come into being later: at a touch, and at the first tenth tick.
        for key in (*(name.decode() for name in self.dumps), "galaxy:ships", "touchdown:events", "body:Luna"):
            for type, put in (("list", self.client.rpush), ("set", self.client.sadd)):
                if self.client.type(key) == type:
                    continue
                self.client.delete(key)
                put(key, "x")
                refused = self.load(f"{key} as a {type}")
                # A tick replaces these, or reads them and reports the type itself.
                if not key.startswith(("game:", "touchdown:inbox")):
                    self.assertTrue(refused.startswith(key), f"{key} as a {type}: {refused}")
                self.restore()

    def test_bytes_that_are_no_text_are_refused(self) -> None:
        raw = self.raw
        for key, field in (("ship:s1", "attitude"), ("maneuver:s2", "phase"), ("touchdown:clock", "game_time")):
            raw.hset(key, field, b"\xff\xfe")
            self.assertIn(f"{key}.{field}", self.load(f"{key}.{field} of bytes"))
            self.restore()
        raw.sadd("system:sol:ships", b"\xff")
        self.assertIn("ship:\ufffd: expected a hash", self.load("a ship named by bytes"))

    def test_more_ships_than_a_world_takes_are_refused(self) -> None:
        self.client.sadd("system:sol:ships", *range(10_000))
        refused = self.load("10,002 ships")
        self.assertEqual(refused, "system:sol:ships: expected at most 10000 ships, got 10002")

    def test_half_a_world_is_refused(self) -> None:
        for key in ("touchdown:world", "touchdown:bodies"):
            self.client.delete(key)
            self.assertIn(key, self.load(f"without {key}"))
            self.restore()

    def test_a_ship_under_another_ones_name_is_left_out(self) -> None:
        self.client.hset("ship:s1", "ship_id", "s2")
        self.assertIn("ship:s1.ship_id: expected s1", self.load("s1 as s2"))

    def test_an_inbox_of_anything_is_taken_in(self) -> None:
        draw = random.Random(7)
        galaxy = Service(self.client, DEFINITION).load()
        orders = [{}, {"height": 1e19}, {"direction": [0, 0, 0]}, {"direction": [1e-300, 0, 0]}, {"tilt": 1e300}]
        told = [json.dumps(lander("s3", **order)) for order in orders]
        told += ['{"ship_id":"s1"}', '{"ship_id":"s1","maneuver":"landing"}', '{"thrust_level":1e400}', "s1", "1"]
        fields = ("ship_id", "player_id", "session", "seq", "tick", "substep", "controls", "data", "other")
        for i in range(5000):
            entry = {name: draw.choice(TEXTS + told) for name in fields if draw.random() < 0.6}
            entry["type"] = draw.choice([*HANDLERS, *TEXTS])
            apply_entries(galaxy, [(f"{i + 1}-0", entry)], Changes())
        self.assertEqual(galaxy.cursor, "5000-0")


class Running(unittest.TestCase):
    def setUp(self) -> None:
        self.redis = RedisServer("no")
        self.addCleanup(self.redis.close)
        self.client = self.redis.client()

    def run_service(self) -> ServiceProcess:
        service = ServiceProcess(self.redis)
        self.addCleanup(service.close)
        return service

    def expect_ticks(self, service: ServiceProcess, what: str) -> None:
        status = Redis(port=self.redis.port, decode_responses=True, encoding_errors="replace")
        tick = int(status.hget("touchdown:status", "tick") or 0)
        until(lambda: int(status.hget("touchdown:status", "tick") or 0) > tick + 3, f"ticks go on: {what}", service)
        self.assertNotIn("Traceback", service.words(), what)

    def test_it_ticks_on_whatever_game_and_inbox_hold(self) -> None:
        self.client.set("game:tick_rate", "50")
        service = self.run_service()
        self.expect_ticks(service, "at the start")
        for key in ("game:tick_rate", "game:time_scale", "game:paused", "game:time_sync"):
            for value in (b"\xff\xfe", b"", b"nan", b"1_0", "٥".encode(), b"[" * 3000):
                self.client.set(key, value)
                self.expect_ticks(service, f"{key} = {value[:10]!r}")
            # In one transaction: the service writes a missing key again.
            self.client.pipeline().delete(key).rpush(key, "x").execute()
            self.expect_ticks(service, f"{key} as a list")
        self.client.xadd("touchdown:inbox", {b"type": b"\xff", b"\xfe": b"\x80"})
        self.expect_ticks(service, "bytes in the inbox")
        self.client.delete("touchdown:inbox")
        self.client.set("touchdown:inbox", "x")
        self.expect_ticks(service, "an inbox that is no stream")
        self.assertEqual(self.client.hget("touchdown:status", "refused"), "touchdown:inbox: expected a stream")
        self.client.delete("touchdown:inbox")
        send(self.client, "spawn", **lander())
        until(lambda: self.client.exists("ship:s1"), "an inbox that is a stream again is read", service)
        self.assertEqual(self.client.get("game:tick_rate"), "50.0")

    def test_a_value_of_many_megabytes_is_refused_by_name_and_not_read(self) -> None:
        self.client.mset({"game:tick_rate": "50", "game:time_scale": "1"})
        service = self.run_service()
        self.expect_ticks(service, "at the start")
        size = 64 << 20
        for key in ("game:tick_rate", "game:time_scale", "game:paused", "game:time_sync"):
            kept = self.client.get(key)
            self.client.execute_command("SETRANGE", key, size - 1, "0")
            refused = f"{key}: expected at most 64 bytes"
            until(lambda: self.client.hget("touchdown:status", "refused") == refused, f"{key} is refused", service)
            sent = self.client.info("stats")["total_net_output_bytes"]
            self.expect_ticks(service, f"{key} of {size} bytes")
            self.assertLess(self.client.info("stats")["total_net_output_bytes"] - sent, size)
            self.client.set(key, kept)
        self.expect_ticks(service, "with the values as before")
        self.assertEqual(self.client.hget("touchdown:clock", "tick_rate"), "50.0")

    def test_a_key_that_takes_another_type_ends_it_by_name_and_mended_it_goes_on(self) -> None:
        raw = Redis(port=self.redis.port)
        self.client.set("game:tick_rate", "50")
        for key in ("touchdown:frames", "touchdown:status", "galaxy:ships", "body:Luna"):
            service = self.run_service()
            self.expect_ticks(service, f"before {key}")
            send(self.client, "respawn", **lander(height=0.1))
            until(lambda: self.client.exists(key), f"{key} is there", service)
            dump = raw.dump(key)
            pipe = self.client.pipeline()
            pipe.delete(key).rpush(key, "x").execute()
            # The next events: galaxy:ships is written only where there are some.
            send(self.client, "respawn", **lander(height=0.1))
            self.assertEqual(service.wait(), 2, service.words())
            said = service.words().splitlines()[-1]
            self.assertRegex(said, f"^touchdown-service: {key}: expected a (stream|hash), got a list$")
            self.assertNotIn("Traceback", service.words())
            tick = int(self.client.get("game:tick"))
            raw.restore(key, 0, dump, replace=True)
            service = self.run_service()
            until(lambda: int(self.client.get("game:tick")) > tick + 3, f"it goes on with {key} mended", service)
            service.terminate()

    def test_a_lease_that_no_service_has_written_is_refused(self) -> None:
        for put in (lambda: self.client.set("touchdown:lease", "x"), lambda: self.client.rpush("touchdown:lease", "x")):
            self.client.delete("touchdown:lease")
            put()
            service = self.run_service()
            self.assertEqual(service.wait(), 2)
            self.assertIn("touchdown-service: touchdown:lease: expected a", service.words())


if __name__ == "__main__":
    unittest.main()
