/** A hash of two cell indices and a seed, in [0, 1): the same on every machine. */
export function cellNoise(i: number, k: number, seed: number): number {
  let h = Math.imul(i, 0x27d4eb2d) ^ Math.imul(k, 0x165667b1) ^ Math.imul(seed, 0x9e3779b1);
  h = Math.imul(h ^ (h >>> 15), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return ((h ^ (h >>> 16)) >>> 0) / 0x100000000;
}

/** Fills a square of `size` × `size` texels with smooth noise in [0, 1), of `period` × `period` cells. It tiles without a seam. */
export function fillTile(out: Float64Array, size: number, period: number, seed: number): void {
  const corners = Float64Array.from({ length: period * period }, (_, n) =>
    cellNoise(n % period, Math.floor(n / period), seed),
  );
  const near = Uint16Array.from({ length: size }, (_, n) => Math.floor((n / size) * period));
  const far = near.map((cell) => (cell + 1) % period);
  const share = Float64Array.from(near, (cell, n) => smooth((n / size) * period - cell));
  for (let k = 0, at = 0; k < size; k++) {
    const k0 = near[k]! * period;
    const k1 = far[k]! * period;
    const v = share[k]!;
    for (let i = 0; i < size; i++, at++) {
      const i0 = near[i]!;
      const i1 = far[i]!;
      const u = share[i]!;
      const low = corners[k0 + i0]! * (1 - u) + corners[k0 + i1]! * u;
      const high = corners[k1 + i0]! * (1 - u) + corners[k1 + i1]! * u;
      out[at] = low * (1 - v) + high * v;
    }
  }
}

function smooth(t: number): number {
  return t * t * (3 - 2 * t);
}
