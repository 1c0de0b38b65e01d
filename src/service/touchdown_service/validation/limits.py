"""Ranges of input, and checks that refuse with the path of the field (the ranges of src/dynamics/constants/limits.ts).

A check returns the value as the simulation holds it (floats, tuples) or raises Refusal.
"""

import json
from dataclasses import dataclass
from math import isfinite, sqrt
from typing import Any


class Refusal(ValueError):
    """Invalid input: 'field: expected this, got that'."""


@dataclass(frozen=True, slots=True)
class Range:
    """`is_open`: `least` itself is out of range."""

    least: float
    most: float
    unit: str
    is_open: bool = False


SHIP_MASS = Range(1e-3, 1e15, "kg")
FUEL_MASS = Range(0, 1e15, "kg")
TANKS = Range(1e-6, 1e15, "kg")
SHIP_LENGTH = Range(0, 1e6, "m")
LEVER = Range(1e-3, 1e6, "m")
INERTIA = Range(1e-9, 1e27, "kg m^2")
FORCE = Range(0, 1e15, "N")
TORQUE = Range(0, 1e15, "N m")
WHEEL_CAPACITY = Range(0, 1e15, "N m s")
# Momentum of reaction wheels, including wheels without a capacity.
WHEEL_MOMENTUM = Range(-1e25, 1e25, "N m s")
ISP = Range(1e-3, 1e8, "s")
NATURAL_FREQUENCY = Range(0, 5, "rad/s", is_open=True)
INERTIA_RATIO = Range(1e-6, 1, "")
BODY_MASS = Range(0, 1e40, "kg", is_open=True)
BODY_RADIUS = Range(1e-3, 1e18, "m")
PLACE = Range(-1e18, 1e18, "m")
VELOCITY = Range(-1e9, 1e9, "m/s")
SPIN = Range(-1e6, 1e6, "rad/s")
SPEED = Range(0, 1e9, "m/s")
ANY = Range(-1e300, 1e300, "")

# Largest deviation of an attitude's length from 1; senders round.
UNIT_WITHIN = 1e-3
# Maximum length of a text, characters.
TEXT = 128


def parse_json(given: Any, field: str) -> Any:
    """Parses a JSON text; raises Refusal if it is invalid."""
    if not isinstance(given, str):
        raise Refusal(f"{field}: expected a string, got {shown(given)}")
    try:
        return json.loads(given)
    except (ValueError, RecursionError):
        raise Refusal(f"{field}: expected JSON, got {shown(given)}") from None


def number(value: Any, field: str, allowed: Range = ANY) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float) or not is_finite(value):
        raise Refusal(f"{field}: expected a finite number, got {shown(value)}")
    if value > allowed.most:
        raise Refusal(f"{field}: expected <= {allowed.most:g} {allowed.unit}".rstrip() + f", got {value:g}")
    if value < allowed.least or (allowed.is_open and value == allowed.least):
        sign = ">" if allowed.is_open else ">="
        raise Refusal(f"{field}: expected {sign} {allowed.least:g} {allowed.unit}".rstrip() + f", got {value:g}")
    return float(value)


def is_finite(value: int | float) -> bool:
    try:
        return isfinite(value)
    except OverflowError:  # an integer beyond doubles
        return False


def whole(value: Any, field: str, least: int = 0, most: int = 2**52) -> int:
    """A whole number, or its decimal text, as Redis holds it."""
    if isinstance(value, str) and value.isascii() and value.isdigit() and len(value) <= 16:
        value = int(value)
    if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= most:
        raise Refusal(f"{field}: expected a whole number from {least} to {most}, got {shown(value)}")
    return value


def vector(value: Any, field: str, allowed: Range = ANY, size: int = 3) -> tuple[float, ...]:
    if not isinstance(value, list | tuple) or len(value) != size:
        raise Refusal(f"{field}: expected {size} numbers, got {shown(value)}")
    return tuple([number(component, f"{field}[{i}]", allowed) for i, component in enumerate(value)])


def attitude(value: Any, field: str) -> tuple[float, ...]:
    """A unit quaternion, its components in the given order."""
    a, b, c, d = q = vector(value, field, size=4)
    length = sqrt(a * a + b * b + c * c + d * d)
    if not abs(length - 1) <= UNIT_WITHIN:
        raise Refusal(f"{field}: expected length 1 within {UNIT_WITHIN}, got {length:g}")
    return q


def text(value: Any, field: str, may_be_empty: bool = False, most: int = TEXT) -> str:
    if not isinstance(value, str) or not is_encodable(value):
        raise Refusal(f"{field}: expected a string, got {shown(value)}")
    if len(value) > most:
        raise Refusal(f"{field}: expected at most {most} characters, got {len(value)}")
    if value == "" and not may_be_empty:
        raise Refusal(f"{field}: expected a non-empty string")
    return value


def is_encodable(value: str) -> bool:
    """A text without lone surrogates."""
    try:
        value.encode()
    except UnicodeEncodeError:
        return False
    return True


def boolean(value: Any, field: str) -> bool:
    if not isinstance(value, bool):
        raise Refusal(f"{field}: expected true or false, got {shown(value)}")
    return value


def one_of(value: Any, field: str, names: tuple[str, ...]) -> str:
    if isinstance(value, str) and value in names:
        return value
    raise Refusal(f"{field}: expected one of {', '.join(repr(name) for name in names)}, got {shown(value)}")


def mapping(value: Any, field: str) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise Refusal(f"{field}: expected an object, got {shown(value)}")
    return value


def listed(value: Any, field: str) -> list[Any]:
    if not isinstance(value, list):
        raise Refusal(f"{field}: expected a list, got {shown(value)}")
    return value


def required(data: dict[str, Any], name: str, field: str) -> Any:
    if name not in data:
        raise Refusal(f"{field}.{name}: missing" if field else f"{name}: missing")
    return data[name]


def known_fields(data: dict[str, Any], names: set[str] | frozenset[str], field: str) -> None:
    unknown = sorted(set(data) - names)
    if unknown:
        raise Refusal(f"{field}.{unknown[0]}: no such field" if field else f"{unknown[0]}: no such field")


def shown(value: Any) -> str:
    """A short description of a value, for messages."""
    try:
        said = repr(value)
    except (ValueError, RecursionError):
        said = type(value).__name__
    return said if len(said) <= 60 else said[:57] + "..."
