"""Types of the keys that a tick adds to. Redis applies a transaction except for commands on a key of another type."""

from redis import Redis

from ..runtime.galaxy import Galaxy
from ..validation.limits import Refusal
from .frames import EVENTS, FRAMES, GALAXY_SHIPS

STATUS = "touchdown:status"


def check_written(client: Redis, galaxy: Galaxy) -> None:
    """Raises Refusal with the first key that a tick of this galaxy could not be written to."""
    bodies = {f"body:{body.name}": "hash" for body in galaxy.world.bodies}
    sets = {f"system:{galaxy.system_id}:{members}": "set" for members in ("ships", "bodies")}
    streams = dict.fromkeys((FRAMES, EVENTS, GALAXY_SHIPS), "stream")
    check_types(client, {STATUS: "hash"} | streams | sets | bodies)


def check_types(client: Redis, types: dict[str, str]) -> None:
    """Raises Refusal with the first key that Redis holds as another type: a command on it would fail."""
    pipe = client.pipeline(transaction=False)
    for key in types:
        pipe.type(key)
    for (key, expected), found in zip(types.items(), pipe.execute()):
        if found not in (expected, "none"):
            raise Refusal(f"{key}: expected a {expected}, got a {found}")
