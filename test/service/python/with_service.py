"""A test case with a running service and its own Redis."""

import unittest

from harness import RedisServer, ServiceProcess, result_of, send, until


class WithService(unittest.TestCase):
    def setUp(self) -> None:
        self.redis = RedisServer()
        self.addCleanup(self.redis.close)
        self.client = self.redis.client()
        self.client.mset({"game:tick_rate": "50", "game:time_scale": "1"})
        self.service = ServiceProcess(self.redis)
        self.addCleanup(lambda: self.service.close())
        self.until(lambda: self.tick() > 0, "a tick is committed")

    def until(self, condition, what):
        return until(condition, what, self.service)

    def tick(self) -> int:
        return int(self.client.get("game:tick") or 0)

    def send(self, type: str, **data) -> dict:
        entry = send(self.client, type, **data)
        return self.until(lambda: result_of(self.client, entry), f"{type} has a result")

    def state(self, ship_id: str = "s1") -> str:
        return self.client.hget(f"ship:{ship_id}", "surface_contact_state")
