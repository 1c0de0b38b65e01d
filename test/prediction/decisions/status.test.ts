/** What is shown of a ship, and how certain that is. */
import { describe, expect, it } from 'vitest';
import {
  CONTACT,
  CRASHED,
  FLYING,
  IMPACT_SPEED,
  LANDED,
  NEUTRAL_CONTROLS,
  SHIP_STRIDE,
  SURFACE_STATE,
  THRUST_LEVEL,
  TIPPED,
} from '../../../src/dynamics';
import {
  fillControls,
  fillServerState,
  fillStatus,
  type Instant,
  surfaceStateOf,
} from '../../../src/prediction/drawn/status';
import { createShipView } from '../../../src/prediction/drawn/shipView';
import { sessionAt, shipAt } from './sessionAt';

const TICK = 100;

/** A landed ship, seen at client wall second 100; the present is server wall second 50. */
function given() {
  const { sim } = sessionAt(TICK);
  const track = shipAt(sim, 'own', 'landed');
  const out = createShipView(track, sim.world);
  const row = track.serverRow.slice();
  const at: Instant = {
    ...{ now: 100, present: 50, elapsed: 0.01, staleAfter: 3, confirms: 0.5, paused: false },
    ...{ bodiesKnown: true, timeline: sim.timeline, serverTick: Number.NaN, serverWall: 0 },
  };
  track.seenAt = 100;
  track.picture.status.serverWall = 49.5;
  return { sim, track, out, row, at };
}
type Given = ReturnType<typeof given>;

function shown(change: (of: Given) => void = () => undefined) {
  const of = given();
  change(of);
  fillStatus(of.out, of.track, of.row, 0, of.at);
  return of.out;
}

describe('what a view shows of a ship', () => {
  it.each<readonly [string, string, (of: Given) => void]>([
    ['as the server has it', 'confirmed', () => undefined],
    ['silent for as long as allowed', 'confirmed', ({ track }) => (track.seenAt = 97)],
    ['silent for longer', 'stale', ({ track }) => (track.seenAt = 96.99)],
    ['the same in a pause', 'confirmed', (of) => ((of.track.seenAt = 0), (of.at.paused = true))],
    ['the same of a wreck', 'confirmed', (of) => ((of.track.seenAt = 0), (of.track.serverRow[CRASHED] = 1))],
    ['left out of one send', 'confirmed', ({ out }) => (out.missingSends = 1)],
    ['left out of two', 'stale', ({ out }) => (out.missingSends = 2)],
    ['of two in a pause', 'confirmed', (of) => ((of.out.missingSends = 2), (of.at.paused = true))],
    ['with its prediction off', 'off', ({ track }) => (track.off = true)],
    ['of an unknown class', 'off', ({ track }) => (track.unpredictable = true)],
    ['among unknown bodies', 'predicted', ({ at }) => (at.bodiesKnown = false)],
    ['with a relative state', 'confirmed', (of) => ((of.at.bodiesKnown = false), (of.track.exact = true))],
    [
      'a wreck among them',
      'confirmed',
      (of) => ((of.at.bodiesKnown = false), (of.track.serverRow[CRASHED] = 1)),
    ],
    ['later than a state confirms', 'predicted', ({ at }) => (at.present = 50.01)],
    ['the same in a pause', 'confirmed', (of) => ((of.at.present = 50.01), (of.at.paused = true))],
    ['not predicted at all', 'confirmed', (of) => ((of.at.present = 60), (of.track.policy = 'hold'))],
    ['in another state', 'predicted', ({ row }) => (row[SURFACE_STATE] = TIPPED)],
    ['crashed here alone', 'predicted', ({ row }) => (row[CRASHED] = 1)],
    ['extrapolated', 'predicted', ({ track }) => (track.fit.extrapolated = 'ground')],
    ['bouncing on the server alone', 'predicted', ({ track }) => (track.fit.bounces = true)],
  ])('%s: it is %s', (_, provenance, change) => {
    expect(shown(change).provenance).toBe(provenance);
  });

  it('has the age of its state while predicted, else of the server’s state, never below 0', () => {
    expect(shown().age).toBe(0.5);
    expect(shown(({ track }) => (track.picture.status.serverWall = 51)).age).toBe(0);
    const predicted = given();
    predicted.row[SURFACE_STATE] = TIPPED;
    fillStatus(predicted.out, predicted.track, predicted.row, 0, predicted.at);
    fillStatus(predicted.out, predicted.track, predicted.row, 0, { ...predicted.at, present: 50.25 });
    expect(predicted.out.age).toBe(0.25);
  });

  it.each([
    ['flying', FLYING, ['contact', 'contact', '']],
    ['landed', LANDED, ['contact', 'contact', 'landed']],
    ['tipped', TIPPED, ['contact', 'tipped', 'tipped']],
  ])('CONTACT for 0.3 s, then %s', (_, state, expected) => {
    const { track, out, row, at } = given();
    const seen = [0, 0.29, 0.31].map((later) => {
      row[SURFACE_STATE] = later === 0 ? CONTACT : state;
      fillStatus(out, track, row, 0, { ...at, now: 100 + later });
      return out.shownState;
    });
    expect(seen).toEqual(expected);
  });

  it.each<readonly [string, string, (of: Given) => void]>([
    ['here alone, as contact', 'contact', ({ row }) => (row[CRASHED] = 1)],
    ['on the server alone', 'crashed', ({ track }) => (track.serverRow[CRASHED] = 1)],
    ['on both', 'crashed', (of) => ((of.row[CRASHED] = 1), (of.track.serverRow[CRASHED] = 1))],
    [
      'on the server, between earlier states',
      'landed',
      ({ track }) => ((track.policy = 'interpolate'), (track.serverRow[CRASHED] = 1)),
    ],
  ])('a crash %s', (_, state, change) => {
    expect(shown(change).shownState).toBe(state);
  });

  it('what was withdrawn, until its time', () => {
    const withdrawn = (now: number) =>
      shown(({ track, at }) => {
        track.picture.status.withdrawn = 'landed';
        track.picture.status.withdrawnUntil = 101;
        at.now = now;
      }).withdrawn;
    expect([withdrawn(100.9), withdrawn(101)]).toEqual(['landed', '']);
  });

  it.each([
    ['a rebound of 0.31 m/s', 0.31, true, FLYING, FLYING],
    ['one of 0.29 m/s', 0.29, true, FLYING, CONTACT],
    ['a ship that the server has on the ground', 5, true, CONTACT, CONTACT],
    ['a ship that does not bounce', 5, false, FLYING, CONTACT],
  ])('flight after the touch of %s', (_, speed, bounces, server, state) => {
    const { track, row } = given();
    Object.assign(track.fit, { bounces, rebound: 0.1 });
    row[IMPACT_SPEED] = speed * 10;
    row[SURFACE_STATE] = CONTACT;
    track.serverRow[SURFACE_STATE] = server;
    expect(surfaceStateOf(track, row, 0)).toBe(state);
  });
});

it('a view has each server state once, with the wall time of its tick', () => {
  const { track, out, at } = given();
  expect([fillServerState(out, track, at), fillServerState(out, track, at)]).toEqual([true, false]);
  expect(out.serverKnown).toBe(true);
  expect([...out.serverPosition]).toEqual([...track.serverRow.subarray(0, 3)]);
  const first = track.picture.status.serverWall;
  track.serverTick = TICK + 1;
  expect(fillServerState(out, track, at)).toBe(true);
  // Ticks of 0.1 s.
  expect(track.picture.status.serverWall - first).toBeCloseTo(0.1, 12);
});

it('a view has new controls where a command changes, and the same record otherwise', () => {
  const { out, row } = given();
  const commands = new Float64Array(row.length - THRUST_LEVEL).fill(Number.NaN);
  // The ships before and after it in the fleet's rows do not matter.
  const rows = new Float64Array(3 * SHIP_STRIDE);
  rows.set(row, SHIP_STRIDE);
  const after = (column: number, value: number) => {
    rows[column] = value;
    fillControls(out, commands, rows, SHIP_STRIDE);
    return out.controls;
  };
  const first = after(0, 0);
  expect(first).not.toBe(NEUTRAL_CONTROLS);
  expect(after(0, 7)).toBe(first);
  expect(after(2 * SHIP_STRIDE, 7)).toBe(first);
  expect(after(SHIP_STRIDE + THRUST_LEVEL, 0.5)).toEqual({ ...first, thrustLevel: 0.5 });
  const { controls } = out;
  expect(after(2 * SHIP_STRIDE - 1, 0.25)).not.toBe(controls);
  expect(commands).toEqual(rows.slice(SHIP_STRIDE + THRUST_LEVEL, 2 * SHIP_STRIDE));
});
