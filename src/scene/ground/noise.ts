/** A number in [0, 1) from two cell indices and a seed: the same everywhere, no random. */
export function cellNoise(i: number, k: number, seed: number): number {
  let h = Math.imul(i, 0x27d4eb2d) ^ Math.imul(k, 0x165667b1) ^ Math.imul(seed, 0x9e3779b1);
  h = Math.imul(h ^ (h >>> 15), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return ((h ^ (h >>> 16)) >>> 0) / 0x100000000;
}

/** Smooth noise in [0, 1) that repeats every `period` cells. */
export function tiledNoise(x: number, y: number, period: number, seed: number): number {
  const i = Math.floor(x);
  const k = Math.floor(y);
  const u = smooth(x - i);
  const v = smooth(y - k);
  const [i0, i1] = [wrap(i, period), wrap(i + 1, period)];
  const [k0, k1] = [wrap(k, period), wrap(k + 1, period)];
  const low = cellNoise(i0, k0, seed) * (1 - u) + cellNoise(i1, k0, seed) * u;
  const high = cellNoise(i0, k1, seed) * (1 - u) + cellNoise(i1, k1, seed) * u;
  return low * (1 - v) + high * v;
}

function smooth(t: number): number {
  return t * t * (3 - 2 * t);
}

function wrap(i: number, period: number): number {
  return ((i % period) + period) % period;
}
