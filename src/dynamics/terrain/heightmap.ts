import { angleOf, arc, ARC_ANGLE, ARC_X, ARC_Y } from './arctangent';
import { BODY_RADIUS, outside, PLACE } from '../constants/limits';
import { err, notFinite, ok, type Result } from '../result';
import { HEIGHT, readHeight, terrainInPlace } from './inPlace';
import { flatTerrain } from './terrain';
import type { HeightInPlace, TerrainHeight } from '../constants/world';

/** Heights of a whole body on a grid of latitude and longitude, in the game's format. */
export interface Heightmap {
  /**
   * Row by row from 90° N, each row from 0° E eastward: sample `row · columns + column` is at latitude 90° − row · 180° / rows and
   * longitude column · 360° / columns. The last row lies one step before the south pole.
   */
  readonly samples: Int16Array;
  /** Even, ≥ 4. */
  readonly columns: number;
  /** ≥ 2 */
  readonly rows: number;
  /** Metres per unit of a sample. */
  readonly scale: number;
  /** Distance of a sample of 0 from the body's centre, m. */
  readonly referenceRadius: number;
  /** The body's radius in the simulation, m; heights are above it. The reference radius by default. */
  readonly bodyRadius?: number;
  /** Interpolation between the samples; 'bilinear' by default. */
  readonly interpolation?: 'bilinear' | 'bicubic';
}

/** A checked heightmap, ready for look-ups. */
interface LoadedHeightmap {
  readonly samples: Int16Array;
  readonly columns: number;
  readonly rows: number;
  readonly scale: number;
  /** Height of a sample of 0 above the body's radius, m. */
  readonly base: number;
  /** Heights of the poles, in units of a sample. Each pole is one point, the same for all columns. */
  readonly north: number;
  readonly south: number;
  readonly columnsPerRadian: number;
  readonly rowsPerRadian: number;
  readonly isBicubic: boolean;
}

const PI = 3.141592653589793;

/** Reads the samples of a file: 16-bit, signed, little-endian. Copies them if byte order or alignment requires it. */
export function readHeightmapSamples(bytes: Uint8Array): Result<Int16Array> {
  if (bytes.length % 2 !== 0) return err(`bytes: expected an even number, got ${bytes.length}`);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  return ok(Int16Array.from({ length: bytes.length / 2 }, (_, i) => view.getInt16(2 * i, true)));
}

/**
 * Terrain from heightmaps by body name, and `elsewhere` for bodies without one; or an error that names the invalid field. Continuous
 * everywhere, including across the date line and the poles: a pole's height is the mean of its nearest row (the first row is replaced
 * by its mean). A look-up takes less than 100 ns and does not allocate.
 */
export function heightmapTerrain(
  maps: Readonly<Record<string, Heightmap>>,
  elsewhere: TerrainHeight = flatTerrain,
): Result<TerrainHeight> {
  const loaded = new Map<string, LoadedHeightmap>();
  for (const [name, map] of Object.entries(maps)) {
    const checked = loadHeightmap(map);
    if (!checked.ok) return err(`${name}.${checked.reason}`);
    loaded.set(name, checked.value);
  }
  const inPlace: HeightInPlace = (direction, bodyName) => {
    const map = loaded.get(bodyName);
    if (map === undefined) {
      readHeight(direction, elsewhere, bodyName);
      return;
    }
    const nx = direction[0]!;
    const ny = direction[1]!;
    const nz = direction[2]!;
    arc[ARC_Y] = Math.sqrt(nx * nx + nz * nz);
    arc[ARC_X] = ny;
    angleOf();
    point[DOWN] = arc[ARC_ANGLE]! * map.rowsPerRadian;
    arc[ARC_Y] = nx;
    arc[ARC_X] = nz;
    angleOf();
    point[EAST] = arc[ARC_ANGLE]! * map.columnsPerRadian;
    if (map.isBicubic) bicubic(map);
    else bilinear(map);
    direction[HEIGHT] = map.base + map.scale * point[UNITS]!;
  };
  return ok(terrainInPlace(inPlace));
}

function loadHeightmap(map: Heightmap): Result<LoadedHeightmap> {
  const { samples, columns, rows, scale, referenceRadius, bodyRadius = referenceRadius } = map;
  if (!(samples instanceof Int16Array)) return err('samples: expected an Int16Array');
  if (!(Number.isSafeInteger(columns) && columns >= 4 && columns % 2 === 0))
    return err(`columns: expected an even number ≥ 4, got ${String(columns)}`);
  if (!(Number.isSafeInteger(rows) && rows >= 2))
    return err(`rows: expected a number ≥ 2, got ${String(rows)}`);
  if (samples.length !== rows * columns)
    return err(`samples: expected ${rows} × ${columns} of them, got ${samples.length}`);
  const interpolation: string = map.interpolation ?? 'bilinear';
  if (interpolation !== 'bilinear' && interpolation !== 'bicubic')
    return err(`interpolation: expected 'bilinear' or 'bicubic', got ${interpolation}`);
  const reason =
    notFinite('scale', scale) ??
    notFinite('referenceRadius', referenceRadius) ??
    notFinite('bodyRadius', bodyRadius) ??
    outside('scale', scale, PLACE) ??
    outside('referenceRadius', referenceRadius, BODY_RADIUS) ??
    outside('bodyRadius', bodyRadius, BODY_RADIUS);
  if (reason !== null) return err(reason);
  return ok({
    samples,
    columns,
    rows,
    scale,
    base: referenceRadius - bodyRadius,
    north: meanOfRow(samples, 0, columns),
    south: meanOfRow(samples, (rows - 1) * columns, columns),
    columnsPerRadian: columns / (2 * PI),
    rowsPerRadian: rows / PI,
    isBicubic: interpolation === 'bicubic',
  });
}

/** Mean of a row. The sum of integers is exact; the only rounding is in the division. */
function meanOfRow(samples: Int16Array, from: number, columns: number): number {
  let sum = 0;
  for (let i = 0; i < columns; i++) sum += samples[from + i]!;
  return sum / columns;
}

/** Scratch doubles of a look-up, so that none is boxed. Position on the grid: rows from the north pole, columns from 0° E. */
const point = new Float64Array(3);
const DOWN = 0;
const EAST = 1;
/** Height, in units of a sample. */
const UNITS = 2;
/** The 4 × 4 samples around the position. */
const patch = new Float64Array(16);
/** Row and column of the sample north-west of the position. */
const cell = new Int32Array(2);

/** Finds that sample, and replaces the position by its offset from the sample, 0 … 1 in each direction. */
function enterCell({ columns, rows }: LoadedHeightmap): void {
  const down = point[DOWN]!;
  const x = point[EAST]! < 0 ? point[EAST]! + columns : point[EAST]!;
  const row = down < rows ? Math.floor(down) : rows - 1;
  const inRow = x < columns;
  const column = inRow ? Math.floor(x) : 0;
  point[DOWN] = down - row;
  point[EAST] = inRow ? x - column : 0;
  cell[0] = row;
  cell[1] = column;
}

/** Sample of any row and column; a row beyond a pole continues on the opposite meridian. */
function sampleAt(
  { samples, columns, rows, north, south }: LoadedHeightmap,
  row: number,
  column: number,
): number {
  if (row === 0) return north;
  if (row === rows) return south;
  const isBeyond = row < 0 || row > rows;
  const held = row < 0 ? -row : row > rows ? 2 * rows - row : row;
  const around = (column + columns + (isBeyond ? columns / 2 : 0)) % columns;
  return samples[held * columns + around]!;
}

function bilinear(map: LoadedHeightmap): void {
  enterCell(map);
  readCell(map);
  const tx = point[EAST]!;
  const top = patch[0]! + (patch[1]! - patch[0]!) * tx;
  const bottom = patch[2]! + (patch[3]! - patch[2]!) * tx;
  point[UNITS] = top + (bottom - top) * point[DOWN]!;
}

/** Reads the cell's four corners into `patch`. */
function readCell(map: LoadedHeightmap): void {
  const { samples, columns, rows } = map;
  const row = cell[0]!;
  const column = cell[1]!;
  const at = row * columns + column;
  if (row > 0 && row + 1 < rows && column + 1 < columns) {
    patch[0] = samples[at]!;
    patch[1] = samples[at + 1]!;
    patch[2] = samples[at + columns]!;
    patch[3] = samples[at + columns + 1]!;
    return;
  }
  for (let i = 0; i < 4; i++) patch[i] = sampleAt(map, row + (i >> 1), column + (i & 1));
}

/** Catmull-Rom along four rows, then across them; the slope is continuous. */
function bicubic(map: LoadedHeightmap): void {
  enterCell(map);
  readPatch(map);
  const tx = point[EAST]!;
  for (let i = 0; i < 4; i++) patch[i] = catmullRom(4 * i, tx);
  point[UNITS] = catmullRom(0, point[DOWN]!);
}

function readPatch(map: LoadedHeightmap): void {
  const { samples, columns, rows } = map;
  const row = cell[0]!;
  const column = cell[1]!;
  if (row > 1 && row + 2 < rows && column > 0 && column + 2 < columns) {
    let from = (row - 1) * columns + column - 1;
    for (let i = 0; i < 16; i += 4, from += columns) {
      patch[i] = samples[from]!;
      patch[i + 1] = samples[from + 1]!;
      patch[i + 2] = samples[from + 2]!;
      patch[i + 3] = samples[from + 3]!;
    }
    return;
  }
  for (let i = 0; i < 16; i++) patch[i] = sampleAt(map, row - 1 + (i >> 2), column - 1 + (i & 3));
}

/** Catmull-Rom interpolation of four numbers in `patch`, from the second (t = 0) to the third (t = 1). */
function catmullRom(from: number, t: number): number {
  const a = patch[from]!;
  const b = patch[from + 1]!;
  const c = patch[from + 2]!;
  const d = patch[from + 3]!;
  return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}
