"""A real Redis and a real service for the tests, as separate processes that can be killed."""

import json
import multiprocessing
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
import touchdown_service.__main__  # noqa: E402

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
        """kill -9: no output, no clean-up."""
        if self.process is not None and self.process.poll() is None:
            self.process.kill()
            self.process.wait()

    def close(self) -> None:
        self.kill()
        shutil.rmtree(self.folder, ignore_errors=True)


class Program:
    """A program of the service in a separate process, with its output in a file.

    A fork of this process: to start Python and to import the Redis client anew costs more than most tests. By their commands the
    programs are started in record_landing.py, by the gateway's tests and by package.long.test.ts.
    """

    def __init__(self, main: Callable[[], None], *command: str) -> None:
        # Without a name: it goes with this process, however that ends.
        self.log = tempfile.TemporaryFile()
        self.process = multiprocessing.get_context("fork").Process(target=run, args=(main, command, self.log.fileno()))
        self.process.start()

    def words(self) -> str:
        # Not by the file's own position, at which the program writes.
        return os.pread(self.log.fileno(), os.fstat(self.log.fileno()).st_size, 0).decode()

    def signal(self, number: int) -> None:
        os.kill(self.process.pid, number)

    def wait(self) -> int:
        """Its exit code once it has ended."""
        self.process.join(PATIENCE)
        if self.process.exitcode is None:
            raise AssertionError(f"never: it ends\n{self.words()}")
        return self.process.exitcode

    def kill(self) -> None:
        """kill -9: no output, no clean-up."""
        self.process.kill()
        self.process.join()

    def terminate(self) -> int:
        self.signal(signal.SIGTERM)
        return self.wait()

    def close(self) -> None:
        self.kill()
        self.log.close()


def run(main: Callable[[], None], command: tuple[str, ...], log: int) -> None:
    os.dup2(log, 1)
    os.dup2(log, 2)
    sys.argv = list(command)
    main()


class ServiceProcess(Program):
    def __init__(self, redis: RedisServer, *arguments: str) -> None:
        command = ["touchdown-service", "--redis", redis.url, "--lease-ms", "400", *arguments]
        super().__init__(touchdown_service.__main__.main, *command)


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


def frames(client: Redis, having: str = "") -> list[dict[str, Any]]:
    """The frames whose text has the given one."""
    texts = [entry["frame"] for _, entry in client.xrange("touchdown:frames")]
    return [json.loads(text) for text in texts if having in text]


def result_of(client: Redis, entry_id: str) -> dict[str, Any] | None:
    """The result of an inbox entry, once a frame reports it."""
    told = [result for frame in frames(client, entry_id) for result in frame["results"] if result["id"] == entry_id]
    return told[0] if told else None


def entries(client: Redis, stream: str) -> list[dict[str, str]]:
    return [entry for _, entry in client.xrange(stream)]
