import { describe, expect, it } from 'vitest';
import {
  BODY_STRIDE,
  CRASHED,
  FUEL,
  POSITION,
  ROTATION_INPUT,
  THRUST_LEVEL,
  TRANSLATION_INPUT,
} from '../../../src/dynamics';
import { has } from '../../../src/prediction/simulation/rings/history';
import { isAtRest, sleepAtFirst, sleepIfAtRest, wake } from '../../../src/prediction/simulation/sleep';
import type { Mode } from '../../../src/prediction/simulation/track';
import { boundaryAt } from '../../../src/prediction/snapshots/bodies/bodyTrack';
import { sessionAt, shipAt } from './sessionAt';

const TICK = 100;

function landed() {
  const { sim } = sessionAt(TICK);
  const track = shipAt(sim, 'own', 'landed');
  const bodies = boundaryAt(sim.bodies, sim.timeline, TICK).slice(0, BODY_STRIDE);
  return { sim, track, bodies };
}

describe('a ship is at rest', () => {
  it.each([
    ['landed', 0, 0, true],
    ['turning its stick', ROTATION_INPUT, 1, true],
    ['at thrust', THRUST_LEVEL, 0.1, false],
    ['with thrusters', TRANSLATION_INPUT + 2, -1, false],
    ['crashed', CRASHED, 1, false],
  ])('%s', (_, column, set, expected) => {
    const { track } = landed();
    if (column > 0) track.serverRow[column] = set;
    expect(isAtRest(track.serverRow, 0)).toBe(expected);
  });

  it('with thrust but no fuel, and not in contact', () => {
    const { track, sim } = landed();
    track.serverRow[THRUST_LEVEL] = 1;
    track.serverRow[FUEL] = 0;
    expect(isAtRest(track.serverRow, 0)).toBe(true);
    expect(isAtRest(shipAt(sim, 'b', 'contact').serverRow, 0)).toBe(false);
  });
});

describe('sleep', () => {
  it('begins only where server and front are at rest, and never while rollbacks are forced', () => {
    const asleep = landed();
    expect(sleepIfAtRest(asleep.sim, asleep.track, asleep.bodies)).toBe(true);
    expect(asleep.track.mode).toBe('sleeping');
    const burning = landed();
    burning.sim.fleet.front[burning.track.at + THRUST_LEVEL] = 1;
    expect(sleepIfAtRest(burning.sim, burning.track, burning.bodies)).toBe(false);
    const forced = landed();
    expect(sleepIfAtRest({ ...forced.sim, sleep: null }, forced.track, forced.bodies)).toBe(false);
    expect([burning.track.mode, forced.track.mode]).toEqual(['stepping', 'stepping']);
  });

  it('ends with a history since the server’s state, on the turning body', () => {
    const { sim, track, bodies } = landed();
    sleepIfAtRest(sim, track, bodies);
    sim.front.tick = TICK + 5;
    const before = sim.fleet.front[track.at + POSITION]!;
    wake(sim, track);
    expect(track.mode).toBe('stepping');
    for (let tick = TICK; tick <= TICK + 5; tick++) expect(has(track.history, tick)).toBe(true);
    const moved = Math.abs(sim.fleet.front[track.at + POSITION]! - before);
    expect(moved).toBeGreaterThan(0.1);
    expect(moved).toBeLessThan(10);
  });
});

interface FirstSeen {
  readonly thrust?: number;
  readonly mode?: Mode;
  readonly hasHeld?: boolean;
  readonly isForced?: boolean;
}

describe('a ship first seen', () => {
  it.each<readonly [string, FirstSeen, Mode]>([
    ['landed', {}, 'sleeping'],
    ['at thrust', { thrust: 1 }, 'waiting'],
    ['stepped already', { mode: 'stepping' }, 'stepping'],
    ['drawn where it is held', { hasHeld: true }, 'waiting'],
    ['while rollbacks are forced', { isForced: true }, 'waiting'],
  ])('%s: it sleeps at once only if all that is known is that it rests', (_, given, after) => {
    const { thrust = 0, mode = 'waiting', hasHeld = false, isForced = false } = given;
    const { sim, track, bodies } = landed();
    track.mode = mode;
    track.picture.hasHeld = hasHeld;
    track.serverRow[THRUST_LEVEL] = thrust;
    sim.fleet.front[track.at + POSITION] = 0;
    sleepAtFirst(isForced ? { ...sim, sleep: null } : sim, track, bodies);
    expect(track.mode).toBe(after);
    expect(sim.fleet.front[track.at + POSITION] === track.serverRow[POSITION]).toBe(after === 'sleeping');
  });
});
