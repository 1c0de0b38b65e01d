"""The tick of a whole world."""

import json
import unittest

from harness import SERVICE_HOME, lander

from touchdown_service.config import load_timing
from touchdown_service.models import Input
from touchdown_service.runtime.galaxy import Changes, Galaxy, make_galaxy, run_interval
from touchdown_service.runtime.inbox import apply_entries
from touchdown_service.runtime.spawning import ship_of_order
from touchdown_service.simulation import run_tick
from touchdown_service.storage.records import body_of_record

WORLD = json.loads((SERVICE_HOME / "touchdown_service" / "world.json").read_text(encoding="utf-8"))


def galaxy_with(*orders: dict) -> Galaxy:
    galaxy = make_galaxy(WORLD, [body_of_record(body, "body") for body in WORLD["bodies"]])
    entries = [(f"{i}-0", {"type": "spawn", "data": json.dumps(order)}) for i, order in enumerate(orders, 1)]
    changes = Changes()
    apply_entries(galaxy, entries, changes)
    assert all(result["ok"] for result in changes.results), changes.results
    return galaxy


def run(galaxy: Galaxy, ticks: int) -> Changes:
    changes = Changes()
    for _ in range(ticks):
        run_interval(galaxy, 0.0, changes)
    return changes


class Simulation(unittest.TestCase):
    def test_bodies_move_once_a_tick_however_many_ships_there_are(self) -> None:
        alone, crowded = galaxy_with(), galaxy_with(*(lander(f"s{i}") for i in range(5)))
        for galaxy in (alone, crowded):
            run(galaxy, 3)
        for one, other in zip(alone.world.bodies, crowded.world.bodies):
            self.assertEqual((one.position, one.attitude), (other.position, other.attitude))

    def test_a_ship_flies_the_same_whoever_else_is_there(self) -> None:
        alone, crowded = (
            galaxy_with(lander("s3")),
            galaxy_with(*(lander(f"s{i}", height=20 + i) for i in range(3)), lander("s3")),
        )
        for galaxy in (alone, crowded):
            run(galaxy, 12)
        self.assertEqual(alone.ships["s3"].position, crowded.ships["s3"].position)
        self.assertEqual(alone.ships["s3"].attitude, crowded.ships["s3"].attitude)

    def test_events_come_in_the_order_in_which_they_happen(self) -> None:
        galaxy = galaxy_with(*(lander(f"s{i}", height=5 + 7 * (i % 4), velocity=[0, 0, -15]) for i in range(8)))
        events = run(galaxy, 30).events
        self.assertEqual([(e.tick, e.substep) for e in events], sorted((e.tick, e.substep) for e in events))
        self.assertGreater(len(events), 16)

    def test_the_initial_touch_is_told_from_those_after_a_bounce(self) -> None:
        galaxy = galaxy_with(lander(height=60, velocity=[0, 0, -30]))
        touches = [e.again for e in run(galaxy, 90).events if e.type == "ship.contact"]
        self.assertEqual(touches[0], False)
        self.assertGreater(len(touches), 1)
        self.assertEqual(set(touches[1:]), {True})
        self.assertEqual(galaxy.ships["s1"].surface_contact_state, "landed")
        # It launches and comes down again.
        galaxy.ships["s1"].pending = [
            Input(galaxy.tick, 0, {"thrust_level": 1.0}),
            Input(galaxy.tick + 1, 0, {"thrust_level": 0.0}),
        ]
        touches = [e.again for e in run(galaxy, 60).events if e.type == "ship.contact"]
        self.assertEqual(touches[0], False)

    def test_a_tick_of_a_hundred_thousand_substeps_is_that_of_its_substeps(self) -> None:
        galaxy = galaxy_with(lander(height=2000))
        ship = galaxy.ships["s1"]
        galaxy.world.bodies[:] = [body for body in galaxy.world.bodies if body.name == "Luna"]
        timing = load_timing(1, 30, 0.01)
        events = run_tick(galaxy.world, [ship], timing, 0).events
        other = galaxy_with(lander(height=2000))
        together = []
        for tick in range(30):
            together += run_tick(other.world, [other.ships["s1"]], load_timing(1, 1, 0.01), tick).events
        self.assertEqual(ship.position, other.ships["s1"].position)
        self.assertEqual([e.type for e in events], [e.type for e in together])

    def test_a_place_is_where_it_says(self) -> None:
        galaxy = galaxy_with(
            lander("up", height=100), lander("over", height=100, tilt=30, lean_to=90, velocity=[3, 4, 5])
        )
        up, over = galaxy.ships["up"], galaxy.ships["over"]
        from touchdown_service.law.vectors import cross, dot, subtract, unit, up_of

        normal = unit(up.position)
        self.assertAlmostEqual(dot(up_of(up.attitude), normal), 1, 12)
        self.assertAlmostEqual(dot(up_of(over.attitude), normal), 0.8660254037844386, 12)
        moving = subtract(over.velocity, cross(over.body.angular_velocity, over.position))
        self.assertAlmostEqual(dot(moving, normal), 5, 9)
        self.assertAlmostEqual(dot(moving, moving), 50, 6)

    def test_the_autopilot_lands(self) -> None:
        galaxy = galaxy_with(lander(height=400, velocity=[12, -5, -20], tilt=40))
        apply_entries(galaxy, [("9-0", {"type": "maneuver", "data": '{"ship_id": "s1", "maneuver": "landing"}'})], Changes())
        events = run(galaxy, 150).events
        self.assertEqual(galaxy.landings["s1"].phase, "complete")
        self.assertEqual(galaxy.ships["s1"].surface_contact_state, "landed")
        self.assertLess(max(e.impact_speed for e in events if e.type == "ship.contact"), 10)

    def test_the_autopilot_gives_up(self) -> None:
        for order, input, reason in (
            ({"height": 4000}, {"thrust_level": 0.0}, "the pilot took the controls"),
            ({"height": 30, "velocity": [0, 0, -70]}, None, "crashed on Luna"),
            ({"height": 30, "velocity": [0, 0, -30]}, None, "hit Luna at 15.7 m/s"),
            ({"height": 900, "fuel": 0}, None, "main engine: 0 N cannot hold"),
        ):
            galaxy = galaxy_with(lander(**order))
            apply_entries(
                galaxy, [("9-0", {"type": "maneuver", "data": '{"ship_id": "s1", "maneuver": "landing"}'})], Changes()
            )
            if input is not None:
                galaxy.ships["s1"].pending = [Input(2, 0, input, "page", 1)]
            run(galaxy, 5)
            self.assertEqual(galaxy.landings["s1"].phase, "aborted")
            self.assertIn(reason, galaxy.landings["s1"].reason)

    def test_a_ship_keeps_its_own_height_over_its_feet(self) -> None:
        galaxy = galaxy_with(lander(ground_contact_offset=2.5))
        ship = galaxy.ships["s1"]
        self.assertEqual(ship.ground_contact_offset, 2.5)
        self.assertAlmostEqual(sum(x * x for x in ship.position) ** 0.5, ship.body.radius + 2.5 + 40, 3)


class Spawning(unittest.TestCase):
    def test_orders_that_cannot_be_used_are_refused_by_name(self) -> None:
        galaxy = galaxy_with(lander())
        for order, words in (
            (lander("s1"), "ship_id: s1 exists already"),
            (lander("s2", body="Moon"), "body: expected one of"),
            (lander("s2", direction=[0, 0, 0]), "direction: expected a length > 0"),
            (lander("s2", hight=3), "hight: no such field"),
            (lander("s2", ship_class="fast_frigat"), "ship_class: expected one of"),
            (lander("", height=1), "ship_id: expected a non-empty string"),
            (lander("s2", fuel=-1), "data.fuel: expected >= 0 kg"),
            (lander("x" * 129), "ship_id: expected at most 128 characters"),
        ):
            changes = Changes()
            apply_entries(galaxy, [("9-0", {"type": "spawn", "data": json.dumps(order)})], changes)
            self.assertIn(words, changes.results[0]["reason"])
            self.assertEqual(list(galaxy.ships), ["s1"])

    def test_half_a_surrogate_is_refused(self) -> None:
        changes = Changes()
        galaxy = galaxy_with()
        apply_entries(galaxy, [("9-0", {"type": "spawn", "data": json.dumps(lander("s\ud800"))})], changes)
        self.assertIn("ship_id: expected a string", changes.results[0]["reason"])

    def test_a_full_state_comes_back_to_the_bit(self) -> None:
        from touchdown_service.storage.records import from_hash, ship_of_record, ship_record, to_hash, to_texts

        galaxy = galaxy_with(lander(height=3, velocity=[1, 2, -3], tilt=12))
        run(galaxy, 3)
        ship = galaxy.ships["s1"]
        flat = to_hash(to_texts(ship_record(ship, "sol")))
        read = from_hash(dict(zip(flat[::2], flat[1::2])), "ship")
        again = ship_of_record(read, galaxy.classes, galaxy.world.bodies, "ship")
        for name in ("position", "velocity", "attitude", "angular_velocity", "fuel", "wheel_momentum", "impact_speed",
                     "surface_contact_state", "controls", "touched", "applied", "ground_contact_offset"):  # fmt: skip
            self.assertEqual(getattr(again, name), getattr(ship, name), name)
        order = {key: read[key] for key in read if key in STATE}
        spawned = ship_of_order(order, galaxy.classes, galaxy.world.bodies, galaxy.world.terrain_height)
        self.assertEqual(spawned.position, ship.position)


STATE = {
    "ship_id", "player_id", "name", "ship_class", "fuel", "reference_body", "relative_position", "relative_velocity",
    "attitude", "angular_velocity", "surface_contact_state", "contact_impact_speed", "wheel_momentum",
}  # fmt: skip

if __name__ == "__main__":
    unittest.main()
