"""Lattice noise and craters by + - * /, floor and 32-bit integers: the same bits in every language (ORDER, Terrain)."""

from functools import lru_cache
from math import floor

MASK = 0xFFFFFFFF


def remix(integer: int) -> int:
    """Mixes the bits of a 32-bit integer."""
    h = integer & MASK
    h = (h ^ (h >> 15)) * 0x2C1B3C6D & MASK
    h = (h ^ (h >> 12)) * 0x297A2D39 & MASK
    return h ^ (h >> 15)


def lattice_hash(i: int, j: int, k: int, seed: int) -> int:
    return remix((i * 0x8DA6B343 & MASK) ^ (j * 0xD8163841 & MASK) ^ (k * 0xCB1AB31F & MASK) ^ seed)


def signed(integer: int) -> float:
    """-1 to 1"""
    return integer / 2147483648 - 1


def unsigned(integer: int) -> float:
    """0 to 1"""
    return integer / 4294967296


# A ship stays in one cell for many substeps.
@lru_cache(maxsize=4096)
def corners(i: int, j: int, k: int, seed: int) -> tuple[float, ...]:
    """Lattice values at the cell's corners, x fastest."""
    return tuple(signed(lattice_hash(i + a, j + b, k + c, seed)) for c in (0, 1) for b in (0, 1) for a in (0, 1))


def noise(px: float, py: float, pz: float, cell: float, seed: int) -> float:
    """-1 to 1 on cells of `cell` metres, with continuous first and second derivative."""
    x, y, z = px / cell, py / cell, pz / cell
    i, j, k = floor(x), floor(y), floor(z)
    x -= i
    y -= j
    z -= k
    tx = x * x * x * (x * (x * 6 - 15) + 10)
    ty = y * y * y * (y * (y * 6 - 15) + 10)
    tz = z * z * z * (z * (z * 6 - 15) + 10)
    c000, c100, c010, c110, c001, c101, c011, c111 = corners(i, j, k, seed)
    c00 = c000 + (c100 - c000) * tx
    c10 = c010 + (c110 - c010) * tx
    c01 = c001 + (c101 - c001) * tx
    c11 = c011 + (c111 - c011) * tx
    c0 = c00 + (c10 - c00) * ty
    c1 = c01 + (c11 - c01) * ty
    return c0 + (c1 - c0) * tz


@lru_cache(maxsize=4096)
def crater_in_cell(cell: float, i: int, j: int, k: int, seed: int) -> tuple[float, float, float, float]:
    """Radius and centre, m."""
    h = lattice_hash(i, j, k, seed)
    radius = cell * (0.18 + 0.27 * unsigned(h))
    play = cell - 2 * radius
    return (
        radius,
        i * cell + radius + play * unsigned(remix(h + 1)),
        j * cell + radius + play * unsigned(remix(h + 2)),
        k * cell + radius + play * unsigned(remix(h + 3)),
    )


def crater(px: float, py: float, pz: float, cell: float, seed: int) -> float:
    """Height of the crater in the point's cell, m; 0 outside of it."""
    radius, cx, cy, cz = crater_in_cell(cell, floor(px / cell), floor(py / cell), floor(pz / cell), seed)
    x = px - cx
    y = py - cy
    z = pz - cz
    a = (x * x + y * y + z * z) / (radius * radius)
    if not a < 1:
        return 0.0
    foot = 1 - a
    return 0.22 * radius * (foot * foot * (3.5 * a - 1))
