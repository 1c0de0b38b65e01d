"""A landing as JSON data (the rehearsal scenarios, the parity test's cases) turned into a ship in its world."""

from dataclasses import dataclass
from math import sqrt
from typing import Any

from .config import Timing, load_config, load_timing
from .models import Body, Controls, Ship, ShipClass, TerrainHeight, World
from .simulation import Input
from .terrain import TERRAINS, bowl
from .vectors import Quat


@dataclass(slots=True)
class Case:
    """One ship, its world, its pilot's inputs in the order of their time."""

    name: str
    timing: Timing
    ticks: int
    world: World
    ship: Ship
    inputs: list[Input]


def load_case(data: dict[str, Any]) -> Case:
    bodies = [load_body(body) for body in data["bodies"]]
    world = World(load_config(data["settings"]), bodies, load_terrain(data["terrain"]))
    return Case(
        name=data["name"],
        timing=load_timing(data["tick_rate"], data["time_scale"]),
        ticks=data["ticks"],
        world=world,
        ship=load_ship(data["ship"], load_ship_class(data["ship_class"]), bodies),
        inputs=[
            Input(given["tick"], given["substep"], load_controls(given["controls"]))
            for given in data["inputs"]
        ],
    )


def load_terrain(data: dict[str, Any]) -> TerrainHeight:
    if "name" in data:
        return TERRAINS[data["name"]]
    return bowl(float(data["base"]), float(data["amplitude"]), floats(data["axis"]))


def load_body(data: dict[str, Any]) -> Body:
    return Body(
        name=data["name"],
        mass=float(data["mass"]),
        radius=float(data["radius"]),
        position=floats(data["position"]),
        velocity=floats(data["velocity"]),
        attitude=floats(data["attitude"]),
        angular_velocity=floats(data["angular_velocity"]),
    )


def load_ship_class(data: dict[str, Any]) -> ShipClass:
    vectors = {"rcs_thrust", "rcs_torque", "reaction_wheel_torque"}
    given = {
        name: value if name == "name" else floats(value) if name in vectors else value
        for name, value in data.items()
    }
    given["inertia_tensor"] = [list(floats(row)) for row in data["inertia_tensor"]]
    return ShipClass(**given)


def load_ship(data: dict[str, Any], ship_class: ShipClass, bodies: list[Body]) -> Ship:
    return Ship(
        ship_class=ship_class,
        body=next(body for body in bodies if body.name == data["reference_body"]),
        position=floats(data["relative_position"]),
        velocity=floats(data["relative_velocity"]),
        attitude=floats(data["attitude"]),
        angular_velocity=floats(data["angular_velocity"]),
        fuel=float(data["fuel"]),
        impact_speed=float(data["contact_impact_speed"]),
        surface_contact_state=data["surface_contact_state"],
        crashed=data["crashed"],
    )


def load_controls(data: dict[str, Any]) -> Controls:
    """Clamped into range, the target normalized: as the server takes what a client sends."""
    return Controls(
        thrust_level=clamp(float(data["thrust_level"]), 0.0),
        translation_input=tuple(clamp(value, -1.0) for value in floats(data["translation_input"])),
        rotation_input=tuple(clamp(value, -1.0) for value in floats(data["rotation_input"])),
        attitude_hold=data["attitude_hold"],
        attitude_mode=data["attitude_mode"],
        target_attitude=unit_quaternion(floats(data["target_attitude"])),
    )


def clamp(value: float, low: float) -> float:
    return low if value < low else min(value, 1.0)


def unit_quaternion(q: Quat) -> Quat:
    """What is unit already stays as it is, so that a stored input replays to the same bits."""
    x, y, z, w = q
    size = sqrt(x * x + y * y + z * z + w * w)
    return q if abs(size - 1) <= 1e-12 else (x / size, y / size, z / size, w / size)


def floats(values: list[float]) -> tuple[float, ...]:
    """JSON does not tell 1.0 from 1."""
    return tuple(float(value) for value in values)
