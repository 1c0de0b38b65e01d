"""What is refused and what is taken at the ends of each range: the table that the TypeScript's test reads as well."""

import json
import unittest
from math import inf, nan
from pathlib import Path
from typing import Any

from harness import SERVICE_HOME  # noqa: F401  (puts the service on the path)
from test_loading import case

from touchdown_service.config import load_config, load_timing
from touchdown_service.validation.limits import Refusal
from touchdown_service.validation.loading import load_body, load_change, load_ship, load_ship_class

RANGES = json.loads(
    (Path(__file__).parent.parent / "dynamics" / "loading" / "ranges.json").read_text(encoding="utf-8")
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
