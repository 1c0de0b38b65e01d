"""Controls and commands from touchdown:inbox. Each entry is applied or refused as a whole (REDIS.md, touchdown:inbox)."""

from bisect import insort
from math import ceil
from typing import Any

from ..maneuver_landing import Landing
from ..models import Input, Ship
from ..storage.records import load_controls_json
from ..storage.stored import MAX_SHIPS
from ..validation.limits import Refusal, mapping, one_of, parse_json, required, text, whole
from .galaxy import Changes, Galaxy, end_landing, remove_ship
from .spawning import ship_of_order

# Maximum queued inputs per ship: twice ten wall seconds with a change every 10 ms.
MAX_PENDING = 2048
MAX_SUBSTEPS = 100_000
# How far an input may be ahead, in addition to one tick, wall s.
MAX_AHEAD = 10
# Maximum characters of an entry's JSON.
MAX_JSON = 16_384


def apply_entries(galaxy: Galaxy, entries: list[tuple[str, dict[str, str]]], changes: Changes) -> None:
    """Applies commands and queues inputs in order; advances the cursor."""
    for entry_id, entry in entries:
        kind = entry.get("type", "")
        try:
            act = HANDLERS.get(kind)
            if act is None:
                raise Refusal(f"type: expected one of {', '.join(HANDLERS)}, got {kind[:60]!r}")
            act(galaxy, entry_id, entry, changes)
        except Refusal as refusal:
            changes.results.append(result(entry_id, kind, entry, str(refusal)))
        else:
            if kind != "controls":
                changes.results.append(result(entry_id, kind, entry, ""))
        galaxy.cursor = entry_id


def result(entry_id: str, kind: str, entry: dict[str, str], reason: str) -> dict[str, Any]:
    said = {"id": entry_id, "type": kind[:60], "ok": reason == "", "reason": reason}
    if kind == "controls":
        said |= {name: entry.get(name, "")[:128] for name in ("ship_id", "session", "seq")}
    return said


def queue_controls(galaxy: Galaxy, entry_id: str, entry: dict[str, str], changes: Changes) -> None:
    ship = ship_named(galaxy, entry.get("ship_id"))
    if entry.get("player_id", ship.player_id) != ship.player_id:
        raise Refusal("player_id: this ship is another player's")
    session = text(required(entry, "session", ""), "session", most=64)
    seq = whole(required(entry, "seq", ""), "seq", least=1)
    at = galaxy.tick, 0
    if "tick" in entry:
        at = whole(entry["tick"], "tick"), whole(entry.get("substep", 0), "substep", most=MAX_SUBSTEPS - 1)
    latest = galaxy.tick + 1 + ceil(MAX_AHEAD * galaxy.tempo.tick_rate)
    if at[0] > latest:
        raise Refusal(f"tick: expected at most {latest}, got {at[0]}")
    change = load_controls_json(parsed(entry, "controls"), "controls")
    if is_known(ship, session, seq):
        return
    # The page was reloaded: inputs that the old page scheduled are obsolete.
    ship.pending = [waiting for waiting in ship.pending if waiting.session == session]
    if len(ship.pending) >= MAX_PENDING:
        raise Refusal(f"seq: {MAX_PENDING} inputs are waiting already")
    arrived = int(entry_id.split("-")[0]) / 1000
    if at[0] < galaxy.tick:
        # A late input applies at once, after earlier ones; its margin records how late it was.
        arrived += (galaxy.tick - at[0]) / galaxy.tempo.tick_rate
        at = galaxy.tick, 0
    insort(ship.pending, Input(*at, change, session, seq, arrived), key=lambda i: (i.tick, i.substep, i.seq))


def is_known(ship: Ship, session: str, seq: int) -> bool:
    last = ship.applied
    if last and last.session == session and seq <= last.seq:
        return True
    return any(waiting.seq == seq and waiting.session == session for waiting in ship.pending)


def spawn(galaxy: Galaxy, entry_id: str, entry: dict[str, str], changes: Changes) -> None:
    ship = ship_of_order(parsed(entry, "data"), galaxy.classes, galaxy.world.bodies, galaxy.world.terrain_height)
    if ship.ship_id in galaxy.ships:
        raise Refusal(f"ship_id: {ship.ship_id} exists already")
    add_ship(galaxy, ship)


def respawn(galaxy: Galaxy, entry_id: str, entry: dict[str, str], changes: Changes) -> None:
    ship = ship_of_order(parsed(entry, "data"), galaxy.classes, galaxy.world.bodies, galaxy.world.terrain_height)
    before = galaxy.ships.get(ship.ship_id)
    if before:
        # Sequence numbers of the pilot's inputs continue.
        ship.applied = before.applied
        end_landing(galaxy, ship.ship_id, "respawned")
    add_ship(galaxy, ship)


def add_ship(galaxy: Galaxy, ship: Ship) -> None:
    if len(galaxy.ships) >= MAX_SHIPS and ship.ship_id not in galaxy.ships:
        raise Refusal(f"ships: the limit of {MAX_SHIPS} is reached")
    galaxy.ships[ship.ship_id] = ship


def remove(galaxy: Galaxy, entry_id: str, entry: dict[str, str], changes: Changes) -> None:
    data = mapping(parsed(entry, "data"), "data")
    ship = ship_named(galaxy, data.get("ship_id"))
    reason = text(data.get("reason", "removed"), "reason")
    end_landing(galaxy, ship.ship_id, reason)
    remove_ship(galaxy, ship.ship_id, reason, changes)


def maneuver(galaxy: Galaxy, entry_id: str, entry: dict[str, str], changes: Changes) -> None:
    data = mapping(parsed(entry, "data"), "data")
    ship = ship_named(galaxy, data.get("ship_id"))
    if one_of(data.get("maneuver"), "maneuver", ("landing", "none")) == "none":
        end_landing(galaxy, ship.ship_id, "ended by command")
    else:
        ship.pending.clear()
        galaxy.landings[ship.ship_id] = Landing(started_tick=galaxy.tick, updated_tick=galaxy.tick)


HANDLERS = {
    "controls": queue_controls,
    "spawn": spawn,
    "respawn": respawn,
    "remove": remove,
    "maneuver": maneuver,
}


def ship_named(galaxy: Galaxy, ship_id: Any) -> Ship:
    ship = galaxy.ships.get(text(ship_id, "ship_id"))
    if ship is None:
        raise Refusal(f"ship_id: no ship named {ship_id}")
    return ship


def parsed(entry: dict[str, str], field: str) -> Any:
    given = required(entry, field, "")
    if len(given) > MAX_JSON:
        raise Refusal(f"{field}: expected at most {MAX_JSON} characters, got {len(given)}")
    return parse_json(given, field)
