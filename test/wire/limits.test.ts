import { describe, expect, it } from 'vitest';
import {
  decodeClientMessage,
  decodeServerMessage,
  encodeClientMessage,
  encodeServerMessage,
  type InputRecord,
} from '../../src/wire';
import { BODY, EVENT, FRAME, HELLO, INPUT, SHIP } from './messages';

const reasonOf = (message: Parameters<typeof encodeServerMessage>[0]) => {
  const decoded = decodeServerMessage(encodeServerMessage(message));
  return decoded.ok ? '' : decoded.reason;
};
const ship = (change: object) => reasonOf({ ...FRAME, ships: [{ ...SHIP, ...change }] });
const body = (change: object) => reasonOf({ ...FRAME, bodies: [{ ...BODY, ...change }] });
const frame = (change: object) => reasonOf({ ...FRAME, ...change });
const event = (change: object) => frame({ tick: 2 ** 52, events: [{ ...EVENT, ...change }] });
const shipClass = (change: object) =>
  reasonOf({ ...HELLO, shipClasses: [{ ...HELLO.shipClasses[0]!, ...change }] });
const margin = (margin: number) => frame({ lastInput: { ...FRAME.lastInput!, margin } });
const pong = (sinceTick: number) => reasonOf({ kind: 'pong', id: 1, tick: 1, sinceTick });
const input = (change: Partial<InputRecord>) => {
  const decoded = decodeClientMessage(
    encodeClientMessage({ kind: 'inputs', inputs: [{ ...INPUT, ...change }] }),
  );
  return decoded.ok ? '' : decoded.reason;
};

/** The next number of the same digits away from zero; below it where the limit is 0. */
const beyond = (limit: number, step: number) => (limit === 0 ? step : limit * (1 + 2 ** -50));

describe('a number', () => {
  it.each<[string, (value: number) => string, number, number]>([
    ['position, m', (x) => ship({ position: [x, 0, 0] }), -1e18, 1e18],
    ['velocity, m/s', (x) => ship({ velocity: [0, x, 0] }), -1e9, 1e9],
    ['angular velocity, rad/s', (x) => ship({ angularVelocity: [0, 0, x] }), -1e6, 1e6],
    ['wheel momentum, N m s', (x) => ship({ wheelMomentum: [x, 0, 0] }), -1e25, 1e25],
    ['fuel, kg', (fuel) => ship({ fuel }), 0, 2e15],
    ['impact speed, m/s', (contactImpactSpeed) => ship({ contactImpactSpeed }), 0, 1e9],
    ['height above the feet, m', (groundContactOffset) => ship({ groundContactOffset }), 0, 1e6],
    ['game time, s', (gameTime) => frame({ gameTime }), -1e13, 1e13],
    ['margin of an input, s', margin, -1e9, 1e9],
    ['time since the tick of a pong, s', pong, -1e9, 1e9],
  ])('is accepted up to its limits and refused beyond: %s', (_, reason, low, high) => {
    expect([low, high].map(reason)).toEqual(['', '']);
    expect(reason(beyond(high, 1))).toContain(`expected ${low} to ${high}`);
    expect(reason(beyond(low, -1e-9))).toContain(`expected ${low} to ${high}`);
  });

  it('of a body’s mass or a ship class is refused beyond its limit', () => {
    expect([body({ mass: 1e40 }), body({ mass: beyond(1e40, 1) })]).toEqual([
      '',
      expect.stringContaining('mass: expected 0 to 1e+40 kg'),
    ]);
    const range = 'expected -1000000000000000 to 1000000000000000, got';
    for (const mainEngineThrust of [1.01e15, -1.01e15])
      expect(shipClass({ mainEngineThrust })).toContain(`main_engine_thrust: ${range}`);
  });

  it('that counts ticks or substeps is whole, from 0 to its limit', () => {
    const last = 2 ** 52;
    expect([frame({ tick: last, lastInput: null }), input({ tick: last }), input({ tick: 0 })]).toEqual([
      '',
      '',
      '',
    ]);
    expect(frame({ tick: last + 1 })).toContain(`tick: expected a whole number from 0 to ${last}, got`);
    expect(input({ tick: last + 1 })).toContain(`tick: expected a whole number from 0 to ${last}, got`);
    expect([input({ substep: 999_999 }), event({ substep: 999_999 })]).toEqual(['', '']);
    for (const reason of [input({ substep: 1_000_000 }), event({ substep: 1_000_000 })])
      expect(reason).toContain('substep: expected a whole number from 0 to 999999, got 1000000');
  });
});

it('neither the first event of a frame nor a later one may be ahead of it', () => {
  const ahead = { ...EVENT, tick: FRAME.tick + 1 };
  for (const [index, events] of [[ahead], [EVENT, ahead]].entries())
    expect(frame({ events })).toBe(`frame.events[${index}].tick: expected at most the frame's own, 42`);
});

it('a message of a server is refused beyond 16 MiB, one of a client beyond 1 MiB', () => {
  const reason = (decode: typeof decodeServerMessage | typeof decodeClientMessage, length: number) => {
    const decoded = decode(new Uint8Array(length));
    return decoded.ok ? '' : decoded.reason;
  };
  expect(reason(decodeServerMessage, 16 * 1024 * 1024)).not.toContain('bytes');
  expect(reason(decodeServerMessage, 16 * 1024 * 1024 + 1)).toMatch(/16777216 bytes/);
  expect(reason(decodeClientMessage, 1024 * 1024)).not.toContain('bytes');
  expect(reason(decodeClientMessage, 1024 * 1024 + 1)).toMatch(/1048576 bytes/);
});
