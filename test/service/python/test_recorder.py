"""A running service's ship becomes a trajectory; test/service/recorder.test.ts replays such a file on the browser's law."""

import json
import tempfile
import unittest
from pathlib import Path

from harness import Program, RedisServer, ServiceProcess, control, lander, result_of, send, until
from touchdown_service.recorder import main


class Recorder(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = Path(folder.name) / "recorded.json"

    def start(self, redis: RedisServer, *options: str) -> Program:
        program = Program(main, "recorder", "--redis", redis.url, *options, str(self.file))
        self.addCleanup(program.close)
        return program

    def refused(self, redis: RedisServer, *options: str) -> str:
        """The message with which it fails."""
        program = self.start(redis, *options)
        self.assertEqual(program.wait(), 1)
        return program.words()

    def test_a_landing_is_recorded_tick_by_tick(self) -> None:
        redis = RedisServer()
        self.addCleanup(redis.close)
        client = redis.client()
        client.mset({"game:tick_rate": "50"})
        self.assertIn("no service has written here", self.refused(redis, "--ship", "s1"))
        service = ServiceProcess(redis)
        self.addCleanup(service.close)
        entry = send(client, "spawn", **lander(height=50, velocity=[3, 0, -12]))
        until(lambda: result_of(client, entry), "it is there", service)
        self.assertIn("ship: no ship named s2", self.refused(redis, "--ship", "s2"))
        client.set("game:paused", "true")
        until(lambda: client.hget("touchdown:clock", "paused") == "true", "it is paused", service)
        now = int(client.get("game:tick"))
        for seq in range(1, 5):
            control(
                client, seq, {"thrust_level": 0.01 * seq, "attitude_mode": "hold"}, tick=now + 90 + 7 * seq, substep=1
            )
        recorder = self.start(redis, "--ship", "s1", "--ticks", "250")
        until(lambda: client.info("clients")["blocked_clients"] == 1, "the recorder listens", service)
        client.set("game:paused", "false")
        self.assertEqual(recorder.wait(), 0)
        data = json.loads(self.file.read_text(encoding="utf-8"))
        self.assertEqual([s["tick"] for s in data["states"]], [data["initial"]["tick"] + i for i in range(1, 251)])
        self.assertEqual([i["substep"] for i in data["inputs"]], [0, 1, 1, 1, 1])
        self.assertIn("ship.contact", [e["event"] for e in data["events"]])

    def test_a_key_that_is_none_of_the_services_is_refused_by_name(self) -> None:
        redis = RedisServer("no")
        self.addCleanup(redis.close)
        client = redis.client()
        for key, spoil, words in (
            ("touchdown:world", lambda: client.rpush("touchdown:world", "x"), "expected a string, got a list"),
            ("touchdown:frames", lambda: client.set("touchdown:frames", "x"), "expected a stream, got a string"),
            ("touchdown:frames", lambda: client.xadd("touchdown:frames", {"frame": b"\xff"}), "expected JSON, got"),
        ):
            client.flushall()
            client.set("touchdown:world", "{}")
            client.delete(key)
            spoil()
            said = self.refused(redis, "--ship", "s1")
            self.assertEqual(said.count("\n"), 1, said)
            self.assertIn(f"recorder: {key}: {words}", said)

    def test_it_ends_where_the_tick_changes(self) -> None:
        redis = RedisServer()
        self.addCleanup(redis.close)
        client = redis.client()
        client.mset({"game:tick_rate": "50"})
        service = ServiceProcess(redis)
        self.addCleanup(service.close)
        entry = send(client, "spawn", **lander(height=3000))
        until(lambda: result_of(client, entry), "it is there", service)
        before = int(client.get("game:tick"))
        recorder = self.start(redis, "--ship", "s1", "--ticks", "10000")
        until(lambda: int(client.get("game:tick")) > before + 100, "it has recorded a while", service)
        client.set("game:tick_rate", "20")
        recorder.wait()
        self.assertIn("ended: another tick", recorder.words())


if __name__ == "__main__":
    unittest.main()
