"""Terrain from heightmaps in the game's format: the same bits as src/dynamics/terrain/heightmap.ts (ORDER, Heightmap)."""

import sys
from array import array
from dataclasses import dataclass
from math import floor, sqrt
from pathlib import Path
from typing import Any

from ..models import TerrainHeight
from ..validation.limits import (
    BODY_RADIUS,
    PLACE,
    Refusal,
    known_fields,
    mapping,
    number,
    one_of,
    required,
    text,
    whole,
)
from .arctangent import angle_of

PI = 3.141592653589793
INTERPOLATIONS = ("bilinear", "bicubic")
FIELDS = frozenset(("path", "columns", "rows", "scale", "reference_radius", "interpolation"))
# Columns or rows; a grid of 1 arc second would have 1,296,000 columns and take 1.7 TB.
MAX_SAMPLES_ACROSS = 200_000


@dataclass(slots=True)
class Heightmap:
    """Heights of a whole body on a grid of latitude and longitude.

    Sample row * columns + column is at latitude 90 - row * 180 / rows and longitude column * 360 / columns degrees; the last row
    lies one step before the south pole. `reference_radius`, m: where a sample of 0 is; `body_radius`, m: heights are above it.
    """

    samples: array
    columns: int
    rows: int
    scale: float
    reference_radius: float
    body_radius: float | None = None
    interpolation: str = "bilinear"
    base: float = 0.0
    # Heights of the poles, in units of a sample: one point each, the same for all columns.
    north: float = 0.0
    south: float = 0.0
    columns_per_radian: float = 0.0
    rows_per_radian: float = 0.0
    # A height that no look-up exceeds, m.
    highest: float = 0.0

    def __post_init__(self) -> None:
        """Raises Refusal with the invalid field."""
        whole(self.columns, "columns", least=4)
        whole(self.rows, "rows", least=2)
        if self.columns % 2:
            raise Refusal(f"columns: expected an even number, got {self.columns}")
        if len(self.samples) != self.rows * self.columns:
            raise Refusal(f"samples: expected {self.rows} x {self.columns} of them, got {len(self.samples)}")
        one_of(self.interpolation, "interpolation", INTERPOLATIONS)
        number(self.scale, "scale", PLACE)
        reference = number(self.reference_radius, "reference_radius", BODY_RADIUS)
        body = reference if self.body_radius is None else number(self.body_radius, "body_radius", BODY_RADIUS)
        self.base = reference - body
        self.north = sum(self.samples[: self.columns]) / self.columns
        self.south = sum(self.samples[-self.columns :]) / self.columns
        self.columns_per_radian = self.columns / (2 * PI)
        self.rows_per_radian = self.rows / PI
        # Catmull-Rom overshoots samples by at most 0.29 of their range, twice the largest one.
        largest = max(max(self.samples), -min(self.samples))
        self.highest = self.base + abs(self.scale) * (1.58 * largest)


def read_samples(data: bytes) -> array:
    """Reads samples of a file: 16-bit, signed, little-endian."""
    if len(data) % 2:
        raise Refusal(f"bytes: expected an even number, got {len(data)}")
    samples = array("h", data)
    if sys.byteorder == "big":
        samples.byteswap()
    return samples


def load_heightmap(data: Any, path: str, body_radius: float) -> Heightmap:
    """A heightmap as a world file describes it, its samples read from the file at `path` in it.

    `body_radius`, m: heights are above it. Raises Refusal with the invalid field.
    """
    mapping(data, path)
    known_fields(data, FIELDS, path)
    columns, rows = (
        whole(required(data, name, path), f"{path}.{name}", least=2, most=MAX_SAMPLES_ACROSS)
        for name in ("columns", "rows")
    )
    file = text(required(data, "path", path), f"{path}.path", most=4096)
    try:
        content = Path(file).read_bytes()
    except (OSError, ValueError) as error:
        raise Refusal(f"{path}.path: {file!r} cannot be read: {error}") from None
    if len(content) != 2 * columns * rows:
        size = 2 * columns * rows
        raise Refusal(f"{path}.path: expected {size} bytes, {columns} x {rows} samples, got {len(content)} in {file}")
    scale, reference = required(data, "scale", path), required(data, "reference_radius", path)
    interpolation = data.get("interpolation", "bilinear")
    try:
        return Heightmap(read_samples(content), columns, rows, scale, reference, body_radius, interpolation)
    except Refusal as refusal:
        raise Refusal(f"{path}.{refusal}") from None


def heightmap_terrain(maps: dict[str, Heightmap], elsewhere: TerrainHeight) -> TerrainHeight:
    """Terrain from heightmaps by body name, and `elsewhere` for bodies without one."""

    def height(body_name: str, nx: float, ny: float, nz: float) -> float:
        grid = maps.get(body_name)
        if grid is None:
            return elsewhere(body_name, nx, ny, nz)
        level = sqrt(nx * nx + nz * nz)
        down = angle_of(level, ny) * grid.rows_per_radian
        east = angle_of(nx, nz) * grid.columns_per_radian
        look_up = bicubic if grid.interpolation == "bicubic" else bilinear
        return grid.base + grid.scale * look_up(grid, down, east)

    return height


def sample_at(grid: Heightmap, row: int, column: int) -> float:
    """Sample at any row and 0 <= column < columns; a row beyond a pole continues on the opposite meridian."""
    columns, rows = grid.columns, grid.rows
    if 0 < row < rows:
        return grid.samples[row * columns + column]
    if row == 0:
        return grid.north
    if row == rows:
        return grid.south
    opposite = (column + columns // 2) % columns
    return grid.samples[(-row if row < 0 else 2 * rows - row) * columns + opposite]


def cell_of(grid: Heightmap, down: float, east: float) -> tuple[int, int, float, float]:
    """Row and column of the sample north-west of a point, and the point's offset from it, 0 to 1."""
    x = east + grid.columns if east < 0 else east
    row = min(floor(down), grid.rows - 1)
    column = floor(x)
    if column >= grid.columns:
        return row, 0, 0.0, down - row
    return row, column, x - column, down - row


def bilinear(grid: Heightmap, down: float, east: float) -> float:
    """`down` rows from the north pole, `east` columns from the prime meridian, either way."""
    row, column, tx, ty = cell_of(grid, down, east)
    after = column + 1 if column + 1 < grid.columns else 0
    a = sample_at(grid, row, column)
    b = sample_at(grid, row, after)
    c = sample_at(grid, row + 1, column)
    d = sample_at(grid, row + 1, after)
    top = a + (b - a) * tx
    bottom = c + (d - c) * tx
    return top + (bottom - top) * ty


def bicubic(grid: Heightmap, down: float, east: float) -> float:
    """Catmull-Rom along four rows, then across them."""
    row, column, tx, ty = cell_of(grid, down, east)
    return catmull_rom(*[along_row(grid, row + i, column, tx) for i in (-1, 0, 1, 2)], ty)


def along_row(grid: Heightmap, row: int, column: int, t: float) -> float:
    if row == 0:
        return grid.north
    if row == grid.rows:
        return grid.south
    return catmull_rom(*[sample_at(grid, row, (column + i) % grid.columns) for i in (-1, 0, 1, 2)], t)


def catmull_rom(a: float, b: float, c: float, d: float, t: float) -> float:
    """Catmull-Rom interpolation from b (t = 0) to c (t = 1)."""
    return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)))
