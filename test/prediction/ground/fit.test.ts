import { expect, it } from 'vitest';
import { POSITION, VELOCITY } from '../../../src/dynamics';
import { fitGround } from '../../../src/prediction/ground/fit';
import { beginReading, type GroundPlace, offsetAt } from '../../../src/prediction/ground/learnedGround';
import { createObservation, observe } from '../../../src/prediction/ground/observe';
import { replayTo } from '../../../src/prediction/ground/trial';
import { boundaryAt } from '../../../src/prediction/snapshots/bodies/bodyTrack';
import { sessionAt, shipAt } from '../decisions/sessionAt';

/** Ticks of the two states, 1 s apart. */
const [FROM, TO] = [100, 110];
/** m/s along the ground. */
const SPEED = 10;

/**
 * A ship slides for a second, away from any axis of the body, on ground `offset` m above ours that rises by `slope` (m/m) along its way.
 * Returns that ground at the second state and the ground fitted to the two states, whose first guess is ours.
 */
function fitAfter(offset: number, slope: number) {
  const { sim } = sessionAt(FROM);
  const { world } = sim;
  const track = shipAt(sim, 'own', 'contact');
  const bodies = boundaryAt(sim.bodies, sim.timeline, FROM);
  const seen = createObservation();
  const from = track.serverRow.slice();
  const up = [...from.subarray(POSITION, POSITION + 3)].map((x, _, all) => x / Math.hypot(...all));
  const side = [up[1]! - up[2]!, up[2]! - up[0]!, up[0]! - up[1]!];
  const way = side.map((x) => x / Math.hypot(...side));
  observe(seen, from, bodies, world);
  const rise = offset - seen.gravity / 100 - seen.feet;
  for (let k = 0; k < 3; k++) {
    from[POSITION + k]! += rise * up[k]!;
    from[VELOCITY + k]! += SPEED * (way[k]! + slope * up[k]!);
  }
  observe(seen, from, bodies, world);
  const placeThere = (more: Partial<GroundPlace>): GroundPlace => ({
    bodyName: world.bodies[0]!.name,
    bodyRadius: world.bodies[0]!.radius,
    direction: seen.direction.slice(),
    offset: 0,
    slope: new Float64Array(3),
    states: 1,
    seenAt: 0,
    weight: 1,
    ...more,
  });
  beginReading(track.ground);
  const real = placeThere({ offset, slope: seen.way.map((x) => slope * x) });
  track.ground.places.push(real);
  const to = replayTo(sim, track, { from, fromTick: FROM, toTick: TO }).slice();
  track.ground.places.pop();
  observe(seen, to, boundaryAt(sim.bodies, sim.timeline, TO), world);
  const place = placeThere({});
  const evidence = { from, fromTick: FROM, to, toTick: TO };
  const cost = fitGround(
    { sim, track, evidence, seen, place },
    track.ground,
    [{ offset: 0, slope: 0 }],
    false,
  );
  expect(track.ground.places).toEqual([]);
  const [x, y, z] = seen.direction as unknown as [number, number, number];
  return { real, there: offsetAt([real], real.bodyName, x, y, z), place, cost, seen };
}

it.each([
  [0.3, 0.05],
  [-0.05, -0.02],
  [0.1, 0],
])('ground %f m above ours with a slope of %f is found from two states of a slide on it', (offset, slope) => {
  const { real, there, place, cost, seen } = fitAfter(offset, slope);
  expect(seen.grounded).toBe(true);
  expect(cost).toBeLessThan(0.1);
  expect(place.offset).toBeCloseTo(there, 2);
  for (let k = 0; k < 3; k++) expect(Math.abs(place.slope[k]! - real.slope[k]!)).toBeLessThan(0.003);
});
