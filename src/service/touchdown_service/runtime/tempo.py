"""Tick rate, time scale, pause and time sync, as requested by game:*."""

import re
from dataclasses import replace
from typing import Any

from ..config import TICK_RATE, TIME_SCALE
from ..validation.limits import Range, Refusal, number
from .galaxy import Tempo

# Length of a value of game:*, bytes.
MAX_REQUEST = 64
DECIMAL = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?")
# Maximum deviation of the effective time scale under time sync, as a share of game:time_scale.
SYNC_SHARE = 0.05
# Time over which time sync recovers lost wall time, as far as SYNC_SHARE allows, wall s.
SYNC_SECONDS = 10


def next_tempo(now: Tempo, requests: dict[str, str | None], behind: float) -> tuple[Tempo, list[str]]:
    """The tempo from this boundary on, and the requests that were refused, with the reason.

    `requests`: values of game:*, each up to the byte that makes it too long; None for a key without a text.
    `behind`: wall seconds by which game time has fallen behind its schedule, for time sync.
    """
    refusals: list[str] = []

    def value_of(key: str, held: Any, read: Any) -> Any:
        value = requests.get(key)
        if value is None:
            return held
        try:
            if len(value.encode()) > MAX_REQUEST:
                raise Refusal(f"{key}: expected at most {MAX_REQUEST} bytes")
            return read(value, key)
        except Refusal as refusal:
            refusals.append(str(refusal))
            return held

    tempo = replace(
        now,
        tick_rate=value_of("game:tick_rate", now.tick_rate, number_in(TICK_RATE)),
        requested_scale=value_of("game:time_scale", now.requested_scale, number_in(TIME_SCALE)),
        paused=value_of("game:paused", now.paused, read_boolean),
        time_sync=value_of("game:time_sync", now.time_sync, read_boolean),
    )
    share = max(-SYNC_SHARE, min(SYNC_SHARE, behind / SYNC_SECONDS)) if tempo.time_sync else 0.0
    scale = tempo.requested_scale * (1 + share)
    return replace(tempo, time_scale=max(TIME_SCALE.least, min(TIME_SCALE.most, scale))), refusals


def number_in(allowed: Range):
    def read(value: str, key: str) -> float:
        # float() alone also accepts 1_0 and digits of other scripts.
        if not DECIMAL.fullmatch(value):
            raise Refusal(f"{key}: expected a number, got {value[:40]!r}")
        return number(float(value), key, allowed)

    return read


def read_boolean(value: str, key: str) -> bool:
    if value.lower() in ("true", "1"):
        return True
    if value.lower() in ("false", "0"):
        return False
    raise Refusal(f"{key}: expected true or false, got {value[:40]!r}")
