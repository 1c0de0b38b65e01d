/**
 * Lattice noise and craters by + − × ÷, floor and 32-bit integer hashing: the same bits in every language.
 * Point and value are scratch doubles, so that none is boxed (see quantities.ts).
 */

/** Point to evaluate, m. */
export const noisePoint = new Float64Array(3);
/** Result, in element 0. */
export const noiseValue = new Float64Array(1);

/**
 * Cache of a layer's last cell, a row of doubles: lattice point, seed, and the values hashed from them. One ship's look-ups lie metres
 * apart and cells are hundreds of metres wide, so most look-ups hit the cache.
 */
export type KnownCell = Float64Array;

export function createKnownCell(): KnownCell {
  return new Float64Array(CELL_LENGTH).fill(NaN);
}

/** Columns of a KnownCell after its lattice point x, y, z: the seed, and the hashed values (a noise's eight corners, or a crater's centre and radius). */
const CELL_SEED = 3;
const HASHED = 4;
const CELL_LENGTH = 12;

/** noiseValue = value noise at noisePoint on cells of `cell` metres, −1 … 1, with continuous first and second derivative. */
export function noise(cell: number, seed: number, known: KnownCell): void {
  const x = noisePoint[0]! / cell;
  const y = noisePoint[1]! / cell;
  const z = noisePoint[2]! / cell;
  const ix = Math.floor(x);
  const iy = Math.floor(y);
  const iz = Math.floor(z);
  if (!isKnown(known, ix, iy, iz, seed)) hashCorners(known);
  const fx = x - ix;
  const fy = y - iy;
  const fz = z - iz;
  const tx = fx * fx * fx * (fx * (fx * 6 - 15) + 10);
  const ty = fy * fy * fy * (fy * (fy * 6 - 15) + 10);
  const tz = fz * fz * fz * (fz * (fz * 6 - 15) + 10);
  const c000 = known[HASHED]!;
  const c010 = known[HASHED + 2]!;
  const c001 = known[HASHED + 4]!;
  const c011 = known[HASHED + 6]!;
  const c00 = c000 + (known[HASHED + 1]! - c000) * tx;
  const c10 = c010 + (known[HASHED + 3]! - c010) * tx;
  const c01 = c001 + (known[HASHED + 5]! - c001) * tx;
  const c11 = c011 + (known[HASHED + 7]! - c011) * tx;
  const c0 = c00 + (c10 - c00) * ty;
  const c1 = c01 + (c11 - c01) * ty;
  noiseValue[0] = c0 + (c1 - c0) * tz;
}

/** Whether `known` is that cell. If not, makes it that cell; the caller then fills the hashed values. */
function isKnown(known: KnownCell, ix: number, iy: number, iz: number, seed: number): boolean {
  if (known[0] === ix && known[1] === iy && known[2] === iz && known[CELL_SEED] === seed) return true;
  known[0] = ix;
  known[1] = iy;
  known[2] = iz;
  known[CELL_SEED] = seed;
  return false;
}

/** Fills the lattice values at the cell's corners, −1 … 1, x fastest. */
function hashCorners(known: KnownCell): void {
  for (let k = 0; k < 8; k++) {
    const ix = known[0]! + (k & 1);
    const iy = known[1]! + ((k >> 1) & 1);
    const iz = known[2]! + (k >> 2);
    known[HASHED + k] = signed(hash(ix, iy, iz, known[CELL_SEED]!));
  }
}

/** Depth of a crater's bowl divided by its radius. */
const DEPTH = 0.22;
/** Minimum radius of a crater and its range, divided by the cell's edge; their sum is below ½, so a crater lies within its cell. */
const MIN_RADIUS = 0.18;
const RADIUS_SPREAD = 0.27;
/** The bowl turns into the rim at (distance / radius)² = 1 / RIM. */
const RIM = 3.5;
/** 2³² and 2³¹. */
const INTEGERS = 4294967296;
const HALF_INTEGERS = 2147483648;

/**
 * noiseValue = height at noisePoint of the crater in its cell of `cell` metres, m; 0 outside the crater. A crater is the intersection of
 * the ground with a sphere within the cell, so only one cell matters. Its profile is (1 − a)² (3.5 a − 1) with a = (distance / radius)²,
 * which has zero slope at the edge.
 */
export function crater(cell: number, seed: number, known: KnownCell): void {
  const ix = Math.floor(noisePoint[0]! / cell);
  const iy = Math.floor(noisePoint[1]! / cell);
  const iz = Math.floor(noisePoint[2]! / cell);
  if (!isKnown(known, ix, iy, iz, seed)) placeCrater(known, cell);
  const x = noisePoint[0]! - known[HASHED]!;
  const y = noisePoint[1]! - known[HASHED + 1]!;
  const z = noisePoint[2]! - known[HASHED + 2]!;
  const radius = known[HASHED + 3]!;
  const a = (x * x + y * y + z * z) / (radius * radius);
  const foot = 1 - a;
  noiseValue[0] = a < 1 ? DEPTH * radius * (foot * foot * (RIM * a - 1)) : 0;
}

/** Fills the crater's centre and radius, m. */
function placeCrater(known: KnownCell, cell: number): void {
  const ix = known[0]!;
  const iy = known[1]!;
  const iz = known[2]!;
  const h = hash(ix, iy, iz, known[CELL_SEED]!);
  const radius = cell * (MIN_RADIUS + RADIUS_SPREAD * unsigned(h));
  const play = cell - 2 * radius;
  known[HASHED] = ix * cell + radius + play * unsigned(remix(h + 1));
  known[HASHED + 1] = iy * cell + radius + play * unsigned(remix(h + 2));
  known[HASHED + 2] = iz * cell + radius + play * unsigned(remix(h + 3));
  known[HASHED + 3] = radius;
}

/** Hashes a lattice point to a 32-bit integer. */
function hash(ix: number, iy: number, iz: number, seed: number): number {
  return remix(Math.imul(ix, 0x8da6b343) ^ Math.imul(iy, 0xd8163841) ^ Math.imul(iz, 0xcb1ab31f) ^ seed);
}

/** Mixes the bits of a 32-bit integer. Each step is invertible, so there are no collisions. */
function remix(integer: number): number {
  let h = integer | 0;
  h = Math.imul(h ^ (h >>> 15), 0x2c1b3c6d);
  h = Math.imul(h ^ (h >>> 12), 0x297a2d39);
  return h ^ (h >>> 15);
}

/** 0 … 1 */
function unsigned(integer: number): number {
  return (integer >>> 0) / INTEGERS;
}

/** −1 … 1 */
function signed(integer: number): number {
  return (integer >>> 0) / HALF_INTEGERS - 1;
}
