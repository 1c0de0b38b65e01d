/** Points of the terrains, and their heights as bits: a ship's row holds a height only after a radius was added to it. */
import { BODIES, type Heightmap, heightmapTerrain, LANDING_SITE, TERRAINS } from '../../src/dynamics';
import { createRandom } from '../../src/scenarios';
import { triple, unitVector } from './cases/draw';
import type { SurveyPoint } from './python';

const POINTS = 3000;

const ROWS = 24;
const COLUMNS = 48;

/** A map of rough ground, far from smooth at the poles. */
export function surveyMap(interpolation: 'bilinear' | 'bicubic'): Heightmap {
  const samples = Int16Array.from({ length: ROWS * COLUMNS }, (_, i) => Math.imul(i + 1, 0x9e3779b1) >> 16);
  return { samples, rows: ROWS, columns: COLUMNS, scale: 0.5, referenceRadius: 1737400, interpolation };
}

/** Description of the maps, sent to Python before the points. */
export function surveyMaps(): unknown[] {
  return (['bilinear', 'bicubic'] as const).map((interpolation) => {
    const { samples, rows, columns, scale, referenceRadius } = surveyMap(interpolation);
    const given = { rows, columns, scale, reference_radius: referenceRadius, interpolation };
    return { terrain: interpolation, body: 'map', samples: [...samples], ...given };
  });
}

/** Over the maps: anywhere, near the poles and the date line, and on the samples themselves. */
export function heightmapPoints(): SurveyPoint[] {
  const rng = createRandom(9);
  const points: SurveyPoint[] = [];
  for (const terrain of ['bilinear', 'bicubic']) {
    for (const [x, y, z] of [
      [0, 1, 0],
      [0, -1, 0],
      [0, 0, 1],
      [0, 0, -1],
      [-0, 0, -1],
      [1, 0, 0],
      [-1, 0, 0],
    ] as const)
      points.push([terrain, 'map', x, y, z]);
    for (let i = 0; i < POINTS; i++) {
      points.push([terrain, 'map', ...unitVector(rng)]);
      const [x, , z] = triple(rng, 1e-3);
      points.push([terrain, 'map', x, rng() < 0.5 ? 1 : -1, z]);
      points.push([terrain, 'map', 1e-9 * x, z, -1]);
    }
  }
  return points;
}

/** Points anywhere on every body and on an unknown one, and as many around the landing site. */
export function surveyPoints(): SurveyPoint[] {
  const rng = createRandom(8);
  const bodies = [...BODIES.map(({ name }) => name), 'Nemo'];
  const points: SurveyPoint[] = [['flat', 'Luna', 0, 0, 1]];
  for (let i = 0; i < POINTS; i++) {
    const body = bodies[i % bodies.length]!;
    points.push(['hills', body, ...unitVector(rng)]);
    const [x, y, z] = triple(rng, body === 'Phobos' ? 0.03 : 0.003);
    points.push(['hills', body, LANDING_SITE[0] + x, LANDING_SITE[1] + y, LANDING_SITE[2] + z]);
  }
  return points;
}

/** Heights as the dynamics compute them: hexadecimal, most significant byte first. */
export function heightsHere(points: readonly SurveyPoint[]): string[] {
  const bits = new DataView(new ArrayBuffer(8));
  const terrains = { ...TERRAINS };
  for (const interpolation of ['bilinear', 'bicubic'] as const) {
    const loaded = heightmapTerrain({ map: surveyMap(interpolation) });
    if (!loaded.ok) throw new Error(loaded.reason);
    terrains[interpolation] = loaded.value;
  }
  return points.map(([terrain, body, nx, ny, nz]) => {
    bits.setFloat64(0, terrains[terrain]!(body, nx, ny, nz));
    return bits.getBigUint64(0).toString(16).padStart(16, '0');
  });
}
