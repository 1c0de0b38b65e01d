"""Plain data (JSON, Redis) converted to the simulation's objects; everything is checked, and refused by the path of its field.

Quaternions are given here as (x, y, z, w); redis_state turns them about.
"""

from dataclasses import fields
from math import sqrt
from typing import Any

from ..law.vectors import Quat
from ..models import SURFACE_CONTACT_STATES, Body, Controls, Ship, ShipClass
from .limits import (
    BODY_MASS,
    BODY_RADIUS,
    FORCE,
    FUEL_MASS,
    INERTIA,
    INERTIA_RATIO,
    ISP,
    LEVER,
    NATURAL_FREQUENCY,
    PLACE,
    SHIP_LENGTH,
    SHIP_MASS,
    SPEED,
    SPIN,
    TANKS,
    TORQUE,
    VELOCITY,
    WHEEL_CAPACITY,
    WHEEL_MOMENTUM,
    Range,
    Refusal,
    attitude,
    boolean,
    known_fields,
    mapping,
    number,
    one_of,
    required,
    text,
    vector,
)

CLASS_SCALARS = {
    "dry_mass": SHIP_MASS,
    "fuel_capacity": FUEL_MASS,
    "ground_contact_offset": SHIP_LENGTH,
    "leg_radius": LEVER,
    "main_engine_thrust": FORCE,
    "attitude_natural_frequency": NATURAL_FREQUENCY,
}
CLASS_VECTORS = {"rcs_thrust": FORCE, "rcs_torque": TORQUE, "reaction_wheel_torque": TORQUE}
CLASS_FIELDS = frozenset(f.name for f in fields(ShipClass) if f.init)
# Determinant over the cube of the mean moment: thinner tensors spin up without bound on their side (DYNAMICS, Ranges).
MIN_ROUNDNESS = 1e-6


def load_ship_class(data: Any, path: str = "ship_class") -> ShipClass:
    mapping(data, path)
    known_fields(data, CLASS_FIELDS, path)
    given: dict[str, Any] = {"name": text(required(data, "name", path), f"{path}.name")}
    for name, allowed in CLASS_SCALARS.items():
        given[name] = number(required(data, name, path), f"{path}.{name}", allowed)
    for name, allowed in CLASS_VECTORS.items():
        given[name] = vector(required(data, name, path), f"{path}.{name}", allowed)
    turns_by_rcs = max(given["rcs_torque"]) > 0
    burns_rcs = turns_by_rcs or max(given["rcs_thrust"]) > 0
    # Checked only where they divide something.
    divisors = {
        "main_engine_isp": (given["main_engine_thrust"] > 0, ISP),
        "rcs_lever": (turns_by_rcs, LEVER),
        "rcs_isp": (burns_rcs, ISP),
    }
    for name, (divides, allowed) in divisors.items():
        given[name] = number(
            required(data, name, path), f"{path}.{name}", allowed if divides else Range(-1e300, 1e300, "")
        )
    if given["fuel_capacity"] > 0:
        number(given["fuel_capacity"], f"{path}.fuel_capacity", TANKS)
    if data.get("dry_inertia_ratio") is not None:
        given["dry_inertia_ratio"] = number(data["dry_inertia_ratio"], f"{path}.dry_inertia_ratio", INERTIA_RATIO)
    if data.get("reaction_wheel_capacity") is not None:
        capacity = vector(data["reaction_wheel_capacity"], f"{path}.reaction_wheel_capacity", WHEEL_CAPACITY)
        given["reaction_wheel_capacity"] = capacity
    given["inertia_tensor"] = load_tensor(required(data, "inertia_tensor", path), f"{path}.inertia_tensor")
    return ShipClass(**given)


def load_tensor(value: Any, path: str) -> list[list[float]]:
    """Symmetric, positive definite (Sylvester), and with moments that are not too far apart."""
    if not isinstance(value, list | tuple) or len(value) != 3:
        raise Refusal(f"{path}: expected 3 rows of 3 numbers")
    a, b, c = rows = [list(vector(row, f"{path}[{i}]")) for i, row in enumerate(value)]
    for i in range(3):
        if not rows[i][i] > 0:
            raise Refusal(f"{path}[{i}][{i}]: expected > 0, as a positive definite tensor has, got {rows[i][i]:g}")
        number(rows[i][i], f"{path}[{i}][{i}]", INERTIA)
    mean = (a[0] + b[1] + c[2]) / 3
    skew = max(abs(a[1] - b[0]), abs(a[2] - c[0]), abs(b[2] - c[1]))
    if not skew <= 3e-9 * mean:
        raise Refusal(f"{path}: expected a symmetric tensor, got elements that differ by {skew:g} kg m^2")
    determinant = (
        a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
    )
    if not (a[0] * b[1] - a[1] * b[0] > 0 and determinant > 0):
        raise Refusal(f"{path}: expected a positive definite tensor")
    if not determinant / (mean * mean * mean) >= MIN_ROUNDNESS:
        raise Refusal(f"{path}: expected a determinant of at least {MIN_ROUNDNESS:g} of its mean moment cubed")
    return rows


def load_body(data: Any, path: str = "body") -> Body:
    mapping(data, path)
    return Body(
        name=text(required(data, "name", path), f"{path}.name"),
        mass=number(required(data, "mass", path), f"{path}.mass", BODY_MASS),
        radius=number(required(data, "radius", path), f"{path}.radius", BODY_RADIUS),
        position=vector(required(data, "position", path), f"{path}.position", PLACE),
        velocity=vector(required(data, "velocity", path), f"{path}.velocity", VELOCITY),
        attitude=attitude(required(data, "attitude", path), f"{path}.attitude"),
        angular_velocity=vector(required(data, "angular_velocity", path), f"{path}.angular_velocity", SPIN),
    )


def load_ship(data: Any, classes: dict[str, ShipClass], bodies: list[Body], path: str = "ship") -> Ship:
    """A ship's simulated state, with neutral controls."""
    mapping(data, path)

    def given(name: str) -> Any:
        return required(data, name, path)

    class_name = one_of(given("ship_class"), f"{path}.ship_class", tuple(classes))
    body_name = one_of(given("reference_body"), f"{path}.reference_body", tuple(body.name for body in bodies))
    position = vector(given("relative_position"), f"{path}.relative_position", PLACE)
    x, y, z = position
    if not x * x + y * y + z * z >= 1:
        raise Refusal(f"{path}.relative_position: expected >= 1 m from the body's centre")
    cls = classes[class_name]
    offset = data.get("ground_contact_offset")
    if offset is None:
        offset = cls.ground_contact_offset
    return Ship(
        ship_class=cls,
        body=next(body for body in bodies if body.name == body_name),
        position=position,
        velocity=vector(given("relative_velocity"), f"{path}.relative_velocity", VELOCITY),
        attitude=attitude(given("attitude"), f"{path}.attitude"),
        angular_velocity=vector(given("angular_velocity"), f"{path}.angular_velocity", SPIN),
        fuel=number(given("fuel"), f"{path}.fuel", FUEL_MASS),
        ground_contact_offset=number(offset, f"{path}.ground_contact_offset", SHIP_LENGTH),
        wheel_momentum=vector(data.get("wheel_momentum", (0, 0, 0)), f"{path}.wheel_momentum", WHEEL_MOMENTUM),
        impact_speed=number(data.get("contact_impact_speed", 0), f"{path}.contact_impact_speed", SPEED),
        surface_contact_state=one_of(
            data.get("surface_contact_state", ""), f"{path}.surface_contact_state", SURFACE_CONTACT_STATES
        ),
        crashed=boolean(data.get("crashed", False), f"{path}.crashed"),
    )


def load_change(data: Any, path: str = "controls") -> dict[str, Any]:
    """The controls in `data`, clamped into range, the target normalized. An unknown mode is kept and damps rates."""
    mapping(data, path)
    known_fields(data, CONTROL_FIELDS, path)
    change: dict[str, Any] = {}
    if "thrust_level" in data:
        change["thrust_level"] = clamp(number(data["thrust_level"], f"{path}.thrust_level"), 0.0)
    for name in ("translation_input", "rotation_input"):
        if name in data:
            change[name] = tuple([clamp(value, -1.0) for value in vector(data[name], f"{path}.{name}")])
    if "attitude_hold" in data:
        change["attitude_hold"] = boolean(data["attitude_hold"], f"{path}.attitude_hold")
    if "attitude_mode" in data:
        change["attitude_mode"] = text(data["attitude_mode"], f"{path}.attitude_mode", may_be_empty=True) or "none"
    if "target_attitude" in data:
        target = vector(data["target_attitude"], f"{path}.target_attitude", size=4)
        change["target_attitude"] = unit_quaternion(target, f"{path}.target_attitude")
    return change


CONTROL_FIELDS = frozenset(f.name for f in fields(Controls) if f.init)


def clamp(value: float, low: float) -> float:
    return low if value < low else min(value, 1.0)


def unit_quaternion(q: Quat, path: str) -> Quat:
    """A unit target is not normalized again, so that a stored input replays to the same bits."""
    x, y, z, w = q
    size = sqrt(x * x + y * y + z * z + w * w)
    if not 1e-3 < size < 1e3:
        raise Refusal(f"{path}: expected a quaternion of length 1, got {size:g}")
    return q if abs(size - 1) <= 1e-12 else (x / size, y / size, z / size, w / size)
