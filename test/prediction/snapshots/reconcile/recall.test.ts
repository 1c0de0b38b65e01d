import { describe, expect, it } from 'vitest';
import {
  CONTACT,
  CRASHED,
  FLYING,
  IMPACT_SPEED,
  REFERENCE_BODY,
  SHIP_STRIDE,
  SURFACE_STATE,
  WHEEL_MOMENTUM,
} from '../../../../src/dynamics';
import { keepState } from '../../../../src/prediction/ground/lastState';
import { replayTo } from '../../../../src/prediction/ground/trial';
import {
  recalledImpact,
  recallWheels,
  replayImpact,
} from '../../../../src/prediction/snapshots/reconcile/recall';
import { setTempo } from '../../../../src/prediction/time/timeline';
import { RATE, sessionAt, shipAt } from '../../decisions/sessionAt';

const TICK = 100;
/** Ticks until a ship that is 6 m above the ground and sinks at 2.5 m/s has touched it. */
const FALL = 22;

/** A ship whose last state was in flight, and the server's state of it on the ground. */
function touched() {
  const { sim } = sessionAt(TICK);
  const track = shipAt(sim, 'own', '');
  keepState(track.evidence, track.serverRow, TICK);
  const row = replayTo(sim, track, { from: track.serverRow, fromTick: TICK, toTick: TICK + FALL }).slice();
  const speed = row[IMPACT_SPEED]!;
  return { sim, track, row, speed, tick: TICK + FALL };
}
type Touched = ReturnType<typeof touched>;

describe('an impact speed that the server does not send', () => {
  const predicted = (state: number, body = 0) => {
    const rows = new Float64Array(2 * SHIP_STRIDE);
    rows[SHIP_STRIDE + SURFACE_STATE] = state;
    rows[SHIP_STRIDE + IMPACT_SPEED] = 4;
    rows[SHIP_STRIDE + REFERENCE_BODY] = body;
    return { rows, at: SHIP_STRIDE, bodies: new Float64Array(0) };
  };
  const recalled = (place: ReturnType<typeof predicted> | null, state = CONTACT) => {
    const { sim, track, row, tick } = touched();
    row[SURFACE_STATE] = state;
    return recalledImpact(sim, track, { row, tick }, place);
  };

  it('is the predicted one if contact was predicted', () => {
    expect(recalled(predicted(CONTACT))).toBe(4);
  });

  it('is otherwise computed by the dynamics from the last state', () => {
    const { speed } = touched();
    expect(speed).toBeCloseTo(Math.sqrt(2.5 ** 2 + 2 * 1.62 * 6), 1);
    for (const place of [predicted(FLYING), predicted(CONTACT, 1), null]) expect(recalled(place)).toBe(speed);
  });

  it('is 0 in flight', () => {
    expect(recalled(null, FLYING)).toBe(0);
  });
});

describe('the dynamics since the last state', () => {
  const impact = (prepare: (of: Touched) => void, more: Partial<Touched> = {}) => {
    const of = { ...touched(), ...more };
    prepare(of);
    return replayImpact(of.sim, of.track, { row: of.row, tick: of.tick });
  };

  it('end in the contact', () => {
    expect(impact(() => undefined)).toBe(touched().speed);
  });

  it.each<[string, (of: Touched) => void]>([
    ['the last state is unknown', ({ track }) => (track.evidence.tick = -1)],
    ['it is no earlier one', ({ track, tick }) => (track.evidence.tick = tick)],
    ['its bodies are', ({ sim }) => sim.bodies.ticks.fill(-1)],
    ['it is a wreck', ({ track }) => (track.evidence.row[CRASHED] = 1)],
    ['it is of another body', ({ track }) => (track.evidence.row[REFERENCE_BODY] = 1)],
    [
      'time stood',
      ({ sim }) => setTempo(sim.timeline, TICK, { tickRate: RATE, timeScale: 1, paused: true }, null),
    ],
    ['they do not touch the ground', (of) => (of.tick = TICK + 5)],
    ['they are more than 400 substeps', (of) => (of.tick = TICK + 41)],
  ])('tell nothing where %s', (_, prepare) => expect(impact(prepare)).toBe(0));

  it('are computed over at most 400 substeps', () => {
    expect(impact((of) => (of.tick = TICK + 40))).toBe(touched().speed);
  });
});

describe('the momentum of the wheels', () => {
  it('is the predicted one, or 0 without a prediction; nothing else changes', () => {
    const rows = Float64Array.from({ length: 2 * SHIP_STRIDE }, (_, k) => k + 1);
    const filled = (predicted: Parameters<typeof recallWheels>[1]) => {
      const row = new Float64Array(SHIP_STRIDE).fill(-1);
      recallWheels(row, predicted);
      return row;
    };
    const wheels = (row: Float64Array) => [...row.subarray(WHEEL_MOMENTUM, WHEEL_MOMENTUM + 3)];
    const at = SHIP_STRIDE;
    const known = filled({ rows, at, bodies: rows });
    expect(wheels(known)).toEqual(wheels(rows.subarray(at)));
    expect(wheels(filled(null))).toEqual([0, 0, 0]);
    expect(known.filter((x) => x !== -1)).toHaveLength(3);
  });
});
