"""touchdown-service: runs the physics service on a Redis until SIGTERM or SIGINT."""

import argparse
import json
import logging
import signal
import sys
from pathlib import Path

from .ground.terrain import with_whole_paths
from .runtime.connection import connect
from .runtime.lease import LeaseHeld
from .runtime.service import Service
from .validation.limits import Refusal

# Exit codes: invalid world or arguments; another service runs.
REFUSED = 2
HELD = 3


def main() -> None:
    args = parse_arguments()
    logging.basicConfig(level=logging.INFO, format="%(asctime)s %(levelname)s %(message)s", stream=sys.stderr)
    try:
        definition = with_whole_paths(json.loads(args.world.read_text(encoding="utf-8")), args.world.resolve().parent)
        service = Service(connect(args.redis), definition, args.lease_ms)
        for name in (signal.SIGTERM, signal.SIGINT):
            signal.signal(name, lambda *_: service.stop())
        service.run()
    except (Refusal, OSError, json.JSONDecodeError) as error:
        sys.exit(report(f"touchdown-service: {error}", REFUSED))
    except LeaseHeld as held:
        sys.exit(report(f"touchdown-service: another service runs: {held}", HELD))


def report(message: str, code: int) -> int:
    print(message, file=sys.stderr)
    return code


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="touchdown-service", description=__doc__)
    parser.add_argument("--redis", default="redis://127.0.0.1:6379/0", help="default: %(default)s")
    parser.add_argument(
        "--world",
        type=Path,
        default=Path(__file__).with_name("world.json"),
        help="settings, classes, bodies and terrain, where Redis holds no world yet (default: the game's)",
    )
    parser.add_argument("--lease-ms", type=int, default=3000, help="the lease expires after this long")
    return parser.parse_args()


if __name__ == "__main__":
    main()
