"""Invalid data is refused with the field's name."""

import json
import tempfile
import unittest
from array import array
from copy import deepcopy
from math import inf, nan
from pathlib import Path
from typing import Any

from harness import SERVICE_HOME  # noqa: F401  (puts the service on the path)

from touchdown_service.comparison.cases import load_case
from touchdown_service.config import load_config, load_timing
from touchdown_service.ground.terrain import with_whole_paths
from touchdown_service.runtime.galaxy import Tempo, make_galaxy
from touchdown_service.runtime.tempo import next_tempo
from touchdown_service.storage.records import body_of_record, load_controls_json
from touchdown_service.validation.limits import Refusal
from touchdown_service.validation.loading import load_body, load_change, load_ship, load_ship_class

WORLD = json.loads((SERVICE_HOME / "touchdown_service" / "world.json").read_text(encoding="utf-8"))


def case(**changes: Any) -> dict[str, Any]:
    """A valid landing, with values at paths like 'ship.fuel' changed; ... removes the field."""
    body = WORLD["bodies"][0] | {"attitude": [0, 0, 0, 1]}
    data = {
        "name": "case", "tick_rate": 1, "time_scale": 1, "ticks": 1, "settings": {}, "terrain": {"name": "flat"},
        "ship_class": deepcopy(WORLD["ship_classes"][0]), "bodies": [body], "inputs": [],
        "ship": {
            "ship_class": WORLD["ship_classes"][0]["name"], "reference_body": body["name"],
            "relative_position": [0, 0, 1.8e6], "relative_velocity": [0, 0, 0], "attitude": [0, 0, 0, 1],
            "angular_velocity": [0, 0, 0], "fuel": 10, "surface_contact_state": "", "contact_impact_speed": 0,
            "crashed": False,
        },
    }  # fmt: skip
    for path, value in changes.items():
        *way, last = path.split("__")
        at: Any = data
        for step in way:
            at = at[int(step) if step.isdigit() else step]
        if value is ...:
            del at[last]
        else:
            at[last] = value
    return data


class Loading(unittest.TestCase):
    def refused(self, words: str, **changes: Any) -> None:
        with self.assertRaises(Refusal) as caught:
            load_case(case(**changes))
        self.assertIn(words, str(caught.exception))

    def test_a_good_case_loads(self) -> None:
        self.assertEqual(load_case(case()).ship.fuel, 10.0)

    def test_names_and_states(self) -> None:
        self.refused("ship.surface_contact_state: expected one of '', 'contact'", ship__surface_contact_state="LANDED")
        self.refused("ship.reference_body: expected one of", ship__reference_body="Moom")
        self.refused("ship.ship_class: expected one of", ship__ship_class="fast_frigat")
        self.refused("terrain.name: expected one of 'flat', 'hills', got 'hils'", terrain={"name": "hils"})
        self.refused("ship.relative_position: missing", ship__relative_position=...)
        self.refused("ship_class.dry_mas: no such field", ship_class__dry_mas=1)

    def test_numbers(self) -> None:
        self.refused("settings.contact_crash_speed: expected > 0 m/s, got -1", settings={"contact_crash_speed": -1})
        self.refused("settings.contact_crash_sped: no such field", settings={"contact_crash_sped": 1})
        self.refused(
            "settings.contact_bounce_speed: expected < contact_crash_speed", settings={"contact_bounce_speed": 50}
        )
        self.refused("settings.contact_longest_substep", settings={"contact_longest_substep": 0.03})
        self.refused("ship.fuel: expected a finite number, got nan", ship__fuel=float("nan"))
        self.refused("ship.fuel: expected a finite number, got True", ship__fuel=True)
        self.refused("ship.relative_velocity[1]: expected <= 1e+09 m/s", ship__relative_velocity=[0, 1e10, 0])
        self.refused("ship.relative_position: expected >= 1 m", ship__relative_position=[0, 0, 0.5])
        self.refused("ship.attitude: expected length 1", ship__attitude=[0, 0, 0, 2])
        self.refused("tick_rate: expected >= 0.1 Hz", tick_rate=0)
        self.refused("ship_class.inertia_tensor", ship_class__inertia_tensor=[[1, 0, 0], [0, -1, 0], [0, 0, 1]])
        self.refused("ship_class.dry_inertia_ratio", ship_class__dry_inertia_ratio=0)
        self.refused("ship_class.attitude_natural_frequency", ship_class__attitude_natural_frequency=6)
        self.refused("ship_class.reaction_wheel_capacity[2]", ship_class__reaction_wheel_capacity=[1, 1, -1])
        self.refused("bodies[0].mass: expected > 0 kg", bodies__0__mass=0)
        self.refused("inputs[0].tick: expected a whole number", inputs=[{"tick": 0.5, "substep": 0, "controls": {}}])

    def test_settings_that_are_good(self) -> None:
        config = load_config({"surface_normal": "terrain", "contact_friction_static": 1})
        self.assertTrue(config.is_terrain_normal)
        with self.assertRaises(Refusal) as caught:
            load_config({"surface_normal": "Terrain"})
        self.assertIn("settings.surface_normal: expected one of 'radial', 'terrain'", str(caught.exception))

    def test_controls(self) -> None:
        self.assertEqual(load_controls_json({"thrust_level": 7}, "controls"), {"thrust_level": 1.0})
        self.assertEqual(load_controls_json({"attitude_mode": "dock"}, "controls"), {"attitude_mode": "dock"})
        self.assertEqual(
            load_controls_json({"target_attitude": [2, 0, 0, 0]}, "controls"), {"target_attitude": (0.0, 0.0, 0.0, 1.0)}
        )
        for bad, words in (
            ({"thrust_level": float("inf")}, "controls.thrust_level: expected a finite number"),
            ({"rotation_input": [0, 0]}, "controls.rotation_input: expected 3 numbers"),
            ({"attitude_hold": 1}, "controls.attitude_hold: expected true or false"),
            ({"target_attitude": [0, 0, 0, 0]}, "controls.target_attitude: expected a quaternion of length 1"),
            ({"thrust": 1}, "controls.thrust: no such field"),
        ):
            with self.assertRaises(Refusal) as caught:
                load_controls_json(bad, "controls")
            self.assertIn(words, str(caught.exception))

    def test_tempo(self) -> None:
        now = Tempo(tick_rate=2.0, time_scale=1.0, requested_scale=1.0)
        requests = {"game:tick_rate": "0", "game:time_scale": "ten", "game:paused": "perhaps", "game:time_sync": None}
        tempo, refusals = next_tempo(now, requests, 0.0)
        self.assertEqual(tempo, now)
        self.assertEqual(
            refusals,
            [
                "game:tick_rate: expected >= 0.1 Hz, got 0",
                "game:time_scale: expected a number, got 'ten'",
                "game:paused: expected true or false, got 'perhaps'",
            ],
        )
        long = {"game:tick_rate": "0" * 63 + "20", "game:time_scale": "0" * 62 + "20"}
        tempo, refusals = next_tempo(now, long, 0.0)
        self.assertEqual(refusals, ["game:tick_rate: expected at most 64 bytes"])
        self.assertEqual((tempo.tick_rate, tempo.requested_scale), (now.tick_rate, 20))
        tempo, refusals = next_tempo(now, {"game:tick_rate": "10", "game:time_sync": "true"}, 5.0)
        self.assertEqual((tempo.tick_rate, tempo.time_scale, refusals), (10.0, 1.05, []))


class Heightmaps(unittest.TestCase):
    """A world file that names heightmaps; `changes` are of the map of Luna, ... takes a field out."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        samples = array("h", [100 * row + column for row in range(4) for column in range(8)])
        (self.folder / "luna.i16").write_bytes(samples.tobytes())

    def height(self, direction: tuple[float, float, float], body: str = "Luna", **changes: Any) -> float:
        grid = {"path": "luna.i16", "columns": 8, "rows": 4, "scale": 0.5, "reference_radius": 1737400.0} | changes
        grid = {name: value for name, value in grid.items() if value is not ...}
        bodies = [body_of_record(record, "bodies") for record in WORLD["bodies"]]
        kept = {name: value for name, value in WORLD.items() if name != "bodies"}
        definition = with_whole_paths(kept | {"terrain": "surveyed", "heightmaps": {body: grid}}, self.folder)
        return make_galaxy(definition, bodies).world.terrain_height(body, *direction)

    def refused(self, words: str, **changes: Any) -> None:
        with self.assertRaises(Refusal) as caught:
            self.height((0.0, 0.0, 1.0), **changes)
        self.assertIn(words, str(caught.exception))

    def test_heights_come_from_the_file(self) -> None:
        # Latitude 0, longitude 0: row 2, column 0, in units of half a metre.
        self.assertEqual(self.height((0.0, 0.0, 1.0)), 100.0)
        self.assertEqual(self.height((0.0, 0.0, 1.0), reference_radius=1737410.0), 110.0)
        self.assertEqual(self.height((0.0, 0.0, 1.0), interpolation="bicubic"), 100.0)

    def test_what_cannot_be_used_is_refused_by_name(self) -> None:
        self.refused("world.heightmaps.Luna.rows: missing", rows=...)
        self.refused("world.heightmaps.Luna.columns: expected a whole number", columns=7.5)
        self.refused("world.heightmaps.Luna.path: expected 80 bytes, 8 x 5 samples, got 64", rows=5)
        self.refused("cannot be read: [Errno 2]", path="nowhere.i16")
        self.refused("world.heightmaps.Luna.path: ", path="\0")
        self.refused("world.heightmaps.Luna.path: expected a string", path=5)
        self.refused("world.heightmaps.Luna.scale: expected a finite number", scale="0.5")
        self.refused("world.heightmaps.Luna.reference_radius: expected >= 0.001 m", reference_radius=0)
        self.refused("world.heightmaps.Luna.interpolation: expected one of 'bilinear', 'bicubic'", interpolation="cubic")
        self.refused("world.heightmaps.Luna.row: no such field", row=4)
        self.refused("world.heightmaps: expected one of", body="Lunar")

    def test_a_built_in_name_is_not_a_name_for_heightmaps(self) -> None:
        with self.assertRaises(Refusal) as caught:
            make_galaxy({"terrain": "hills", "heightmaps": {}, "ship_classes": []}, [])
        self.assertIn("world.terrain: expected a name of its own beside heightmaps", str(caught.exception))


# What is refused and what is taken at the ends of each range: the table that the TypeScript's test reads as well.
RANGES = json.loads(
    (Path(__file__).parent.parent.parent / "dynamics" / "loading" / "ranges.json").read_text(encoding="utf-8")
)
# JSON has no NaN and no infinities.
NOT_IN_JSON = {"#nan": nan, "#inf": inf, "#-inf": -inf}


def value_of(given: Any) -> Any:
    if isinstance(given, list):
        return [value_of(one) for one in given]
    return NOT_IN_JSON.get(given, given) if isinstance(given, str) else given


def load(record: str, change: dict[str, Any]) -> None:
    """Loads a good record with `change` in it. Raises Refusal."""
    good = case()
    if record == "settings":
        load_config(change)
    elif record == "ship_class":
        load_ship_class(good["ship_class"] | change)
    elif record == "body":
        load_body(good["bodies"][0] | change)
    elif record == "ship":
        classes = {cls.name: cls for cls in [load_ship_class(good["ship_class"])]}
        load_ship(good["ship"] | change, classes, [load_body(good["bodies"][0])])
    elif record == "controls":
        load_change(change)
    else:
        tempo = {"tick_rate": 1, "time_scale": 1} | change
        load_timing(tempo["tick_rate"], tempo["time_scale"], 0.01)


class Ranges(unittest.TestCase):
    def test_every_field(self) -> None:
        for record, fields in RANGES.items():
            for field, values in fields.items():
                others = values.get("with", {})
                for given in values["refused"]:
                    with self.subTest(refused=f"{record}.{field} = {given}"):
                        with self.assertRaises(Refusal) as caught:
                            load(record, others | {field: value_of(given)})
                        self.assertRegex(str(caught.exception), rf"^(\w+\.)?{field}(\[\d\])*: ")
                for given in values["accepted"]:
                    with self.subTest(accepted=f"{record}.{field} = {given}"):
                        load(record, others | {field: value_of(given)})


if __name__ == "__main__":
    unittest.main()
