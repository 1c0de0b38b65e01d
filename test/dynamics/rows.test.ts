import { describe, expect, it } from 'vitest';
import {
  ATTITUDE_MODES,
  CONTACT,
  EVENT_NAMES,
  FLYING,
  hashRows,
  isTransitionAllowed,
  LANDED,
  SURFACE_STATES,
  TIPPED,
} from '../../src/dynamics';
import { createTrial, run } from './provingGround';

describe('state transitions', () => {
  // The table of transitions of DYNAMICS; a launched ship may touch again in the same substep, and staying is always allowed.
  const LEGAL: readonly (readonly [number, number])[] = [
    [FLYING, CONTACT],
    [CONTACT, FLYING],
    [CONTACT, LANDED],
    [CONTACT, TIPPED],
    [LANDED, FLYING],
    [LANDED, CONTACT],
    [TIPPED, FLYING],
    [TIPPED, CONTACT],
  ];

  it('are those of the table and no others', () => {
    for (const from of [FLYING, CONTACT, LANDED, TIPPED]) {
      for (const to of [FLYING, CONTACT, LANDED, TIPPED]) {
        const legal = from === to || LEGAL.some(([a, b]) => a === from && b === to);
        expect([from, to, isTransitionAllowed(from, to)]).toEqual([from, to, legal]);
      }
    }
  });

  it('include none from or to an unknown state', () => {
    expect(isTransitionAllowed(FLYING, 4)).toBe(false);
    expect(isTransitionAllowed(7, FLYING)).toBe(false);
    expect(isTransitionAllowed(Number.NaN, FLYING)).toBe(false);
  });
});

describe('state and event names', () => {
  it('are the game’s, in numerical order', () => {
    expect(SURFACE_STATES).toEqual(['', 'contact', 'landed', 'tipped']);
    expect(EVENT_NAMES.slice(1).map((name) => name.slice(5))).toEqual([
      'contact',
      'landed',
      'tipped',
      'righted',
      'destroyed',
    ]);
    expect(ATTITUDE_MODES.indexOf('antiradial')).toBe(8);
  });
});

describe('row hash', () => {
  // FNV-1a, 32 bits, of the published test vectors' kind: eight zero bytes, and the bytes of 1.0, computed in Python.
  it('is FNV-1a over the bytes, least significant first', () => {
    expect(hashRows(new Float64Array(0))).toBe(0x811c9dc5);
    let zeros = 0x811c9dc5n;
    for (let i = 0; i < 8; i++) zeros = (zeros * 0x01000193n) & 0xffffffffn;
    expect(hashRows(Float64Array.of(0))).toBe(Number(zeros));
    let one = 0x811c9dc5n;
    for (const byte of [0, 0, 0, 0, 0, 0, 0xf0n, 0x3fn])
      one = ((one ^ BigInt(byte)) * 0x01000193n) & 0xffffffffn;
    expect(hashRows(Float64Array.of(1))).toBe(Number(one));
  });

  it('chains over several rows', () => {
    const rows = Float64Array.of(1.5, -2.25, 1e-300);
    expect(hashRows(rows.subarray(1), hashRows(rows.subarray(0, 1)))).toBe(hashRows(rows));
  });

  it('changes with one bit, with the order and with the sign of zero', () => {
    const base = hashRows(Float64Array.of(1, 2));
    expect(hashRows(Float64Array.of(1 + Number.EPSILON, 2))).not.toBe(base);
    expect(hashRows(Float64Array.of(2, 1))).not.toBe(base);
    expect(hashRows(Float64Array.of(-0))).not.toBe(hashRows(Float64Array.of(0)));
  });

  it('repeats for the same trajectory, and changes for a start 1 nm away', () => {
    const hashed = (height: number) => {
      const trial = createTrial({ height, velocity: [3, 1, -12] });
      run(trial, 5);
      return hashRows(trial.ships);
    };
    expect(hashed(2)).toBe(hashed(2));
    expect(hashed(2 + 1e-9)).not.toBe(hashed(2));
  });
});
