"""Converts ships and bodies to the records of Redis and of frames (REDIS.md), and back, to the last bit."""

import json
from json.encoder import encode_basestring_ascii as quoted
from typing import Any

from ..law.vectors import Quat, add
from ..models import Applied, Body, Controls, Input, Ship, ShipClass
from ..validation.limits import Refusal, boolean, mapping, number, parse_json, required, shown, text, whole
from ..validation.loading import CONTROL_FIELDS, load_body, load_change, load_ship

# In the order of their numbers, rcs_firing's pods: signs of x, y, z (GAME's order).
PODS = tuple((sx, sy, sz) for sz in (1, -1) for sy in (1, -1) for sx in (1, -1))
TEXTS = frozenset({
    "ship_id", "player_id", "name", "ship_class", "attitude_mode", "landed_body_name", "surface_contact_state",
    "docked_station_id", "docked_at_tick", "system_id", "reference_body", "input_session",
})  # fmt: skip


def ship_record(ship: Ship, system_id: str) -> dict[str, Any]:
    """Every field of the ship hash as a JSON value."""
    body, controls, applied = ship.body, ship.controls, ship.applied
    return {
        "ship_id": ship.ship_id,
        "player_id": ship.player_id,
        "name": ship.name,
        "ship_class": ship.ship_class.name,
        "position": add(body.position, ship.position),
        "velocity": add(body.velocity, ship.velocity),
        "attitude": w_first(ship.attitude),
        "angular_velocity": ship.angular_velocity,
        **controls_record(controls),
        "fuel": ship.fuel,
        "mass": ship.ship_class.dry_mass + ship.fuel,
        "landed_body_name": ship.landed_body_name,
        "surface_contact_state": ship.surface_contact_state,
        "docked_station_id": "",
        "docked_at_tick": "",
        "rcs_firing": rcs_firing(controls, ship.fuel),
        "system_id": system_id,
        "reference_body": body.name,
        "relative_position": ship.position,
        "relative_velocity": ship.velocity,
        "contact_impact_speed": ship.impact_speed,
        "wheel_momentum": ship.wheel_momentum,
        "ground_contact_offset": ship.ground_contact_offset,
        "touched": ship.touched,
        "input_session": applied.session if applied else "",
        "input_seq": applied.seq if applied else 0,
        "input_tick": applied.tick if applied else 0,
        "input_substep": applied.substep if applied else 0,
        "input_margin": applied.margin if applied else 0.0,
    }


def controls_record(controls: Controls) -> dict[str, Any]:
    return {
        "rotation_input": controls.rotation_input,
        "translation_input": controls.translation_input,
        "thrust_level": controls.thrust_level,
        "attitude_hold": controls.attitude_hold,
        "attitude_mode": controls.attitude_mode,
        "target_attitude": w_first(controls.target_attitude),
    }


def rcs_firing(controls: Controls, fuel: float) -> int:
    """Translation along +a fires the four nozzles on the -a side: bit = pod x 3 + axis."""
    bits = 0
    if fuel > 0 and any(controls.translation_input):
        for axis, command in enumerate(controls.translation_input):
            for pod, signs in enumerate(PODS):
                if command * signs[axis] < 0:
                    bits |= 1 << (pod * 3 + axis)
    return bits


def to_texts(record: dict[str, Any]) -> dict[str, str]:
    """The record's values as stored in a hash: texts unchanged, the rest as JSON."""
    return {name: value if type(value) is str else json_text(value) for name, value in record.items()}


def json_text(value: Any) -> str:
    """JSON of a finite number, a boolean or a tuple of floats; json.dumps takes five times as long."""
    kind = type(value)
    if kind is tuple:
        return f"[{', '.join(map(repr, value))}]"
    if kind is bool:
        return "true" if value else "false"
    return repr(value)


def to_hash(texts: dict[str, str]) -> list[str]:
    """Alternating names and values, the arguments of HSET."""
    return [part for field in texts.items() for part in field]


def to_object(texts: dict[str, str]) -> str:
    """The record as a JSON object."""
    fields = [f'"{name}": {quoted(value) if name in TEXTS else value}' for name, value in texts.items()]
    return f"{{{', '.join(fields)}}}"


def from_hash(fields: dict[str, str], path: str) -> dict[str, Any]:
    """The record of a hash; raises Refusal with the name of a field that is not JSON."""
    record: dict[str, Any] = {}
    for name, value in fields.items():
        record[name] = value if name in TEXTS else parse_json(value, f"{path}.{name}")
    return record


def ship_of_record(record: dict[str, Any], classes: dict[str, ShipClass], bodies: list[Body], path: str) -> Ship:
    """The ship of a record; the inverse of ship_record."""
    data = mapping(record, path) | {"attitude": w_last(required(record, "attitude", path), f"{path}.attitude")}
    ship = load_ship(data, classes, bodies, path)
    ship.ship_id = text(required(record, "ship_id", path), f"{path}.ship_id")
    ship.player_id = text(record.get("player_id", ""), f"{path}.player_id", may_be_empty=True)
    ship.name = text(record.get("name", ""), f"{path}.name", may_be_empty=True)
    ship.touched = boolean(record.get("touched", False), f"{path}.touched")
    named = {name: record[name] for name in CONTROL_FIELDS if name in record}
    ship.controls = Controls(**load_controls_json(named, path))
    if record.get("input_seq"):
        ship.applied = Applied(
            text(required(record, "input_session", path), f"{path}.input_session"),
            whole(record["input_seq"], f"{path}.input_seq"),
            whole(required(record, "input_tick", path), f"{path}.input_tick"),
            whole(required(record, "input_substep", path), f"{path}.input_substep"),
            number(required(record, "input_margin", path), f"{path}.input_margin"),
        )
    return ship


def load_controls_json(data: Any, path: str) -> dict[str, Any]:
    """Controls in Redis's format, the quaternion's w first."""
    mapping(data, path)
    if "target_attitude" in data:
        data = data | {"target_attitude": w_last(data["target_attitude"], f"{path}.target_attitude")}
    return load_change(data, path)


def body_record(body: Body) -> dict[str, Any]:
    return {
        "name": body.name,
        "mass": body.mass,
        "radius": body.radius,
        "position": body.position,
        "velocity": body.velocity,
        "attitude": w_first(body.attitude),
        "angular_velocity": body.angular_velocity,
    }


def body_of_record(record: Any, path: str) -> Body:
    mapping(record, path)
    turned = {"attitude": w_last(required(record, "attitude", path), f"{path}.attitude")}
    return load_body(record | turned, path)


def input_record(given: Input) -> list[Any]:
    change = given.change
    if "target_attitude" in change:
        change = change | {"target_attitude": w_first(change["target_attitude"])}
    return [given.tick, given.substep, change, given.session, given.seq, given.arrived]


def input_of_record(record: Any, path: str) -> Input:
    if not isinstance(record, list) or len(record) != 6:
        raise Refusal(f"{path}: expected a list of 6, got {shown(record)}")
    tick, substep, change, session, seq, arrived = record
    return Input(
        whole(tick, f"{path}.tick"),
        whole(substep, f"{path}.substep"),
        load_controls_json(change, f"{path}.controls"),
        text(session, f"{path}.session"),
        whole(seq, f"{path}.seq", least=1),
        number(arrived, f"{path}.arrived"),
    )


def w_first(q: Quat) -> Quat:
    x, y, z, w = q
    return (w, x, y, z)


def w_last(q: Any, path: str) -> Quat:
    if not isinstance(q, list | tuple) or len(q) != 4:
        raise Refusal(f"{path}: expected 4 numbers [w, x, y, z]")
    w, x, y, z = q
    return (x, y, z, w)
