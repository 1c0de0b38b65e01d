"""The service's loop: the schedule of ticks, requests at each boundary, and recovery when Redis or the lease is lost."""

import logging
import os
import time
from typing import Any

from redis import Redis
from redis.exceptions import RedisError

from ..redis_state import RedisState, Requests
from ..validation.limits import Refusal
from .galaxy import Changes, Galaxy, run_interval
from .inbox import apply_entries
from .lease import Lease, LeaseLost
from .tempo import next_tempo

log = logging.getLogger("touchdown_service")

# Maximum number of boundaries to catch up on after a stall; the schedule shifts by the rest.
MAX_CATCH_UP = 5
# Interval at which requests are read while paused, wall s.
PAUSE_POLL = 0.1
# Interval at which Redis's clock is read, wall s.
CLOCK_INTERVAL = 60
RETRY_SECONDS = 0.5
# Interval at which a waiting loop checks for a stop request, wall s.
LOOK_UP = 0.2


class Service:
    """Runs one world. `definition` creates the world if Redis holds none."""

    def __init__(self, client: Redis, definition: dict[str, Any], lease_ms: int = 3000) -> None:
        self.client = client
        self.definition = definition
        self.lease = Lease(client, lease_ms)
        self.state = RedisState(client, self.lease)
        self.stopping = False
        self.slipped = 0
        # Lag of game time behind wall time, wall s.
        self.lost = 0.0
        self.refused = ""
        # Refusals of the last boundary: a value that stays invalid is logged once, however many there are.
        self.standing: frozenset[str] = frozenset()
        self.tick_ms = 0.0
        self.clock_offset = 0.0
        self.clock_read = float("-inf")

    def stop(self) -> None:
        """For signal handlers: ends the loop after the current tick."""
        self.stopping = True

    def run(self) -> None:
        """Runs until stop(). Raises LeaseHeld if another service runs, Refusal if the world is invalid."""
        while not self.stopping:
            try:
                self.lease.acquire()
                galaxy = self.load()
                log.info("tick %d, %d ships, %d bodies", galaxy.tick, len(galaxy.ships), len(galaxy.world.bodies))
                self.run_ticks(galaxy)
                self.state.write_bodies_at_end(galaxy)
                self.lease.release()
            except LeaseLost:
                log.warning("lease lost; going on from what Redis holds")
            except RedisError as error:
                log.warning("Redis: %s; trying again", error)
                time.sleep(RETRY_SECONDS)

    def load(self) -> Galaxy:
        galaxy = self.state.load()
        if galaxy is None:
            self.state.create(self.definition)
            galaxy = self.state.load()
        if galaxy is None:
            raise Refusal("touchdown:world: missing after it was written")
        if galaxy.tick == 0:
            # A new world starts with the requested tempo.
            self.settle(galaxy, self.state.read_requests(galaxy.cursor))
        for self.refused in self.state.refusals:
            log.warning("%s", self.refused)
        return galaxy

    def run_ticks(self, galaxy: Galaxy) -> None:
        """Starts from the tick in Redis; the next boundary is one interval from now."""
        self.clock_read = float("-inf")
        due = time.monotonic() + 1 / galaxy.tempo.tick_rate
        while not self.stopping:
            if galaxy.tempo.paused:
                due = self.stay_paused(galaxy, due)
                continue
            if not self.wait_until(due):
                return
            self.run_boundary(galaxy, due)
            due = self.next_due(galaxy, due)

    def run_boundary(self, galaxy: Galaxy, due: float) -> None:
        """Applies the inbox, simulates the interval that ends now, and commits the boundary."""
        changes = Changes()
        requests = self.state.read_requests(galaxy.cursor)
        apply_entries(galaxy, requests.entries, changes)
        wall = self.redis_time(due)
        started = time.perf_counter()
        run_interval(galaxy, wall, changes)
        self.tick_ms = 1000 * (time.perf_counter() - started)
        self.settle(galaxy, requests)
        self.state.commit(galaxy, changes, wall, requests, self.status(galaxy, due))

    def stay_paused(self, galaxy: Galaxy, due: float) -> float:
        """Reads requests while paused; commands apply at once. Returns when the next boundary is due."""
        time.sleep(PAUSE_POLL)
        now = time.monotonic()
        changes = Changes()
        requests = self.state.read_requests(galaxy.cursor)
        apply_entries(galaxy, requests.entries, changes)
        before = galaxy.tempo
        self.settle(galaxy, requests)
        if requests.entries or galaxy.tempo != before:
            self.state.commit(galaxy, changes, self.redis_time(now), requests, self.status(galaxy, now))
        else:
            self.lease.check()
        return now + 1 / galaxy.tempo.tick_rate

    def settle(self, galaxy: Galaxy, requests: Requests) -> None:
        """Applies requested settings from this boundary on; reports invalid ones by name and ignores them."""
        if galaxy.tempo.time_sync:
            self.lost -= (galaxy.tempo.time_scale / galaxy.tempo.requested_scale - 1) / galaxy.tempo.tick_rate
        galaxy.tempo, refusals = next_tempo(galaxy.tempo, requests.values, self.lost)
        standing = requests.refusals + refusals
        for refusal in standing:
            if refusal not in self.standing:
                log.warning("%s", refusal)
                self.refused = refusal
        self.standing = frozenset(standing)

    def wait_until(self, due: float) -> bool:
        """Waits until `due`, by the local clock; False if stopped before."""
        while not self.stopping:
            left = due - time.monotonic()
            if left <= 0:
                return True
            time.sleep(min(left, LOOK_UP))
            self.lease.check()
        return False

    def next_due(self, galaxy: Galaxy, due: float) -> float:
        """Schedules the next boundary; after a stall catches up on at most MAX_CATCH_UP."""
        interval = 1 / galaxy.tempo.tick_rate
        due += interval
        behind = int((time.monotonic() - due) / interval)
        if behind < MAX_CATCH_UP:
            return due
        moved = behind - MAX_CATCH_UP + 1
        self.slipped += moved
        self.lost += moved * interval
        return due + moved * interval

    def redis_time(self, monotonic: float) -> float:
        """Redis's time, s since 1970, for an instant of the local clock."""
        if time.monotonic() - self.clock_read > CLOCK_INTERVAL:
            before = time.monotonic()
            seconds, micros = self.client.time()
            self.clock_read = time.monotonic()
            self.clock_offset = seconds + micros / 1e6 - (before + self.clock_read) / 2
        return monotonic + self.clock_offset

    def status(self, galaxy: Galaxy, due: float) -> dict[str, Any]:
        return {
            "pid": os.getpid(),
            "tick": galaxy.tick,
            "ships": len(galaxy.ships),
            "tick_ms": round(self.tick_ms, 3),
            "late_ms": round(1000 * (time.monotonic() - due), 3),
            "slipped": self.slipped,
            "refused": self.refused,
        }
