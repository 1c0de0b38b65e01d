/** The ground below a bounce, by the two parabolas that meet there; a bounce has a quarter of the speed of its fall unless the case gives another share. */
import { describe, expect, it } from 'vitest';
import { CONTACT, POSITION, SURFACE_STATE, THRUST_LEVEL } from '../../../src/dynamics';
import { groundOfBounce } from '../../../src/prediction/ground/bounceHeight';
import { createObservation, observe } from '../../../src/prediction/ground/observe';
import { boundaryAt } from '../../../src/prediction/snapshots/bodies/bodyTrack';
import { sessionAt, shipAt } from '../decisions/sessionAt';
import { climbAt } from '../touchdown/rewinding';

const TICK = 100;
/** Ticks and s between the two states, and m/s² on the Moon. */
const TICKS = 40;
const SECONDS = 4;
const GRAVITY = 1.6243;

interface Bounce {
  /** Where the parabolas meet, m above our ground; the speed there, m/s, and after it as a share; s before it that the first state is. */
  readonly meets?: number;
  readonly fall?: number;
  readonly share?: number;
  readonly before?: number;
  readonly change?: (from: Float64Array, to: Float64Array) => void;
}

function learned({ meets = 0.6, fall = 12, share = 0.25, before = 2, change }: Bounce): number | null {
  const { sim } = sessionAt(TICK);
  const track = shipAt(sim, 'own', '');
  const seen = createObservation();
  observe(seen, track.serverRow, boundaryAt(sim.bodies, sim.timeline, TICK), sim.world);
  /** A state in flight, `feet` m above our ground, climbing at `climb` m/s. */
  const rowAt = (feet: number, climb: number) => {
    const row = track.serverRow.slice();
    const distance = Math.hypot(...row.subarray(POSITION, POSITION + 3));
    for (let k = 0; k < 3; k++) row[POSITION + k]! *= (distance + feet - seen.feet) / distance;
    return climbAt(row, climb);
  };
  const after = SECONDS - before;
  const from = rowAt(meets + (fall - (GRAVITY * before) / 2) * before, GRAVITY * before - fall);
  const rebound = share * fall;
  const to = rowAt(meets + (rebound - (GRAVITY * after) / 2) * after, rebound - GRAVITY * after);
  change?.(from, to);
  return groundOfBounce(sim, { from, to, fromTick: TICK, toTick: TICK + TICKS }, 0);
}

/** m that a contact of 0.3 s goes deeper than where the parabolas meet. */
const depthOf = (fall = 12, share = 0.25) => (0.3 * fall * share) / (1 + share);

describe('the ground below a bounce', () => {
  it.each<Bounce>([
    {},
    { meets: -1.5 },
    { meets: 0.2, fall: 16, share: 0.3 },
    { before: 1 },
    { before: 3 },
    { share: 0.21 },
    { fall: 10.1 },
  ])('is that of both falls: %o', (bounce) => {
    const { meets = 0.6, fall, share } = bounce;
    expect(learned(bounce)).toBeCloseTo(meets + depthOf(fall, share), 1);
  });

  it.each<readonly [string, Bounce]>([
    ['under thrust', { change: (from) => (from[THRUST_LEVEL] = 0.1) }],
    ['on the ground before', { change: (from) => (from[SURFACE_STATE] = CONTACT) }],
    ['on the ground after', { change: (_, to) => (to[SURFACE_STATE] = CONTACT) }],
    ['rebounding at less than a fifth, perhaps a second time', { share: 0.19 }],
    ['falling too slowly to bounce', { fall: 9.9 }],
    ['that met the ground before the first state', { before: -0.1 }],
    ['that meets it after the second', { before: 4.1 }],
  ])('is not learned from a ship %s', (_, bounce) => expect(learned(bounce)).toBeNull());

  it('is learned where it differs by more than the contact is unsure, and by less than 1.5 m', () => {
    const unsure = 0.1 + 0.3 * depthOf();
    const learns = (offset: number) => learned({ meets: offset - depthOf() }) !== null;
    const either = [unsure + 0.02, 1.48].flatMap((offset) => [learns(offset), learns(-offset)]);
    expect(either).toEqual([true, true, true, true]);
    const neither = [unsure - 0.02, 1.52].flatMap((offset) => [learns(offset), learns(-offset)]);
    expect(neither).toEqual([false, false, false, false]);
  });
});
