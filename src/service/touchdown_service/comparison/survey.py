"""Prints terrain heights, so that another implementation can be compared bit by bit.

    python3 -m touchdown_service.comparison.survey < lines    one line per point: the height's double in hex, most significant byte first

A line is a point, ["hills", "Luna", nx, ny, nz]: a terrain, a body and a direction in the body's axes; or an object that defines a
terrain from a heightmap for the lines below it: {"terrain", "body", "samples", "columns", "rows", "scale", ...}.
"""

import json
import sys
from array import array
from struct import pack

from ..ground.heightmap import Heightmap, heightmap_terrain
from ..ground.terrain import TERRAINS, flat


def main() -> None:
    terrains = dict(TERRAINS)
    for line in sys.stdin:
        given = json.loads(line)
        if isinstance(given, dict):
            name, body = given.pop("terrain"), given.pop("body")
            grid = Heightmap(**(given | {"samples": array("h", given["samples"])}))
            terrains[name] = heightmap_terrain({body: grid}, flat)
            continue
        terrain, body_name, nx, ny, nz = given
        print(pack(">d", terrains[terrain](body_name, float(nx), float(ny), float(nz))).hex())


if __name__ == "__main__":
    main()
