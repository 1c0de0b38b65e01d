"""The service with a real Redis, read as redis-cli reads it."""

import json
import unittest
from itertools import pairwise

from harness import control, entries, frames, lander, result_of
from with_service import WithService

FIELDS = {
    "ship_id", "player_id", "name", "ship_class", "position", "velocity", "attitude", "angular_velocity",
    "rotation_input", "translation_input", "thrust_level", "attitude_hold", "attitude_mode", "target_attitude", "fuel",
    "mass", "landed_body_name", "surface_contact_state", "docked_station_id", "docked_at_tick", "rcs_firing", "system_id",
    "reference_body", "relative_position", "relative_velocity", "contact_impact_speed", "wheel_momentum",
    "ground_contact_offset", "touched", "input_session", "input_seq", "input_tick", "input_substep", "input_margin",
}  # fmt: skip


class Ships(WithService):
    def test_a_landing_as_the_game_sees_it(self) -> None:
        # All of the game's own fields are there.
        self.assertEqual(self.send("spawn", **lander(height=12, velocity=[2, 0, -12]))["reason"], "")
        self.until(lambda: self.state() == "landed", "s1 landed")
        record = self.client.hgetall("ship:s1")
        self.assertEqual(set(record), FIELDS)
        self.assertEqual(record["landed_body_name"], "Luna")
        self.assertEqual(len(json.loads(record["attitude"])), 4)
        told = entries(self.client, "galaxy:ships")
        self.assertEqual([entry["event"] for entry in told], ["ship.contact", "ship.landed"])
        for entry in told:
            self.assertEqual(
                {k: entry[k] for k in ("ship_id", "player_id", "body")},
                {"ship_id": "s1", "player_id": "pilot of s1", "body": "Luna"},
            )
            self.assertEqual(len(entry), 4)
        touches = [e for e in entries(self.client, "touchdown:events") if e["event"] == "ship.contact"]
        self.assertEqual([e["again"] for e in touches], ["false"] + ["true"] * (len(touches) - 1))
        self.assertGreater(len(touches), 1)
        self.assertEqual(self.client.smembers("system:sol:ships"), {"s1"})

    def test_a_crash_deletes_the_ship(self) -> None:
        self.send("spawn", **lander(height=20, velocity=[0, 0, -70]))
        self.until(lambda: not self.client.exists("ship:s1"), "the ship is gone")
        self.assertEqual(
            entries(self.client, "galaxy:ships"),
            [
                {
                    "event": "ship.destroyed",
                    "ship_id": "s1",
                    "player_id": "pilot of s1",
                    "body": "Luna",
                    "reason": "collision",
                }
            ],
        )
        self.assertEqual(self.client.smembers("system:sol:ships"), set())
        frame = next(f for f in frames(self.client) if f["removed"])
        self.assertEqual(frame["ships"], [])
        self.assertEqual(
            frame["removed"][0], {"ship_id": "s1", "player_id": "pilot of s1", "name": "s1", "reason": "collision"}
        )
        self.assertEqual(frame["events"][0]["type"], "ship.destroyed")

    def test_commands_are_refused_by_name_and_change_nothing(self) -> None:
        self.send("spawn", **lander())
        self.assertIn("exists already", self.send("spawn", **lander())["reason"])
        self.assertIn("no ship named", self.send("remove", ship_id="s2")["reason"])
        self.assertIn("type: expected one of", self.send("dock", ship_id="s1")["reason"])
        self.assertIn("maneuver: expected one of", self.send("maneuver", ship_id="s1", maneuver="orbit")["reason"])
        self.assertTrue(self.send("remove", ship_id="s1")["ok"])
        self.until(lambda: not self.client.exists("ship:s1"), "the ship is gone")
        self.assertEqual(self.client.xlen("touchdown:inbox"), 0)

    def test_the_autopilot_can_be_watched(self) -> None:
        self.send("spawn", **lander(height=30, velocity=[0, 0, -2]))
        self.send("maneuver", ship_id="s1", maneuver="landing")
        self.assertEqual(self.client.hget("maneuver:s1", "phase"), "descent")
        self.until(lambda: self.client.hget("maneuver:s1", "phase") == "complete", "the landing is complete")
        self.assertEqual(self.state(), "landed")


class Inputs(WithService):
    def test_an_input_acts_at_its_substep_and_is_acknowledged(self) -> None:
        self.send("spawn", **lander(height=3000))
        at = self.tick() + 50
        control(self.client, 1, {"thrust_level": 0.5}, tick=at, substep=1, player_id="pilot of s1")
        control(self.client, 2, {"attitude_mode": "radial"}, tick=at + 2, substep=0)
        # Sent twice, it acts once.
        control(self.client, 2, {"attitude_mode": "radial"}, tick=at + 2, substep=0)
        self.until(lambda: self.client.hget("ship:s1", "input_seq") == "2", "both were applied")
        told = {f["tick"]: f["ships"][0].get("last_input") for f in frames(self.client) if f["ships"]}
        self.assertIsNone(told[at])
        first = told[at + 1]
        self.assertEqual((first["session"], first["seq"], first["tick"], first["substep"]), ("page", 1, at, 1))
        self.assertGreater(first["margin"], 0.3)
        self.assertEqual(told[at + 3]["tick"], at + 2)
        record = self.client.hgetall("ship:s1")
        self.assertEqual((record["thrust_level"], record["attitude_mode"]), ("0.5", "radial"))

    def test_controls_of_a_whole_tick_and_late_ones_act_at_once(self) -> None:
        self.send("spawn", **lander(height=3000))
        # At one tick a second, tick 0 is further back than a busy machine delays a boundary.
        self.until(lambda: self.tick() > 60, "60 ticks")
        self.client.set("game:tick_rate", "1")
        self.until(lambda: frames(self.client)[-1]["tick_rate"] == 1, "the rate holds")
        control(self.client, 1, {"thrust_level": 0.25})
        control(self.client, 2, {"rotation_input": [0, 0, 1]}, tick=0, substep=0)
        self.until(lambda: self.client.hget("ship:s1", "input_seq") == "2", "both were applied")
        record = self.client.hgetall("ship:s1")
        self.assertEqual((record["thrust_level"], record["rotation_input"]), ("0.25", "[0.0, 0.0, 1.0]"))
        self.assertLess(float(record["input_margin"]), 0)

    def test_what_cannot_be_used_is_refused_by_field(self) -> None:
        self.send("spawn", **lander(height=3000))
        for seq, (controls, at, words) in enumerate(
            (
                ({"thrust_level": 1}, {"player_id": "somebody"}, "player_id"),
                ({"thrust_level": float("nan")}, {}, "controls.thrust_level: expected a finite number"),
                ({"thrust_level": 1}, {"tick": 10**9}, "tick: expected at most"),
                ({"thrust_level": 1}, {"tick": "soon"}, "tick: expected a whole number"),
                ({"thrust_level": 1}, {"ship_id": "s9"}, "ship_id: no ship named s9"),
                ({"thrust_level": 1}, {"session": ""}, "session: expected a non-empty string"),
            ),
            1,
        ):
            entry = control(self.client, seq, controls, **at)
            result = self.until(lambda: result_of(self.client, entry), "a result")
            self.assertIn(words, result["reason"])
        self.client.xadd("touchdown:inbox", {"nonsense": "x"})
        self.client.xadd("touchdown:inbox", {"type": "spawn", "data": "[" * 10_000})
        self.until(lambda: self.client.xlen("touchdown:inbox") == 0, "the inbox is empty")
        self.assertEqual(self.client.hget("ship:s1", "thrust_level"), "0.0")


class Clock(WithService):
    def test_rate_scale_and_pause_change_while_it_runs(self) -> None:
        listener = self.client.pubsub()
        listener.subscribe("tick_completed")
        self.client.mset({"game:tick_rate": "25", "game:time_scale": "2"})
        self.until(lambda: frames(self.client)[-1]["tick_rate"] == 25, "the rate holds")
        told = frames(self.client)
        changed = next(i for i, f in enumerate(told) if f["tick_rate"] == 25)
        self.until(lambda: len(frames(self.client)) > changed + 2, "two more frames")
        now, then = frames(self.client)[changed : changed + 2]
        self.assertAlmostEqual(then["game_time"] - now["game_time"], 0.08, 9)
        # A busy machine moves the schedule by whole intervals; where it keeps up they are one apart.
        steps = (then["due"] - now["due"]) / 0.04
        self.assertAlmostEqual(steps, max(1, round(steps)), 4)
        dues = lambda: [f["due"] for f in frames(self.client)[changed:]]
        self.until(lambda: any(abs(b - a - 0.04) < 1e-6 for a, b in pairwise(dues())), "two frames 40 ms apart")
        self.client.set("game:paused", "true")
        self.until(lambda: frames(self.client)[-1]["paused"], "paused")
        stood = self.tick()
        self.assertEqual(self.client.hget("body:Luna", "tick"), str(stood))
        # While paused, ships can be added and removed; the tick stays.
        self.assertTrue(self.send("spawn", **lander())["ok"])
        self.assertEqual((self.tick(), frames(self.client)[-1]["tick"]), (stood, stood))
        self.client.set("game:paused", "false")
        self.until(lambda: self.tick() > stood + 3, "it goes on")
        ticks: list[int] = []
        # Up to a tick after the pause: at 25 Hz another message always follows.
        while not ticks or ticks[-1] <= stood + 3:
            message = listener.get_message(timeout=10)
            self.assertIsNotNone(message, "tick_completed goes on")
            if message["type"] == "message":
                ticks.append(json.loads(message["data"])["tick"])
        self.assertEqual(sorted(set(ticks)), list(range(ticks[0], ticks[-1] + 1)))

    def test_what_cannot_be_used_stays_out_and_is_named(self) -> None:
        self.client.set("game:tick_rate", "-3")
        self.until(lambda: "game:tick_rate" in self.client.hget("touchdown:status", "refused"), "the refusal is told")
        before = self.tick()
        self.until(lambda: self.tick() > before + 5, "it ticks on")
        self.assertEqual(frames(self.client)[-1]["tick_rate"], 50)

    def test_values_that_stay_invalid_are_logged_once_each(self) -> None:
        rate, scale = "game:tick_rate: expected >= 0.1 Hz, got -3", "game:time_scale: expected a number, got 'fast'"
        self.client.mset({"game:tick_rate": "-3", "game:time_scale": "fast"})
        self.until(lambda: rate in self.service.words() and scale in self.service.words(), "both are told")
        for value, what in (("-3", "both stay"), ("50", "one is valid again"), ("-3", "and invalid again")):
            self.client.set("game:tick_rate", value)
            before = self.tick()
            self.until(lambda before=before: self.tick() > before + 5, what)
        words = self.service.words()
        self.assertEqual([words.count(rate), words.count(scale)], [2, 1], words)

    def test_bodies_are_written_each_tenth_tick(self) -> None:
        seen = set()
        self.until(lambda: seen.add(int(self.client.hget("body:Luna", "tick") or 0)) or len(seen) > 3, "three writes")
        self.assertEqual({tick % 10 for tick in seen}, {0})
        self.assertIn("Luna", self.client.smembers("system:sol:bodies"))

    def test_a_world_whose_keys_are_gone_gets_them_back(self) -> None:
        self.client.delete("game:time_scale", "game:paused")
        self.until(lambda: self.client.get("game:time_scale") == "1.0", "the scale in force")
        self.assertEqual(self.client.get("game:paused"), "false")
        self.assertEqual(self.client.get("game:time_sync"), "false")


if __name__ == "__main__":
    unittest.main()
