/** Points of the terrains, and their heights as bits: a ship's row holds a height only after a radius was added to it. */
import { BODIES, LANDING_SITE, TERRAINS } from '../../src/dynamics';
import { createDice } from '../../src/scenarios';
import { triple, unitVector } from './draw';
import type { SurveyPoint } from './python';

const POINTS = 3000;

/** Anywhere on every body and on one that no terrain knows, and as many round the landing site. */
export function surveyPoints(): SurveyPoint[] {
  const dice = createDice(8);
  const bodies = [...BODIES.map(({ name }) => name), 'Nemo'];
  const points: SurveyPoint[] = [['flat', 'Luna', 0, 0, 1]];
  for (let i = 0; i < POINTS; i++) {
    const body = bodies[i % bodies.length]!;
    points.push(['hills', body, ...unitVector(dice)]);
    const [x, y, z] = triple(dice, body === 'Phobos' ? 0.03 : 0.003);
    points.push(['hills', body, LANDING_SITE[0] + x, LANDING_SITE[1] + y, LANDING_SITE[2] + z]);
  }
  return points;
}

/** Heights as the dynamics compute them: hexadecimal, most significant byte first. */
export function heightsHere(points: readonly SurveyPoint[]): string[] {
  const bits = new DataView(new ArrayBuffer(8));
  return points.map(([terrain, body, nx, ny, nz]) => {
    bits.setFloat64(0, TERRAINS[terrain]!(body, nx, ny, nz));
    return bits.getBigUint64(0).toString(16).padStart(16, '0');
  });
}
