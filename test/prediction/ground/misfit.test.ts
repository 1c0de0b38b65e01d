import { expect, it } from 'vitest';
import { CRASHED, POSITION, SURFACE_STATE, VELOCITY } from '../../../src/dynamics';
import { createMisfit, replayBetween } from '../../../src/prediction/ground/trial';
import { sessionAt, shipAt } from '../decisions/sessionAt';

const TICK = 100;
/** m. */
const RADIUS = 1_737_400;

/** Two states of one tick, of which the first is `height` m above and `along` m beside the second, and climbs by `climb` m/s more. */
function misfitOf({ height = 0, along = 0, climb = 0, change = (_: Float64Array) => {} }) {
  const { sim } = sessionAt(TICK);
  const track = shipAt(sim, 'own', '');
  const up = [2 / 7, 3 / 7, 6 / 7];
  const across = [3 / Math.sqrt(13), -2 / Math.sqrt(13), 0];
  const [from, to] = [track.serverRow.slice(), track.serverRow.slice()];
  for (let k = 0; k < 3; k++) {
    to[POSITION + k] = RADIUS * up[k]!;
    from[POSITION + k] = to[POSITION + k]! + height * up[k]! + along * across[k]!;
    to[VELOCITY + k] = 7 * across[k]!;
    from[VELOCITY + k] = to[VELOCITY + k]! + climb * up[k]! + 5 * across[k]!;
  }
  change(from);
  const misfit = createMisfit();
  replayBetween(misfit, sim, track, { from, fromTick: TICK, to, toTick: TICK });
  return misfit;
}

it.each([
  [3, 0, 0],
  [-2, 0, 1.5],
  [0, 4, -0.5],
  [-2, 4, 2],
])('separates %f m of height, %f m along the ground and %f m/s of climb, far from any axis', (...given) => {
  const [height, along, climb] = given;
  const misfit = misfitOf({ height, along, climb });
  expect(misfit.height).toBeCloseTo(height, 6);
  // The root of a difference of squares: 1e-9 m of rounding in the height.
  expect(misfit.along).toBeCloseTo(along, 4);
  expect(misfit.climb).toBeCloseTo(climb, 6);
  expect(misfit.sameState).toBe(true);
});

it.each([
  ['a surface state', SURFACE_STATE, 1],
  ['a crash', CRASHED, 1],
])('notices %s that the server does not have', (_, column, value) => {
  expect(misfitOf({ change: (row) => (row[column] = value) }).sameState).toBe(false);
});
