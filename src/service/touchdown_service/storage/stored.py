"""Clock and maneuvers as Redis holds them, read back."""

from ..maneuver_landing import Landing
from ..runtime.galaxy import Galaxy, Tempo
from ..validation.limits import SPEED, mapping, number, required, text, whole
from .records import from_hash

CLOCK = "touchdown:clock"


def load_clock(galaxy: Galaxy, clock: dict[str, str]) -> None:
    data = from_hash({name: value for name, value in clock.items() if name not in ("cursor", "commit")}, CLOCK)
    mapping(data, CLOCK)
    galaxy.tick = whole(required(data, "tick", CLOCK), f"{CLOCK}.tick")
    galaxy.game_time = number(required(data, "game_time", CLOCK), f"{CLOCK}.game_time")
    galaxy.cursor = text(required(clock, "cursor", CLOCK), f"{CLOCK}.cursor")
    galaxy.tempo = Tempo(
        number(required(data, "tick_rate", CLOCK), f"{CLOCK}.tick_rate"),
        number(required(data, "time_scale", CLOCK), f"{CLOCK}.time_scale"),
        bool(required(data, "paused", CLOCK)),
        number(required(data, "asked_scale", CLOCK), f"{CLOCK}.asked_scale"),
        bool(required(data, "time_sync", CLOCK)),
    )


def load_landing(fields: dict[str, str]) -> Landing:
    ticks = [whole(fields.get(name, "0"), f"maneuver.{name}") for name in ("started_tick", "updated_tick")]
    data = from_hash({"touch_speed": fields.get("touch_speed", "0")}, "maneuver")
    touch_speed = number(data["touch_speed"], "maneuver.touch_speed", SPEED)
    return Landing(fields.get("phase", ""), fields.get("reason", ""), *ticks, touch_speed)


def landing_values(landing: Landing) -> tuple:
    ticks = landing.started_tick, landing.updated_tick
    return ("landing", landing.phase, landing.reason, *ticks, repr(landing.touch_speed))
