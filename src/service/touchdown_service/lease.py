"""One service at a time: a key that expires, renewed by its holder alone (REDIS.md, Guarantees 2)."""

import os
import socket
import time
from secrets import token_hex

from redis import Redis

KEY = "touchdown:lease"

# Renews, or gives back, only what is held.
RENEW = "if redis.call('GET', KEYS[1]) == ARGV[1] then return redis.call('PEXPIRE', KEYS[1], ARGV[2]) end return 0"
RELEASE = "if redis.call('GET', KEYS[1]) == ARGV[1] then return redis.call('DEL', KEYS[1]) end return 0"


class LeaseHeld(Exception):
    """Another service runs; its token is the message."""


class LeaseLost(Exception):
    """This service's lease ran out; what it has in memory may be old."""


class Lease:
    def __init__(self, client: Redis, milliseconds: int = 3000) -> None:
        self.client = client
        self.milliseconds = milliseconds
        self.token = f"{socket.gethostname()}:{os.getpid()}:{token_hex(8)}"

    def acquire(self) -> None:
        """Takes the lease, or waits for a dead holder's to run out. Raises LeaseHeld once a living holder renews it."""
        lowest = None
        while not self.client.set(KEY, self.token, nx=True, px=self.milliseconds):
            holder = self.client.get(KEY)
            if holder == self.token:
                return
            left = self.client.pttl(KEY)
            if lowest is not None and left > lowest:
                raise LeaseHeld(holder)
            lowest = left
            time.sleep(min(0.1, max(left, 1) / 1000))

    def renew(self) -> None:
        """Raises LeaseLost."""
        if not self.client.eval(RENEW, 1, KEY, self.token, self.milliseconds):
            raise LeaseLost(self.token)

    def release(self) -> None:
        self.client.eval(RELEASE, 1, KEY, self.token)
