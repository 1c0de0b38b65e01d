"""The service's connection to Redis."""

from redis import Redis
from redis.backoff import NoBackoff
from redis.retry import Retry

from ..storage.packing import CommandPacker

# Time after which an answer counts as lost, s.
ANSWER_SECONDS = 5


def connect(url: str) -> Redis:
    """A client that has not connected yet.

    A command that Redis may have executed is never retried; the service reads Redis's state instead. Invalid UTF-8 does
    not end the service: the decoded text is refused by name.
    """
    return Redis.from_url(
        url,
        decode_responses=True,
        encoding_errors="replace",
        command_packer=CommandPacker(),
        socket_timeout=ANSWER_SECONDS,
        retry=Retry(NoBackoff(), 0),
    )
