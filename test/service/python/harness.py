"""A real Redis and a real service for the tests, as separate processes that can be killed."""

import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from redis import Redis
from redis.exceptions import RedisError

SERVICE_HOME = Path(__file__).resolve().parents[3] / "src" / "service"
sys.path.insert(0, str(SERVICE_HOME))

SITE = [0.6, 0.48, 0.64]
# Seconds after which a condition counts as failed: for hangs alone, a busy machine takes a minute for what takes a second.
PATIENCE = 180


class RedisServer:
    """redis-server with an append-only file in its own folder."""

    def __init__(self, fsync: str = "always") -> None:
        self.folder = tempfile.mkdtemp(prefix="touchdown-redis-")
        self.port = free_port()
        self.fsync = fsync
        self.process: subprocess.Popen | None = None
        self.start()

    @property
    def url(self) -> str:
        return f"redis://127.0.0.1:{self.port}/0"

    def client(self) -> Redis:
        return Redis(port=self.port, decode_responses=True)

    def start(self) -> None:
        command = ["redis-server", "--port", str(self.port), "--bind", "127.0.0.1", "--dir", self.folder]
        command += ["--save", "", "--appendonly", "yes", "--appendfsync", self.fsync]
        self.process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        until(self.answers, "redis-server answers")

    def answers(self) -> bool:
        try:
            return bool(self.client().ping())
        except RedisError:
            return False

    def kill(self) -> None:
        kill(self.process)

    def close(self) -> None:
        self.kill()
        shutil.rmtree(self.folder, ignore_errors=True)


class ServiceProcess:
    """`python -m touchdown_service`, with its output in a file."""

    def __init__(self, redis: RedisServer, *arguments: str) -> None:
        # Without a name: it goes with this process, however that ends.
        self.log = tempfile.TemporaryFile()
        command = [sys.executable, "-m", "touchdown_service", "--redis", redis.url]
        command += ["--lease-ms", "400", *arguments]
        self.process = subprocess.Popen(command, cwd=SERVICE_HOME, stdout=self.log, stderr=self.log)

    def words(self) -> str:
        # Not by the file's own position, at which the service writes.
        return os.pread(self.log.fileno(), os.fstat(self.log.fileno()).st_size, 0).decode()

    def kill(self) -> None:
        kill(self.process)

    def terminate(self) -> int:
        self.process.send_signal(signal.SIGTERM)
        return self.process.wait(PATIENCE)

    def close(self) -> None:
        self.kill()
        self.log.close()


def kill(process: subprocess.Popen | None) -> None:
    """kill -9: no output, no clean-up."""
    if process is not None and process.poll() is None:
        process.kill()
        process.wait()


def free_port() -> int:
    with socket.socket() as bound:
        bound.bind(("127.0.0.1", 0))
        return bound.getsockname()[1]


def until(condition: Callable[[], Any], what: str, service: ServiceProcess | None = None) -> Any:
    """The condition's value once it is true. Raises AssertionError if it does not become true."""
    deadline = time.monotonic() + PATIENCE
    while time.monotonic() < deadline:
        value = condition()
        if value:
            return value
        time.sleep(0.01)
    raise AssertionError(f"never: {what}\n{service.words() if service else ''}")


def send(client: Redis, type: str, **data: Any) -> str:
    """Adds a command to the inbox; returns its id."""
    return client.xadd("touchdown:inbox", {"type": type, "data": json.dumps(data)})


def control(client: Redis, seq: int, controls: dict[str, Any], **at: Any) -> str:
    """Controls of s1, with the given fields of the entry."""
    entry = {"type": "controls", "ship_id": "s1", "session": "page", "seq": seq} | at
    return client.xadd("touchdown:inbox", entry | {"controls": json.dumps(controls)})


def lander(ship_id: str = "s1", **order: Any) -> dict[str, Any]:
    """A lander above level ground, to spawn."""
    place = {"body": "Luna", "direction": SITE, "height": 40}
    return {"ship_id": ship_id, "player_id": f"pilot of {ship_id}", "ship_class": "planetary_lander"} | place | order


def frames(client: Redis) -> list[dict[str, Any]]:
    return [json.loads(entry["frame"]) for _, entry in client.xrange("touchdown:frames")]


def result_of(client: Redis, entry_id: str) -> dict[str, Any] | None:
    """The result of an inbox entry, once a frame reports it."""
    told = [result for frame in frames(client) for result in frame["results"] if result["id"] == entry_id]
    return told[0] if told else None


def entries(client: Redis, stream: str) -> list[dict[str, str]]:
    return [entry for _, entry in client.xrange(stream)]
