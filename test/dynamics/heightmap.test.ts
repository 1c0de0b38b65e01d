import { describe, expect, it } from 'vitest';
import {
  type Heightmap,
  heightmapTerrain,
  readHeightmapSamples,
  type TerrainHeight,
} from '../../src/dynamics';
import { angleOf, arc, ARC_ANGLE, ARC_X, ARC_Y } from '../../src/dynamics/terrain/arctangent';
import { createRandom } from '../../src/scenarios';
import { unitVector } from '../exact/cases/draw';
import { surveyMap } from '../exact/survey';

const ROWS = 36;
const COLUMNS = 72;

/** A map from a function of latitude and longitude, rad. */
function mapOf(height: (latitude: number, longitude: number) => number): Heightmap {
  const samples = Int16Array.from({ length: ROWS * COLUMNS }, (_, i) => {
    const row = Math.floor(i / COLUMNS);
    return Math.round(height(Math.PI / 2 - (row * Math.PI) / ROWS, ((i % COLUMNS) * 2 * Math.PI) / COLUMNS));
  });
  return { samples, rows: ROWS, columns: COLUMNS, scale: 0.5, referenceRadius: 1737400 };
}

function terrainOf(map: Heightmap): TerrainHeight {
  const terrain = heightmapTerrain({ Luna: map });
  if (!terrain.ok) throw new Error(terrain.reason);
  return terrain.value;
}

function at(terrain: TerrainHeight, latitude: number, longitude: number): number {
  const level = Math.cos(latitude);
  return terrain('Luna', level * Math.sin(longitude), Math.sin(latitude), level * Math.cos(longitude));
}

const smooth = mapOf((latitude, longitude) => 8000 * Math.cos(latitude) * Math.sin(3 * longitude + latitude));
const METHODS = ['bilinear', 'bicubic'] as const;

function angle(y: number, x: number): number {
  arc[ARC_Y] = y;
  arc[ARC_X] = x;
  angleOf();
  return arc[ARC_ANGLE]!;
}

describe('angle of a vector', () => {
  it('is within 6e-16 rad of atan2', () => {
    const rng = createRandom(3);
    let worst = 0;
    for (let i = 0; i < 50_000; i++) {
      const [x, y] = unitVector(rng);
      worst = Math.max(worst, Math.abs(angle(y, x) - Math.atan2(y, x)));
    }
    // Math.atan2 itself is not exact.
    expect(worst).toBeLessThan(9e-16);
  });

  it.each([
    [0, 1, 0],
    [1, 0, Math.PI / 2],
    [0, -1, Math.PI],
    [-1, 0, -Math.PI / 2],
    [1, 1, Math.PI / 4],
    [0, 0, 0],
  ])('of (%d, %d)', (y, x, expected) => expect(angle(y, x)).toBeCloseTo(expected, 15));
});

describe.each(METHODS)('%s heightmap terrain', (interpolation) => {
  it('returns the samples at their grid points, north up, east from the prime meridian', () => {
    const terrain = terrainOf({ ...smooth, interpolation });
    for (const [row, column] of [
      [1, 0],
      [10, 5],
      [18, 71],
      [35, 36],
    ] as const) {
      const height = at(terrain, Math.PI / 2 - (row * Math.PI) / ROWS, (column * 2 * Math.PI) / COLUMNS);
      expect(height).toBeCloseTo(0.5 * smooth.samples[row * COLUMNS + column]!, 6);
    }
  });

  it('returns heights above the body’s radius', () => {
    const terrain = terrainOf({ ...smooth, interpolation, bodyRadius: 1737000 });
    const plain = terrainOf({ ...smooth, interpolation });
    expect(at(terrain, 0.3, 1) - at(plain, 0.3, 1)).toBeCloseTo(400, 6);
  });

  it('follows a smooth shape between samples', () => {
    const terrain = terrainOf({ ...smooth, interpolation });
    const rng = createRandom(4);
    let worst = 0;
    for (let i = 0; i < 3000; i++) {
      const latitude = 2.6 * (rng() - 0.5);
      const longitude = 2 * Math.PI * (rng() - 0.5);
      const truth = 4000 * Math.cos(latitude) * Math.sin(3 * longitude + latitude);
      worst = Math.max(worst, Math.abs(at(terrain, latitude, longitude) - truth));
    }
    expect(worst).toBeLessThan(interpolation === 'bicubic' ? 15 : 60);
  });

  it('is continuous over the poles, the date line and the prime meridian', () => {
    const terrain = terrainOf({ ...surveyMap(interpolation) });
    const step = 1e-7;
    for (let i = 0; i < 200; i++) {
      const longitude = (i * 2 * Math.PI) / 200;
      for (const pole of [Math.PI / 2, -Math.PI / 2]) {
        const towards = pole > 0 ? pole - step : pole + step;
        expect(Math.abs(at(terrain, towards, longitude) - at(terrain, pole, 0))).toBeLessThan(0.05);
      }
      const latitude = (i / 200 - 0.5) * 3;
      for (const meridian of [0, Math.PI]) {
        const west = at(terrain, latitude, meridian - step);
        expect(Math.abs(west - at(terrain, latitude, meridian + step))).toBeLessThan(0.05);
      }
    }
  });
});

it('bicubic terrain has a continuous slope at a sample', () => {
  const terrain = terrainOf({ ...smooth, interpolation: 'bicubic' });
  const column = (5 * 2 * Math.PI) / COLUMNS;
  const step = 1e-6;
  const before = (at(terrain, 0.2, column) - at(terrain, 0.2, column - step)) / step;
  const after = (at(terrain, 0.2, column + step) - at(terrain, 0.2, column)) / step;
  expect(Math.abs(after - before)).toBeLessThan(0.01 * Math.abs(before));
});

it('a body without a heightmap uses the fallback terrain', () => {
  const terrain = heightmapTerrain({ Luna: smooth }, () => 7);
  expect(terrain.ok && terrain.value('Earth', 0, 0, 1)).toBe(7);
});

it('reads little-endian samples from any byte offset', () => {
  const bytes = Uint8Array.of(9, 1, 0, 0xff, 0xff, 0, 0x80);
  expect(readHeightmapSamples(bytes.subarray(1))).toEqual({ ok: true, value: Int16Array.of(1, -1, -32768) });
  expect(readHeightmapSamples(bytes)).toEqual({ ok: false, reason: 'bytes: expected an even number, got 7' });
});

it.each([
  [{ columns: 71 }, 'Luna.columns: expected an even number ≥ 4, got 71'],
  [{ rows: 35 }, 'Luna.samples: expected 35 × 72 of them, got 2592'],
  [{ scale: Number.NaN }, 'Luna.scale: expected a finite number, got NaN'],
  [{ interpolation: 'cubic' }, "Luna.interpolation: expected 'bilinear' or 'bicubic', got cubic"],
  [{ referenceRadius: 0 }, 'Luna.referenceRadius: expected ≥ 0.001 m, got 0'],
])('refuses %j and names the field', (change, reason) => {
  expect(heightmapTerrain({ Luna: { ...smooth, ...change } as Heightmap })).toEqual({ ok: false, reason });
});
