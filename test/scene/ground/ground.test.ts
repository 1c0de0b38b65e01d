import { describe, expect, it } from 'vitest';
import { BODIES, LANDING_SITE, TERRAINS } from '../../../src/dynamics';
import { createLocalFrame } from '../../../src/scene/localFrame';
import { CELLS } from '../../../src/scene/ground/levels';
import {
  cornerFor,
  groundPoint,
  layOutLevel,
  moveLevel,
  shadeLevel,
  shadeOver,
  type TerrainLevel,
} from '../../../src/scene/ground/terrainLevel';
import { writeSectors } from '../../../src/scene/ground/groundSectors';
import { ownLevel, ownSectors } from './ownLevel';

const MOON = BODIES.find(({ name }) => name === 'Luna')!;
const hills = TERRAINS['hills']!;
const SUN = { elevation: 13, azimuth: 58 };

/** A frame some way from the level site, among hills and craters. */
function frameAt(metresOff: number) {
  const off = metresOff / MOON.radius;
  const place = [LANDING_SITE[0] + off, LANDING_SITE[1], LANDING_SITE[2] - off];
  return createLocalFrame(
    MOON,
    place.map((value) => value * MOON.radius),
    SUN,
  );
}

function levelAt(spacing: number, x: number, z: number, frame = frameAt(3000)): TerrainLevel {
  const level = ownLevel(spacing);
  moveLevel(level, [cornerFor(level, x), cornerFor(level, z)], frame, hills);
  shadeLevel(level, null, frame);
  layOutLevel(level);
  return level;
}

/** Height of the drawn triangles over a place inside the level, in the local frame. */
function drawnHeight(level: TerrainLevel, x: number, z: number): number {
  const sectors = ownSectors();
  writeSectors(sectors, level, null);
  const { indices } = sectors;
  const count = CELLS * CELLS * 6;
  const { positions, origin } = level;
  const corner = (n: number) => [0, 1, 2].map((axis) => positions[indices[n]! * 3 + axis]! + origin[axis]!);
  for (let n = 0; n < count; n += 3) {
    const [a, b, c] = [corner(n), corner(n + 1), corner(n + 2)] as [number[], number[], number[]];
    const area = (b[0]! - a[0]!) * (c[2]! - a[2]!) - (c[0]! - a[0]!) * (b[2]! - a[2]!);
    const u = ((x - a[0]!) * (c[2]! - a[2]!) - (c[0]! - a[0]!) * (z - a[2]!)) / area;
    const v = ((b[0]! - a[0]!) * (z - a[2]!) - (x - a[0]!) * (b[2]! - a[2]!)) / area;
    if (u >= -1e-9 && v >= -1e-9 && u + v <= 1 + 1e-9)
      return a[1]! + u * (b[1]! - a[1]!) + v * (c[1]! - a[1]!);
  }
  return NaN;
}

describe('drawn ground', () => {
  it('is within a millimetre of the terrain under the feet, also on hills', () => {
    const frame = frameAt(3000);
    const level = levelAt(0.4, 0, 0, frame);
    const truth = new Float64Array(3);
    let worst = 0;
    for (let n = 0; n < 60; n++) {
      const [x, z] = [((n * 7.31) % 10) - 5, ((n * 3.77) % 10) - 5];
      groundPoint(truth, 0, x, z, { frame, terrainHeight: hills });
      const drawn = drawnHeight(level, truth[0]!, truth[2]!);
      worst = Math.max(worst, Math.abs(drawn - truth[1]!));
    }
    expect(worst).toBeGreaterThan(0);
    expect(worst).toBeLessThan(1e-3);
  });

  it('is radius + terrain height from the body’s centre at every vertex', () => {
    const frame = frameAt(2000);
    const level = levelAt(6.4, 900, -400, frame);
    const { axes } = frame;
    for (let i = 0; i < level.points.length; i += 3 * 97) {
      const [x, y, z] = [level.points[i]!, level.points[i + 1]! + frame.radius, level.points[i + 2]!];
      const r = Math.hypot(x, y, z);
      const along = (k: number) => (axes[k]! * x + axes[3 + k]! * y + axes[6 + k]! * z) / r;
      // Rounding of 1.7e6 m in doubles, with a square root and sums: about 1e-9 m.
      expect(Math.abs(r - frame.radius - hills('Luna', along(0), along(1), along(2)))).toBeLessThan(1e-6);
    }
  });

  it('keeps its vertices when it moves: the same as built there from the start', () => {
    const frame = frameAt(3000);
    const moved = levelAt(0.4, 0, 0, frame);
    let calls = 0;
    moveLevel(moved, [moved.cornerX + 6, moved.cornerZ - 4], frame, (...place) => {
      calls++;
      return hills(...place);
    });
    const fresh = ownLevel(0.4);
    moveLevel(fresh, [moved.cornerX, moved.cornerZ], frame, hills);
    expect(moved.points).toEqual(fresh.points);
    expect(calls).toBe((CELLS + 3) * (CELLS + 3) - (CELLS + 3 - 6) * (CELLS + 3 - 4));
  });

  it('takes the vertices that the coarser level has from it: the same as computed', () => {
    const frame = frameAt(3000);
    const coarse = levelAt(0.8, 30, -17, frame);
    const [fine, fresh] = [ownLevel(0.4), ownLevel(0.4)];
    const corner = [cornerFor(fine, 30), cornerFor(fine, -17)] as const;
    let calls = 0;
    const counted: typeof hills = (...place) => {
      calls++;
      return hills(...place);
    };
    moveLevel(fine, corner, frame, counted, coarse);
    moveLevel(fresh, corner, frame, hills);
    expect(fine.points).toEqual(fresh.points);
    // Every second one of either direction; the first is outside of the corner, which is even.
    expect(calls).toBe((CELLS + 3) * (CELLS + 3) - (CELLS / 2 + 1) * (CELLS / 2 + 1));
  });

  it('joins the coarser level without a crack, and leaves out exactly what the finer covers', () => {
    const frame = frameAt(3000);
    const fine = levelAt(0.8, 37, 11, frame);
    const coarse = levelAt(1.6, 37, 11, frame);
    const side = CELLS + 1;
    const fineAt = (i: number, axis: number) => fine.positions[i * 3 + axis]! + fine.origin[axis]!;
    for (let i = 0; i < CELLS; i += 2) {
      const [x, z] = [(fine.cornerX + i) / 2 - coarse.cornerX, fine.cornerZ / 2 - coarse.cornerZ];
      const at = z * side + x;
      for (let axis = 0; axis < 3; axis++) {
        const value = coarse.positions[at * 3 + axis]! + coarse.origin[axis]!;
        // Both are floats relative to an origin tens of metres away.
        expect(Math.abs(value - fineAt(i, axis))).toBeLessThan(2e-5);
        const middle = (fineAt(i, axis) + fineAt(i + 2, axis)) / 2;
        expect(Math.abs(fineAt(i + 1, axis) - middle)).toBeLessThan(2e-5);
      }
    }
    const sectors = ownSectors();
    writeSectors(sectors, coarse, fine);
    const once = (CELLS * CELLS - (CELLS / 2) ** 2) * 6;
    expect(sectors.starts.at(-1)).toBe(2 * once);
    const corners = (from: number) =>
      Array.from({ length: once / 3 }, (_, n) =>
        [...sectors.indices.subarray(from + 3 * n, from + 3 * n + 3)].join(),
      );
    expect(new Set(corners(0)).size).toBe(once / 3);
    expect(corners(once)).toEqual(corners(0));
  });

  it('casts a shadow of the length that the sun’s elevation gives', () => {
    const frame = frameAt(0);
    const level = ownLevel(1);
    const wall = 6;
    // A ridge along z at x = 10 m, on level ground: cell corners are whole metres.
    const ridge = (_: string, nx: number, ny: number, nz: number) => {
      const { axes, radius } = frame;
      const x = (axes[0]! * nx + axes[1]! * ny + axes[2]! * nz) * radius;
      return Math.abs(x - 10) < 0.5 ? wall : 0;
    };
    moveLevel(level, [cornerFor(level, 0), cornerFor(level, 0)], frame, ridge);
    shadeLevel(level, null, frame);
    layOutLevel(level);
    const side = CELLS + 1;
    const middle = CELLS / 2;
    const sunlit = (x: number) => level.sunlit[middle * side + middle + x]!;
    const reach = wall / Math.tan((SUN.elevation * Math.PI) / 180);
    expect(sunlit(12)).toBeGreaterThan(0);
    expect(sunlit(Math.ceil(10 - reach + 1))).toBeLessThan(0);
    expect(sunlit(Math.floor(10 - reach - 1))).toBeGreaterThan(0);
    // Half way along, the shadow is half as high as the wall.
    expect(Math.abs(shadeOver(level, 10 - reach / 2, 0.5) - wall / 2)).toBeLessThan(0.2);
    expect(shadeOver(level, 14, 0.5)).toBeLessThan(0);
  });
});
