"""Ensures that only one service runs: an expiring key that only its holder renews (REDIS.md, Guarantees 2)."""

import os
import socket
import threading
import time
from secrets import token_hex

from redis import Redis
from redis.exceptions import RedisError

from ..validation.limits import Refusal, shown

KEY = "touchdown:lease"
# PTTL of a key without expiry.
NEVER = -1

# Renews the lease if this service holds it or no service does. A commit detects whether another service wrote meanwhile.
RENEW = """
local holder = redis.call('GET', KEYS[1])
if holder and holder ~= ARGV[1] then return 0 end
redis.call('SET', KEYS[1], ARGV[1], 'PX', ARGV[2])
return 1
"""
RELEASE = "if redis.call('GET', KEYS[1]) == ARGV[1] then return redis.call('DEL', KEYS[1]) end return 0"


class LeaseHeld(Exception):
    """Another service runs; its token is the message."""


class LeaseLost(Exception):
    """This service's lease expired; its state in memory may be stale."""


class Lease:
    """Identified by a token. A separate thread renews it, since computing a tick may take longer than the lease lasts."""

    def __init__(self, client: Redis, milliseconds: int = 3000) -> None:
        self.client = client
        self.milliseconds = milliseconds
        self.token = f"{socket.gethostname()}:{os.getpid()}:{token_hex(8)}"
        self.renewer: threading.Thread | None = None
        self.stopped = threading.Event()

    def acquire(self) -> None:
        """Takes the lease, or waits until a dead holder's expires. Raises LeaseHeld once a living holder renews it,
        Refusal if the key cannot have been written by a service."""
        self.take_over()
        self.stopped.set()
        self.stopped = threading.Event()
        self.renewer = threading.Thread(target=self.renew, args=(self.stopped,), daemon=True)
        self.renewer.start()

    def renew(self, stopped: threading.Event) -> None:
        """Renews until the lease is released or lost."""
        while not stopped.wait(self.milliseconds / 3000):
            try:
                if not self.client.eval(RENEW, 1, KEY, self.token, self.milliseconds):
                    stopped.set()
            except RedisError:
                # The main loop gets the same error and restarts.
                stopped.set()

    def take_over(self) -> None:
        lowest = None
        while not self.client.set(KEY, self.token, nx=True, px=self.milliseconds):
            if self.client.type(KEY) not in ("string", "none"):
                raise Refusal(f"{KEY}: expected a string, got a {self.client.type(KEY)}")
            holder = self.client.get(KEY)
            if holder == self.token:
                return
            left = self.client.pttl(KEY)
            # A lease written by a service always expires.
            if left == NEVER:
                raise Refusal(f"{KEY}: expected a key that expires, got {shown(holder)}")
            if lowest is not None and left > lowest:
                raise LeaseHeld(holder)
            lowest = left
            time.sleep(min(0.1, max(left, 1) / 1000))

    def check(self) -> None:
        """Raises LeaseLost if the lease is known to be lost; a commit checks it for certain."""
        if self.stopped.is_set():
            raise LeaseLost(self.token)

    def release(self) -> None:
        self.stopped.set()
        if self.renewer:
            self.renewer.join()
        self.client.eval(RELEASE, 1, KEY, self.token)
