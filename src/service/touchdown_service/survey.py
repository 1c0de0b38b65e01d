"""Prints terrain heights, so that another implementation can be compared bit by bit.

    python3 -m touchdown_service.survey < points.jsonl    one line a point: the height's double in hex, most significant byte first

A point is ["hills", "Moon", nx, ny, nz]: a terrain, a body and a direction in the body's axes.
"""

import json
import sys
from struct import pack

from .terrain import TERRAINS


def main() -> None:
    for line in sys.stdin:
        terrain, body_name, nx, ny, nz = json.loads(line)
        print(pack(">d", TERRAINS[terrain](body_name, float(nx), float(ny), float(nz))).hex())


if __name__ == "__main__":
    main()
