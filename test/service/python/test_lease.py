"""One service at a time, and damaged records in Redis."""

import json
import unittest

from harness import ServiceProcess, frames, lander
from with_service import WithService


class Lease(WithService):
    def test_a_second_service_refuses_to_run(self) -> None:
        second = ServiceProcess(self.redis)
        self.addCleanup(second.close)
        self.assertEqual(second.wait(), 3)
        self.assertIn("another service runs", second.words())
        before = self.tick()
        self.until(lambda: self.tick() > before + 3, "the first goes on")

    def test_one_that_lost_its_lease_writes_nothing_more(self) -> None:
        self.service.signal(19)  # SIGSTOP: it stands for longer than its lease
        self.until(lambda: not self.client.exists("touchdown:lease"), "the lease runs out")
        second = ServiceProcess(self.redis)
        self.addCleanup(second.close)
        at = self.tick()
        self.until(lambda: self.tick() > at + 5, "the second ticks")
        self.service.signal(18)  # SIGCONT
        self.assertEqual(self.service.wait(), 3)
        self.assertIn("lease lost", self.service.words())
        ticks = [frame["tick"] for frame in frames(self.client)]
        self.assertEqual(ticks, list(range(ticks[0], ticks[-1] + 1)))

    def test_a_tick_that_takes_longer_than_the_lease_is_committed(self) -> None:
        # 40 ships, each 10,000 substeps in one tick: some seconds of work, the lease lasts for 0.4.
        pipe = self.client.pipeline()
        self.client.set("game:paused", "true")
        self.until(lambda: self.client.hget("touchdown:clock", "paused") == "true", "it is paused")
        for i in range(40):
            order = json.dumps(lander(f"s{i}", height=50_000))
            pipe.xadd("touchdown:inbox", {"type": "spawn", "data": order})
        pipe.execute()
        self.until(lambda: self.client.scard("system:sol:ships") == 40, "all are there")
        at = self.tick()
        self.client.mset({"game:tick_rate": "1", "game:time_scale": "100", "game:paused": "false"})
        self.until(lambda: self.tick() > at, "the long tick is committed")
        self.assertNotIn("lease lost", self.service.words())

    def test_a_crowd_does_not_cost_the_lease(self) -> None:
        pipe = self.client.pipeline()
        for i in range(600):
            pipe.xadd("touchdown:inbox", {"type": "spawn", "data": json.dumps(lander(f"s{i}", height=50_000))})
        pipe.execute()
        self.until(lambda: self.client.scard("system:sol:ships") == 600, "all are there")
        at = self.tick()
        self.until(lambda: self.tick() > at + 15, "it ticks on")
        self.assertNotIn("lease lost", self.service.words())

    def test_told_to_stop_it_says_where_the_bodies_are_and_gives_the_lease_back(self) -> None:
        self.assertEqual(self.service.terminate(), 0)
        self.assertFalse(self.client.exists("touchdown:lease"))
        self.assertEqual(self.client.hget("body:Luna", "tick"), str(self.tick()))


class Damage(WithService):
    def test_a_ship_that_cannot_be_read_costs_no_other(self) -> None:
        for ship_id in ("s1", "s2"):
            self.send("spawn", **lander(ship_id, height=3000))
        self.service.kill()
        self.client.hset("ship:s1", "attitude", "upright")
        at = self.tick()
        self.service = ServiceProcess(self.redis)
        self.until(lambda: self.tick() > at, "it goes on")
        self.assertEqual([s["ship_id"] for s in frames(self.client)[-1]["ships"]], ["s2"])
        self.assertIn("ship:s1.attitude: expected JSON", self.client.hget("touchdown:status", "refused"))

    def test_each_ship_that_cannot_be_read_is_named_until_the_world_has_none(self) -> None:
        for ship_id in ("s1", "s2"):
            self.send("spawn", **lander(ship_id, height=3000))
        self.service.kill()
        for ship_id in ("s1", "s2"):
            self.client.hset(f"ship:{ship_id}", "attitude", "upright")
        at = self.tick()
        self.service = ServiceProcess(self.redis)
        self.until(lambda: self.tick() > at, "it goes on")
        # A new world in the same Redis, as after a restart without its data.
        self.client.flushall()
        self.until(lambda: 0 < self.tick() < at, "it has begun again")
        named = [self.service.words().count(f"ship:{ship_id}.attitude: expected JSON") for ship_id in ("s1", "s2")]
        self.assertEqual(named, [1, 1], self.service.words())

    def test_a_key_of_another_kind_is_survived(self) -> None:
        for ship_id in ("s1", "s2"):
            self.send("spawn", **lander(ship_id, height=3000))
        self.client.delete("ship:s1")
        self.client.set("ship:s1", "a text")
        at = self.tick()
        self.until(lambda: self.tick() > at + 20, "it ticks on")
        self.assertEqual([s["ship_id"] for s in frames(self.client)[-1]["ships"]], ["s2"])


if __name__ == "__main__":
    unittest.main()
