/** What a pilot's sample becomes, and what a bounce on the server alone teaches. */
import { describe, expect, it } from 'vitest';
import {
  CONTACT,
  type Controls,
  FLYING,
  IMPACT_SPEED,
  NEUTRAL_CONTROLS,
  POSITION,
  SHIP_STRIDE,
  SURFACE_STATE,
  VELOCITY,
  writeControls,
} from '../../../src/dynamics';
import { createPilot, sampleControls } from '../../../src/prediction/inputs/pilot';
import { keep } from '../../../src/prediction/simulation/rings/history';
import { learnBounce } from '../../../src/prediction/snapshots/reconcile/bounceFit';
import { RATE, sessionAt, shipAt } from './sessionAt';

const TICK = 100;

/** A pilot of a ship at substep 3 of TICK, and the controls in force there. */
function seated(substep = 3) {
  const { sim } = sessionAt(TICK);
  const track = shipAt(sim, 'own', 'landed');
  sim.fleet.own = track;
  sim.front.substep = substep;
  const pilot = createPilot();
  const inForce = NEUTRAL_CONTROLS;
  writeControls(sim.fleet.front, track.at, inForce);
  const sample = (changes: Partial<Controls>, granularity: 'substep' | 'tick' = 'substep') => {
    sampleControls(sim, pilot, { ...inForce, ...changes }, { now: 7, steer: 0.25, granularity });
    return sim.inputs.records.map(({ tick, substep: at, record }) => [tick, at, record.controls.thrustLevel]);
  };
  return { sim, pilot, inForce, sample };
}

describe('a sample of the controls', () => {
  it('creates no input if the controls are already in force', () => {
    const { pilot, inForce, sample } = seated();
    expect(sample({})).toEqual([]);
    expect(pilot.last).toEqual(inForce);
  });

  it.each([
    ['substep', 3, [TICK, 3]],
    ['tick', 3, [TICK + 1, 0]],
    ['tick', 0, [TICK, 0]],
  ] as const)('with granularity %s at substep %i acts at %o', (granularity, substep, stamp) => {
    const { sim, sample } = seated(substep);
    expect(sample({ thrustLevel: 0.5 }, granularity)).toEqual([[...stamp, 0.5]]);
    expect(sim.inputs.records[0]).toMatchObject({
      sampledAt: 7,
      steer: 0.25,
    });
  });

  it('is compared with the newest pending input', () => {
    const { sim, sample } = seated();
    sample({ thrustLevel: 0.5 }, 'tick');
    expect(sample({ thrustLevel: 0.5 }, 'tick')).toHaveLength(1);
    sim.inputs.unsent = 1;
    expect(sample({ thrustLevel: 0.5 }, 'tick')).toHaveLength(1);
    // In force now, but not once that input acts.
    expect(sample({}, 'tick')).toEqual([
      [TICK + 1, 0, 0.5],
      [TICK + 1, 0, 0],
    ]);
  });

  it('is ignored if it is not finite', () => {
    const { pilot, sample } = seated();
    expect(sample({ thrustLevel: NaN })).toEqual([]);
    expect(pilot.last).toBeNull();
  });

  it('releases keys held before an absence until they change', () => {
    const { sim, pilot, inForce, sample } = seated();
    const held = { rotationInput: [1, 0, 0] as const };
    pilot.released = { ...inForce, ...held };
    expect(sample(held)).toEqual([]);
    expect(pilot.last).toEqual({ ...inForce, ...held });
    sample({ rotationInput: [0, 1, 0] });
    expect(pilot.released).toBeNull();
    expect(sim.inputs.records.at(-1)!.record.controls.rotationInput).toEqual([0, 1, 0]);
  });

  it('ends the plan, even if it equals the controls in force', () => {
    const { sim, inForce, sample } = seated();
    sim.inputs.plan = [{ tick: TICK + 9, substep: 0, controls: inForce }];
    expect(sample({})).toEqual([[TICK, 3, 0]]);
  });

  it('of a spectator is ignored', () => {
    const { sim, sample } = seated();
    sim.fleet.own = null;
    expect(sample({ thrustLevel: 1 })).toEqual([]);
  });
});

describe('a ship predicted on the ground', () => {
  /** Since a state in flight at TICK − 3, by prediction in flight at TICK − 2 and on the ground then; the server has it `climb` m/s up. */
  function predictedDown({ server = FLYING, climb = 3, before = FLYING, here = CONTACT } = {}) {
    const { sim } = sessionAt(TICK);
    const track = shipAt(sim, 'own', 'contact');
    const { front } = sim.fleet;
    const rows = front.slice(track.at, track.at + SHIP_STRIDE);
    track.evidence.tick = TICK - 3;
    track.evidence.row[SURFACE_STATE] = before;
    for (const [tick, state] of [
      [TICK - 2, FLYING],
      [TICK - 1, CONTACT],
    ] as const) {
      front[track.at + SURFACE_STATE] = state;
      keep(track.history, tick, front, track.at);
    }
    front[track.at + SURFACE_STATE] = here;
    front[track.at + IMPACT_SPEED] = 10;
    const place = [...rows.subarray(POSITION, POSITION + 3)];
    const radius = Math.sqrt(place.reduce((sum, x) => sum + x * x, 0));
    // 2 m higher than predicted.
    rows.set(
      place.map((x) => x * (1 + 2 / radius)),
      POSITION,
    );
    rows.set(
      place.map((x) => (x * climb) / radius),
      VELOCITY,
    );
    rows[SURFACE_STATE] = server;
    const bodies = new Float64Array(0);
    const judged = {
      state: { rows, at: 0, bodies },
      tick: TICK,
      agrees: false,
    };
    const predicted = { rows: front, at: track.at, bodies };
    const learn = (given: typeof predicted | null = predicted) => {
      learnBounce(sim, track, { ...judged, predicted: given }, RATE);
      return track.fit;
    };
    return { sim, rows, radius, learn };
  }

  it('has bounced if it climbs on the server, after two ticks wrongly on the ground', () => {
    const { sim, radius, learn } = predictedDown();
    const fit = learn();
    expect(fit).toMatchObject({ bounces: true, groundedRightly: 0 });
    expect(fit.groundedWrongly).toBeCloseTo(0.2, 12);
    // It left the ground faster than it is 2 m up.
    const gravity = sim.world.bodies[0]!.gravityParameter / (radius + 2) ** 2;
    expect(fit.rebound).toBeCloseTo(Math.sqrt(9 + 4 * gravity) / 10, 6);
  });

  it('is shown as bouncing once its contacts were wrong for 20 ms longer than right; the last touch counts most', () => {
    const { rows, learn } = predictedDown();
    learn();
    rows[SURFACE_STATE] = CONTACT;
    // 0.8 × 0.2 s of the touch before.
    expect(learn()).toMatchObject({
      bounces: false,
      groundedWrongly: expect.closeTo(0.16, 12) as number,
    });
    expect(learn().groundedRightly).toBeCloseTo(0.36, 12);
    rows[SURFACE_STATE] = FLYING;
    expect(learn().bounces).toBe(false);
    expect(learn().bounces).toBe(true);
  });

  it.each([
    ['falls on the server', { climb: -1 }],
    ['flies here too', { here: FLYING }],
    ['was on the ground before', { before: CONTACT }],
  ])('is not evaluated if it %s', (_, how) => {
    expect(predictedDown(how).learn()).toMatchObject({
      groundedWrongly: 0,
      groundedRightly: 0,
      bounces: false,
    });
  });

  it('is not evaluated without a prediction', () => {
    expect(predictedDown().learn(null).groundedWrongly).toBe(0);
  });
});
