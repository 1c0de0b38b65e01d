"""Spawns ships from a full state, or at a place above a body's ground (REDIS.md, Commands)."""

from math import cos, radians, sin, sqrt
from typing import Any

from ..law.vectors import (
    Mat3,
    Quat,
    Vec3,
    add,
    axes_of,
    cross,
    normalize,
    perpendicular_axis,
    product,
    rotate,
    scale,
    unit,
)
from ..models import Body, Ship, ShipClass, TerrainHeight
from ..storage.records import ship_of_record
from ..validation.limits import (
    PLACE,
    SPIN,
    VELOCITY,
    Refusal,
    known_fields,
    mapping,
    number,
    one_of,
    required,
    text,
    vector,
)

IDENTITY = frozenset({"ship_id", "player_id", "name", "ship_class", "fuel", "ground_contact_offset"})
PLACE_FIELDS = IDENTITY | {"body", "direction", "height", "velocity", "heading", "tilt", "lean_to", "spin"}
STATE_FIELDS = IDENTITY | {
    "reference_body", "relative_position", "relative_velocity", "attitude", "angular_velocity",
    "surface_contact_state", "contact_impact_speed", "wheel_momentum",
}  # fmt: skip
POLE: Vec3 = (0.0, 1.0, 0.0)


def ship_of_order(data: Any, classes: dict[str, ShipClass], bodies: list[Body], terrain_height: TerrainHeight) -> Ship:
    """Raises Refusal with the invalid field."""
    mapping(data, "data")
    ship_id = text(required(data, "ship_id", ""), "ship_id")
    order = {"ship_class": "fast_frigate", "player_id": "", "name": ship_id} | data
    cls = classes[one_of(order["ship_class"], "ship_class", tuple(classes))]
    order.setdefault("fuel", cls.fuel_capacity)
    if "body" in order:
        known_fields(order, PLACE_FIELDS, "")
        order |= state_at_place(order, cls, bodies, terrain_height)
    else:
        known_fields(order, STATE_FIELDS, "")
    return ship_of_record(order, classes, bodies, "data")


def state_at_place(
    order: dict[str, Any], cls: ShipClass, bodies: list[Body], terrain_height: TerrainHeight
) -> dict[str, Any]:
    """The state of a ship above a place, from its attitude and velocity relative to the ground."""
    name = one_of(order["body"], "body", tuple(body.name for body in bodies))
    body = next(body for body in bodies if body.name == name)
    towards = vector(required(order, "direction", ""), "direction", PLACE)
    if not max(map(abs, towards)) > 1e-9:
        raise Refusal("direction: expected a length > 0")
    direction = unit(scale(towards, 1 / max(map(abs, towards))))
    height = number(required(order, "height", ""), "height", PLACE)
    moving = vector(order.get("velocity", (0, 0, 0)), "velocity", VELOCITY)
    spin = vector(order.get("spin", (0, 0, 0)), "spin", SPIN)
    angles = [number(order.get(name, 0), name) for name in ("heading", "tilt", "lean_to")]
    offset = order.get("ground_contact_offset", cls.ground_contact_offset)
    offset = number(offset, "ground_contact_offset", PLACE)
    reach = body.radius + terrain_height(name, *direction) + offset + height
    axes = local_axes(direction, axes_of(body.attitude))
    position = scale(rotate(axes, (0.0, 0.0, 1.0)), reach)
    x, y, z, w = attitude_on_ground(axes, *map(radians, angles))
    return {
        "reference_body": name,
        "relative_position": position,
        "relative_velocity": add(cross(body.angular_velocity, position), rotate(axes, moving)),
        "attitude": (w, x, y, z),
        "angular_velocity": add(body.angular_velocity, rotate(axes, spin)),
    }


def local_axes(direction: Vec3, body_axes: Mat3) -> Mat3:
    """Rotation matrix with columns east, north, up at a place, ICRF."""
    across = cross(POLE, direction)
    level = sqrt(across[0] * across[0] + across[2] * across[2])
    east = scale(across, 1 / level) if level > 1e-9 else perpendicular_axis(direction)
    north = cross(direction, east)
    e, n, u = (rotate(body_axes, axis) for axis in (east, north, direction))
    return (e[0], n[0], u[0], e[1], n[1], u[1], e[2], n[2], u[2])


def attitude_on_ground(axes: Mat3, heading: float, tilt: float, lean_to: float) -> Quat:
    """Attitude of an upright ship with +Y towards `heading`, then tilted towards `lean_to`; radians."""
    upright = quaternion_of(axes)
    turn = (0.0, 0.0, -sin(heading / 2), cos(heading / 2))
    # Rotation axis: up x the lean direction.
    half = sin(tilt / 2)
    lean = (-cos(lean_to) * half, sin(lean_to) * half, 0.0, cos(tilt / 2))
    return product(upright, product(lean, turn))


def quaternion_of(m: Mat3) -> Quat:
    """Quaternion of a rotation matrix, row by row; solved for the largest component, which avoids cancellation."""
    a, b, c, d, e, f, g, h, i = m
    if a + e + i > 0:
        q = (h - f, c - g, d - b, 1 + a + e + i)
    elif a >= e and a >= i:
        q = (1 + a - e - i, b + d, c + g, h - f)
    elif e >= i:
        q = (b + d, 1 - a + e - i, f + h, c - g)
    else:
        q = (c + g, f + h, 1 - a - e + i, d - b)
    return normalize(q)
