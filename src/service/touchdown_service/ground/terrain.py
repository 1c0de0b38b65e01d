"""Terrain heights, m above the body's radius, along a unit direction in the body's axes (Y pole, Z prime meridian, X 90 E)."""

from collections.abc import Callable
from dataclasses import dataclass
from math import sqrt
from pathlib import Path
from typing import Any

from ..law.vectors import Vec3
from ..models import Body, TerrainHeight
from ..validation.limits import Refusal, mapping, one_of, text
from .heightmap import heightmap_terrain, load_heightmap
from .noise import crater, noise

LANDING_SITE = (0.6, 0.48, 0.64)
# Distances from the site's centre, m: level up to the first, full relief from the second on.
LEVEL_RADIUS = 350
WHOLE_RADIUS = 4500


@dataclass(frozen=True, slots=True)
class Relief:
    """Parameters of a body's hills: radius, m; factor on lengths and heights; weight of the craters."""

    radius: float
    scale: float
    craters: float
    seed: int


RELIEFS = {
    "Luna": Relief(1737400.0, 1, 1, 11),
    "Earth": Relief(6371000.0, 1, 0, 23),
    "Mars": Relief(3389500.0, 1, 0.6, 37),
    "Phobos": Relief(11267.0, 0.08, 1, 53),
}
UNKNOWN_BODY = Relief(1000000.0, 1, 1, 71)
# More than all layers of `ground` together, m: 1,132.5 of noise, and 0.0187 of a cell's size for its crater's rim.
HIGHEST_LAYERS = 1170

# highest(body_name): a height above the body's radius that none of its ground exceeds, m.
Highest = Callable[[str], float]


def flat(body_name: str, nx: float, ny: float, nz: float) -> float:
    return 0.0


def highest_flat(body_name: str) -> float:
    return 0.0


def highest_hills(body_name: str) -> float:
    return RELIEFS.get(body_name, UNKNOWN_BODY).scale * HIGHEST_LAYERS


def hills(body_name: str, nx: float, ny: float, nz: float) -> float:
    """Ridges, hills, craters and a level landing site."""
    relief = RELIEFS.get(body_name, UNKNOWN_BODY)
    size = relief.radius / relief.scale
    dx = nx - LANDING_SITE[0]
    dy = ny - LANDING_SITE[1]
    dz = nz - LANDING_SITE[2]
    from_site = sqrt(dx * dx + dy * dy + dz * dz) * size
    if from_site <= LEVEL_RADIUS:
        return 0.0
    reach = WHOLE_RADIUS - LEVEL_RADIUS
    t = (from_site - LEVEL_RADIUS) / reach if from_site < WHOLE_RADIUS else 1.0
    return relief.scale * (t * t * (3 - 2 * t)) * ground(nx * size, ny * size, nz * size, relief)


def ground(x: float, y: float, z: float, relief: Relief) -> float:
    """Sum of the relief's layers, m."""
    seed = relief.seed
    swell = 650 * noise(x, y, z, 12000, seed)
    crest = 1 - abs(noise(x, y, z, 4300, seed + 1))
    ridge = 420 * (crest * crest * crest)
    bumpy = 60 * noise(x, y, z, 1100, seed + 2)
    bumps = 2.5 * noise(x, y, z, 130, seed + 3)
    bowls = crater(x, y, z, 1500, seed + 4) + crater(x, y, z, 260, seed + 5)
    return swell + ridge + bumpy + bumps + relief.craters * bowls


def bowl(base: float, amplitude: float, axis: Vec3) -> TerrainHeight:
    """base + amplitude (n . axis)^2: a slope that curves up or down toward an axis."""
    ax, ay, az = axis

    def height(body_name: str, nx: float, ny: float, nz: float) -> float:
        along = nx * ax + ny * ay + nz * az
        return base + amplitude * (along * along)

    return height


TERRAINS: dict[str, TerrainHeight] = {"flat": flat, "hills": hills}
HIGHEST: dict[str, Highest] = {"flat": highest_flat, "hills": highest_hills}


def load_terrain_name(name: object, path: str) -> TerrainHeight:
    return TERRAINS[one_of(name, path, tuple(TERRAINS))]


def load_ground(definition: dict[str, Any], bodies: list[Body], path: str) -> tuple[TerrainHeight, Highest]:
    """The ground of a world: a terrain that is built in, or one of the world's own name with a heightmap for each body that has one.

    Bodies without one are flat. Raises Refusal with the field that cannot be used.
    """
    name = definition.get("terrain", "flat")
    if "heightmaps" not in definition:
        return load_terrain_name(name, f"{path}.terrain"), HIGHEST[name]
    if text(name, f"{path}.terrain") in TERRAINS:
        raise Refusal(f"{path}.terrain: expected a name of its own beside heightmaps, got {name!r}, which is built in")
    given = definition["heightmaps"]
    mapping(given, f"{path}.heightmaps")
    radii = {body.name: body.radius for body in bodies}
    for body_name in given:
        one_of(body_name, f"{path}.heightmaps", tuple(radii))
    maps = {body: load_heightmap(data, f"{path}.heightmaps.{body}", radii[body]) for body, data in given.items()}
    return heightmap_terrain(maps, flat), lambda body: maps[body].highest if body in maps else 0.0


def with_whole_paths(definition: Any, folder: Path) -> Any:
    """A world definition whose heightmap files no longer depend on where the process runs: they lie relative to `folder`."""
    heightmaps = definition.get("heightmaps") if isinstance(definition, dict) else None
    if not isinstance(heightmaps, dict):
        return definition
    whole = {
        body: given | {"path": str(folder / given["path"])}
        if isinstance(given, dict) and isinstance(given.get("path"), str)
        else given
        for body, given in heightmaps.items()
    }
    return definition | {"heightmaps": whole}
