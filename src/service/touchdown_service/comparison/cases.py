"""Loads a landing from JSON (scenarios, cases of the parity test) as a ship in its world."""

from dataclasses import dataclass
from typing import Any

from ..config import Timing, load_config, load_timing
from ..ground.terrain import bowl, load_terrain_name
from ..models import Input, Ship, TerrainHeight, World
from ..validation.limits import mapping, number, required, text, vector, whole
from ..validation.loading import load_body, load_change, load_ship, load_ship_class


@dataclass(slots=True)
class Case:
    """One ship, its inputs pending, and its world."""

    name: str
    timing: Timing
    ticks: int
    world: World
    ship: Ship


def load_case(data: Any) -> Case:
    """Raises Refusal with the path of the first invalid field."""
    mapping(data, "case")
    bodies = [load_body(body, f"bodies[{i}]") for i, body in enumerate(required(data, "bodies", ""))]
    config = load_config(required(data, "settings", ""), "settings")
    ship_class = load_ship_class(required(data, "ship_class", ""))
    ship = load_ship(required(data, "ship", ""), {ship_class.name: ship_class}, bodies)
    ship.pending = [load_input(given, f"inputs[{i}]") for i, given in enumerate(required(data, "inputs", ""))]
    return Case(
        name=text(required(data, "name", ""), "name"),
        timing=load_timing(
            required(data, "tick_rate", ""), required(data, "time_scale", ""), config.contact_longest_substep
        ),
        ticks=whole(required(data, "ticks", ""), "ticks"),
        world=World(config, bodies, load_terrain(required(data, "terrain", ""))),
        ship=ship,
    )


def load_input(data: Any, path: str) -> Input:
    return Input(
        whole(required(data, "tick", path), f"{path}.tick"),
        whole(required(data, "substep", path), f"{path}.substep"),
        load_change(required(data, "controls", path), f"{path}.controls"),
    )


def load_terrain(data: Any) -> TerrainHeight:
    mapping(data, "terrain")
    if "name" in data:
        return load_terrain_name(data["name"], "terrain.name")
    return bowl(
        number(required(data, "base", "terrain"), "terrain.base"),
        number(required(data, "amplitude", "terrain"), "terrain.amplitude"),
        vector(required(data, "axis", "terrain"), "terrain.axis"),
    )
