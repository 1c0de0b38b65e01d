/**
 * Lattice noise and craters from + − × ÷, floor and 32-bit integer hashing: the same bits in every language.
 * Point and value are scratch doubles, so that nothing is boxed (see quantities.ts).
 */

/** The point, m. */
export const noisePoint = new Float64Array(3);
/** [0]: the value. */
export const noiseValue = new Float64Array(1);

/** noiseValue = value noise at noisePoint on cells of `cell` metres, −1 … 1, with continuous first and second derivative. */
export function noise(cell: number, seed: number): void {
  const x = noisePoint[0]! / cell;
  const y = noisePoint[1]! / cell;
  const z = noisePoint[2]! / cell;
  const ix = Math.floor(x);
  const iy = Math.floor(y);
  const iz = Math.floor(z);
  const fx = x - ix;
  const fy = y - iy;
  const fz = z - iz;
  const tx = fx * fx * fx * (fx * (fx * 6 - 15) + 10);
  const ty = fy * fy * fy * (fy * (fy * 6 - 15) + 10);
  const tz = fz * fz * fz * (fz * (fz * 6 - 15) + 10);
  const c000 = signed(hash(ix, iy, iz, seed));
  const c100 = signed(hash(ix + 1, iy, iz, seed));
  const c010 = signed(hash(ix, iy + 1, iz, seed));
  const c110 = signed(hash(ix + 1, iy + 1, iz, seed));
  const c001 = signed(hash(ix, iy, iz + 1, seed));
  const c101 = signed(hash(ix + 1, iy, iz + 1, seed));
  const c011 = signed(hash(ix, iy + 1, iz + 1, seed));
  const c111 = signed(hash(ix + 1, iy + 1, iz + 1, seed));
  const c00 = c000 + (c100 - c000) * tx;
  const c10 = c010 + (c110 - c010) * tx;
  const c01 = c001 + (c101 - c001) * tx;
  const c11 = c011 + (c111 - c011) * tx;
  const c0 = c00 + (c10 - c00) * ty;
  const c1 = c01 + (c11 - c01) * ty;
  noiseValue[0] = c0 + (c1 - c0) * tz;
}

/** Depth over radius of a crater's bowl. */
const DEPTH = 0.22;

/**
 * noiseValue = height at noisePoint, m, of the crater in its cell of `cell` metres; 0 where the cell has none. A crater is a
 * sphere within its cell, cut by the ground: bowl, rim and foot are (1 − a)² (3.5 a − 1), a = (distance / radius)², so it meets
 * its surroundings with level slope, and only one cell matters.
 */
export function crater(cell: number, seed: number): void {
  const ix = Math.floor(noisePoint[0]! / cell);
  const iy = Math.floor(noisePoint[1]! / cell);
  const iz = Math.floor(noisePoint[2]! / cell);
  const h = hash(ix, iy, iz, seed);
  const radius = cell * (0.18 + 0.27 * unsigned(h));
  const play = cell - 2 * radius;
  const x = noisePoint[0]! - (ix * cell + radius + play * unsigned(remix(h + 1)));
  const y = noisePoint[1]! - (iy * cell + radius + play * unsigned(remix(h + 2)));
  const z = noisePoint[2]! - (iz * cell + radius + play * unsigned(remix(h + 3)));
  const a = (x * x + y * y + z * z) / (radius * radius);
  const foot = 1 - a;
  noiseValue[0] = a < 1 ? DEPTH * radius * (foot * foot * (3.5 * a - 1)) : 0;
}

/** A 32-bit integer from a lattice point. */
function hash(ix: number, iy: number, iz: number, seed: number): number {
  return remix(Math.imul(ix, 0x8da6b343) ^ Math.imul(iy, 0xd8163841) ^ Math.imul(iz, 0xcb1ab31f) ^ seed);
}

/** Mixes the bits of a 32-bit integer; each step is invertible, so no two integers collide. */
function remix(integer: number): number {
  let h = integer | 0;
  h = Math.imul(h ^ (h >>> 15), 0x2c1b3c6d);
  h = Math.imul(h ^ (h >>> 12), 0x297a2d39);
  return h ^ (h >>> 15);
}

/** 0 … 1 */
function unsigned(integer: number): number {
  return (integer >>> 0) / 4294967296;
}

/** −1 … 1 */
function signed(integer: number): number {
  return (integer >>> 0) / 2147483648 - 1;
}
