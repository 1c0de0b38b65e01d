import { describe, expect, it } from 'vitest';
import {
  BODY_ATTITUDE,
  NEUTRAL_CONTROLS,
  POSITION,
  REFERENCE_BODY,
  SURFACE_STATE,
  THRUST_LEVEL,
  VELOCITY,
} from '../../../../src/dynamics';
import { rotate } from '../../../../src/prediction/drawn/rotation';
import { keepState } from '../../../../src/prediction/ground/lastState';
import { replayTo } from '../../../../src/prediction/ground/trial';
import { store } from '../../../../src/prediction/inputs/inputs';
import { boundaryAt } from '../../../../src/prediction/snapshots/bodies/bodyTrack';
import { learnFrom } from '../../../../src/prediction/snapshots/reconcile/learnFrom';
import { chooseMotion } from '../../../../src/prediction/snapshots/reconcile/lawFit';
import { setTempo } from '../../../../src/prediction/time/timeline';
import { product, turnAbout } from '../../../dynamics/vectors';
import { RATE, sessionAt, shipAt } from '../../decisions/sessionAt';

const TICK = 100;

/** A ship with a state in flight at TICK, and the server's `ticks` later, as the dynamics lead to it and as predicted. */
function flown(ticks = 1) {
  const { sim, receiver } = sessionAt(TICK);
  const track = shipAt(sim, 'own', '');
  track.own = true;
  keepState(track.evidence, track.serverRow, TICK);
  const tick = TICK + ticks;
  const row = replayTo(sim, track, { from: track.serverRow, fromTick: TICK, toTick: tick }).slice();
  const bodies = boundaryAt(sim.bodies, sim.timeline, tick);
  const predicted = { rows: row.slice(), at: 0, bodies };
  const of = { sim, track, fit: track.fit, row, predicted, tick, agrees: true, receiver, bodies };
  const choose = () => {
    const state = { rows: of.row, at: 0, bodies };
    return chooseMotion(sim, track, { state, tick: of.tick, predicted: of.predicted, agrees: of.agrees });
  };
  return Object.assign(of, { choose });
}
type Flown = ReturnType<typeof flown>;

/** What the ship has after this state, with the errors of the states before it: their number and sums, m. */
function chosen(
  states: number,
  law: number,
  extrapolation: number,
  prepare: (of: Flown) => void = () => undefined,
) {
  const of = flown();
  of.fit.count = states;
  // In a slot that this state leaves alone.
  const slot = (states + 1) % 4;
  of.fit.law[slot] = law;
  of.fit.extrapolation[slot] = extrapolation;
  prepare(of);
  const { extrapolated } = of.fit;
  expect(of.choose()).toBe(of.fit.extrapolated !== extrapolated);
  return of.fit.extrapolated;
}
const extrapolatedBefore = ({ fit }: Flown) => (fit.extrapolated = 'law');

describe('a simulated ship', () => {
  it('is extrapolated if the dynamics are worse by a quarter and 3 cm per state, over four states', () => {
    expect([chosen(3, 0.121, 0), chosen(3, 0.119, 0)]).toEqual(['law', '']);
    expect([chosen(3, 1.371, 1), chosen(3, 1.369, 1)]).toEqual(['law', '']);
    expect([chosen(7, 0.121, 0), chosen(7, 0.119, 0)]).toEqual(['law', '']);
  });

  it('stays simulated before the third state', () => {
    expect([chosen(1, 9, 0), chosen(2, 0.091, 0), chosen(2, 0.089, 0)]).toEqual(['', 'law', '']);
  });
});

describe('an extrapolated ship', () => {
  it('is simulated again once the dynamics are worse by at most 2 cm per state', () => {
    // The state itself is as the dynamics have it; falling without thrust is the same.
    expect([chosen(3, 0.079, 0, extrapolatedBefore), chosen(3, 0.081, 0, extrapolatedBefore)]).toEqual([
      '',
      'law',
    ]);
    expect([chosen(3, 1.079, 1, extrapolatedBefore), chosen(3, 1.081, 1, extrapolatedBefore)]).toEqual([
      '',
      'law',
    ]);
  });

  it('is compared with a replay of the dynamics and with a fall without thrust since its last state', () => {
    const of = flown(10);
    extrapolatedBefore(of);
    for (const rows of [of.track.evidence.row, of.row]) rows[THRUST_LEVEL] = 0;
    of.row[POSITION]! += 4;
    of.choose();
    expect(of.fit.law[0]).toBeCloseTo(4, 3);
    expect(of.fit.extrapolation[0]).toBeCloseTo(4, 2);
    expect(of.fit.count).toBe(1);
  });

  it('above unknown ground is not compared', () => {
    const of = flown();
    of.fit.extrapolated = 'ground';
    expect([of.choose(), of.fit.count]).toEqual([false, 0]);
  });
});

describe('the errors of a state', () => {
  it('are 0 if it agrees', () => {
    const of = flown();
    of.fit.law.fill(9);
    of.fit.extrapolation.fill(9);
    of.choose();
    expect([of.fit.law[0], of.fit.extrapolation[0], of.fit.law[1]]).toEqual([0, 0, 9]);
  });

  it('are its distances from the prediction and from the fall', () => {
    const of = flown(10);
    of.agrees = false;
    // (2, −3, 6) is 7 long.
    for (const [k, x] of [2, -3, 6].entries()) of.row[POSITION + k]! += x;
    of.choose();
    expect(of.fit.law[0]).toBeCloseTo(7, 6);
    expect(of.fit.extrapolation[0]).toBeCloseTo(7, 1);
  });

  it('are measured in the body’s axes: a body predicted as turned too far is no error', () => {
    const of = flown();
    of.agrees = false;
    const turn = turnAbout([0, 0, 1], 0.01);
    const turned = of.predicted.rows.slice(POSITION, POSITION + 3);
    rotate(turned, Float64Array.from(turn), turned);
    of.predicted.rows.set(turned, POSITION);
    of.predicted.bodies = of.bodies.slice();
    const [x, y, z, w] = of.bodies.slice(BODY_ATTITUDE, BODY_ATTITUDE + 4);
    of.predicted.bodies.set(product(turn, [x!, y!, z!, w!]), BODY_ATTITUDE);
    of.choose();
    expect(of.fit.law[0]).toBeLessThan(1e-6);
  });

  it('are 0 for the dynamics without a prediction', () => {
    const of = flown();
    Object.assign(of, { agrees: false, predicted: null });
    of.row[POSITION]! += 5;
    of.choose();
    expect([of.fit.law[0], of.fit.extrapolation[0]]).toEqual([0, expect.closeTo(5, 3)]);
  });

  it('include the angle, times the ship’s height', () => {
    const of = flown();
    of.agrees = false;
    const [x, y, z, w] = of.row.slice(6, 10) as unknown as [number, number, number, number];
    // By 0.2 rad about its own z.
    const [s, c] = [Math.sin(0.1), Math.cos(0.1)];
    of.row.set([x * c + y * s, y * c - x * s, z * c + w * s, w * c - z * s], 6);
    of.choose();
    const height = of.sim.world.shipClasses[0]!.groundContactOffset;
    expect(of.fit.law[0]).toBeCloseTo(0.2 * height, 6);
  });
});

describe('a state is not compared', () => {
  it.each<[string, (of: Flown) => void]>([
    ['with another command than predicted', ({ row }) => (row[THRUST_LEVEL] = 0.5)],
    [
      'with an input of the pilot since the last',
      ({ sim }) => {
        store(sim.inputs, { ...NEUTRAL_CONTROLS, thrustLevel: 1 }, { tick: TICK, substep: 5 }, 0, 0);
      },
    ],
    ['without a last one', ({ track }) => (track.evidence.tick = -1)],
    ['that is no later than the last', (of) => (of.track.evidence.tick = of.tick)],
    ['whose last one’s bodies are unknown', ({ sim }) => sim.bodies.ticks.fill(-1)],
    ['at another body', ({ track }) => (track.evidence.row[REFERENCE_BODY] = 1)],
    ['with another command than the last', ({ track }) => (track.evidence.row[THRUST_LEVEL] = 0.5)],
    [
      'after a pause',
      ({ sim }) => setTempo(sim.timeline, TICK, { tickRate: RATE, timeScale: 1, paused: true }, null),
    ],
    [
      'in another tempo',
      ({ sim }) => setTempo(sim.timeline, TICK + 1, { tickRate: 5, timeScale: 1, paused: false }, null),
    ],
    ['more than 400 substeps after the last', (of) => (of.tick = TICK + 41)],
  ])('%s', (_, prepare) => {
    const of = flown();
    prepare(of);
    expect([of.choose(), of.fit.count]).toEqual([false, 0]);
  });

  it('but is compared up to 400 substeps after it', () => {
    const of = flown();
    of.tick = TICK + 40;
    of.choose();
    expect(of.fit.count).toBe(1);
  });
});

describe('a ship above ground that is not loaded', () => {
  const learned = (isLoaded: boolean, extrapolated: '' | 'law' | 'ground') => {
    const of = flown();
    of.fit.extrapolated = extrapolated;
    const world = { ...of.sim.world, terrainHeight: () => (isLoaded ? 0 : null) as never };
    const context = Object.assign(of.receiver.context, { tick: of.tick, now: 5, bodies: of.bodies });
    const lesson = { row: of.row, context, predicted: of.predicted, agrees: true, hasImpact: true };
    const changes = learnFrom({ ...of.sim, world }, of.track, lesson);
    return [changes, of.fit.extrapolated, of.fit.states, of.sim.counters.statesExtrapolated];
  };

  it('is extrapolated, and simulated again once it is loaded; each state meanwhile is counted', () => {
    expect(learned(false, '')).toEqual([true, 'ground', 1, 1]);
    expect(learned(false, 'ground')).toEqual([false, 'ground', 1, 1]);
    expect(learned(false, 'law')).toEqual([true, 'ground', 1, 1]);
    expect(learned(true, 'ground')).toEqual([true, '', 0, 0]);
    expect(learned(true, '')).toEqual([false, '', 0, 0]);
    expect(learned(true, 'law').slice(2)).toEqual([1, 1]);
  });

  it('moves at its own speed', () => {
    const of = flown();
    expect(Math.hypot(...of.row.slice(VELOCITY, VELOCITY + 3))).toBeGreaterThan(1);
    expect(of.row[SURFACE_STATE]).toBe(0);
  });
});
