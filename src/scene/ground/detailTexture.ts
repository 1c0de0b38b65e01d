import { DataTexture, LinearFilter, LinearMipmapLinearFilter, RepeatWrapping, RGBAFormat } from 'three';
import { cellNoise, fillTile } from './noise';

const SIZE = 256;
/** A power of two minus one: `& LAST` wraps a row or column around the edges. */
const LAST = SIZE - 1;

/**
 * Detail below the terrain callback's scale: grain, pebbles and small pits, as slopes (R, G; 0.5 = level), brightness (B) and
 * stoniness (A). It repeats; the ground samples it at several scales. It changes the light only, not the ground's height.
 */
export function createDetailTexture(anisotropy: number): DataTexture {
  const heights = new Float32Array(SIZE * SIZE);
  grain(heights);
  pits(heights, { count: 90, seed: 3, largest: 26 });
  const stones = pebbles(heights);
  const texture = new DataTexture(toBytes(heights, stones), SIZE, SIZE, RGBAFormat);
  texture.wrapS = RepeatWrapping;
  texture.wrapT = RepeatWrapping;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  // The ground is seen at a grazing angle: at 1 the middle distance is a smear of streaks.
  texture.anisotropy = anisotropy;
  texture.needsUpdate = true;
  return texture;
}

function grain(heights: Float32Array): void {
  const sums = new Float64Array(heights.length);
  const tile = new Float64Array(heights.length);
  for (let period = 4, size = 1; period <= 128; period *= 2, size *= 0.53) {
    fillTile(tile, SIZE, period, period);
    addOctave(sums, tile, size);
  }
  for (let at = 0; at < sums.length; at++) heights[at] = sums[at]! * 9;
}

/** Called once per octave, so that the engine compiles it early: a loop in the caller would mostly run uncompiled. */
function addOctave(sums: Float64Array, tile: Float64Array, size: number): void {
  for (let at = 0; at < sums.length; at++) sums[at]! += size * (tile[at]! - 0.5);
}

interface Pits {
  readonly count: number;
  readonly seed: number;
  readonly largest: number;
}

/** Bowls with a raised rim; many small ones, few large. */
function pits(heights: Float32Array, { count, seed, largest }: Pits): void {
  for (let n = 0; n < count; n++) {
    const x = cellNoise(n, 1, seed) * SIZE;
    const y = cellNoise(n, 2, seed) * SIZE;
    const radius = 2 + largest * cellNoise(n, 3, seed) ** 5;
    stamp(heights, { x, y, reach: radius * 1.6 }, (d) => {
      const t = d / radius;
      return t < 1 ? radius * 0.28 * (t * t - 0.75) : radius * 0.07 * Math.max(0, 1 - (t - 1) / 0.6);
    });
  }
}

/** Small stones; gives how stony each texel is. */
function pebbles(heights: Float32Array): Float32Array {
  const stones = new Float32Array(SIZE * SIZE);
  for (let n = 0; n < 620; n++) {
    const x = cellNoise(n, 7, 11) * SIZE;
    const y = cellNoise(n, 8, 11) * SIZE;
    const radius = 0.8 + 2.6 * cellNoise(n, 9, 11) ** 4;
    const dome = (d: number) => (d < radius ? Math.sqrt(radius * radius - d * d) * 0.9 : 0);
    stamp(heights, { x, y, reach: radius }, dome);
    stamp(stones, { x, y, reach: radius }, (d) => (d < radius ? 1 : 0));
  }
  return stones;
}

interface Spot {
  readonly x: number;
  readonly y: number;
  readonly reach: number;
}

function stamp(field: Float32Array, { x, y, reach }: Spot, height: (distance: number) => number): void {
  const from = Math.ceil(-reach);
  const firstI = Math.round(x);
  const firstK = Math.round(y);
  for (let dk = from; dk <= reach; dk++) {
    const k = firstK + dk;
    const row = (k & LAST) * SIZE;
    for (let di = from; di <= reach; di++) {
      const i = firstI + di;
      const d = Math.hypot(i - x, k - y);
      if (d > reach) continue;
      const at = row + (i & LAST);
      field[at] = field[at]! + height(d);
    }
  }
}

function toBytes(heights: Float32Array, stones: Float32Array): Uint8Array {
  const bytes = new Uint8Array(SIZE * SIZE * 4);
  const patches = new Float64Array(SIZE * SIZE);
  const fine = new Float64Array(SIZE * SIZE);
  fillTile(patches, SIZE, 8, 41);
  fillTile(fine, SIZE, 64, 43);
  for (let k = 0; k < SIZE; k++) writeRow(bytes, k, { heights, patches, fine, stones });
  return bytes;
}

interface Fields {
  readonly heights: Float32Array;
  readonly patches: Float64Array;
  readonly fine: Float64Array;
  readonly stones: Float32Array;
}

function writeRow(bytes: Uint8Array, k: number, { heights, patches, fine, stones }: Fields): void {
  const row = k * SIZE;
  const above = ((k + 1) & LAST) * SIZE;
  const below = ((k - 1) & LAST) * SIZE;
  for (let i = 0; i < SIZE; i++) {
    const slopeX = (heights[row + ((i + 1) & LAST)]! - heights[row + ((i - 1) & LAST)]!) / 2;
    const slopeY = (heights[above + i]! - heights[below + i]!) / 2;
    const from = row + i;
    const to = from * 4;
    bytes[to] = toByte(0.5 + slopeX * 0.35);
    bytes[to + 1] = toByte(0.5 + slopeY * 0.35);
    bytes[to + 2] = toByte(patches[from]! * 0.6 + fine[from]! * 0.4);
    bytes[to + 3] = toByte(stones[from]!);
  }
}

function toByte(value: number): number {
  return Math.round(255 * Math.min(Math.max(value, 0), 1));
}
