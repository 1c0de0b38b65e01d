import fc from 'fast-check';
import { expect, it } from 'vitest';
import { BODIES, SHIP_CLASSES } from '../../src/dynamics';
import {
  decodeClientMessage,
  decodeServerMessage,
  encodeClientMessage,
  encodeServerMessage,
  MAX_TICK,
  type ServerMessage,
} from '../../src/wire';
import { frame, input } from './arbitraries';
import { FRAME, HELLO, INPUTS } from './messages';

/** toEqual distinguishes 0 and −0, so equal means equal bit by bit. */
function expectBack(message: ServerMessage): void {
  expect(decodeServerMessage(encodeServerMessage(message))).toEqual({ ok: true, value: message });
}

it('preserves every legal frame bit by bit', () => {
  fc.assert(fc.property(frame, expectBack), { numRuns: 300 });
});

it('preserves every legal list of inputs bit by bit', () => {
  fc.assert(
    fc.property(fc.array(input, { maxLength: 5 }), (inputs) => {
      const message = { kind: 'inputs', inputs } as const;
      expect(decodeClientMessage(encodeClientMessage(message))).toEqual({ ok: true, value: message });
    }),
    { numRuns: 300 },
  );
});

it('preserves a hello, pings and pongs', () => {
  expectBack(HELLO);
  expectBack({ kind: 'pong', id: 3, tick: 12, sinceTick: 0.125 });
  for (const id of [0, 1, 2 ** 32, MAX_TICK]) {
    expectBack({ kind: 'pong', id, tick: id, sinceTick: -0 });
    const ping = { kind: 'ping', id } as const;
    expect(decodeClientMessage(encodeClientMessage(ping))).toEqual({ ok: true, value: ping });
  }
});

it('contains the game’s ship classes and bodies', () => {
  expectBack({ ...HELLO, shipClasses: SHIP_CLASSES, bodies: BODIES });
});

it('transfers empty frames and a frame without an acknowledgement', () => {
  expectBack({ ...FRAME, bodies: [], ships: [], events: [], lastInput: null });
  const nothing = { kind: 'inputs', inputs: [] } as const;
  expect(decodeClientMessage(encodeClientMessage(nothing))).toEqual({ ok: true, value: nothing });
});

it('returns bytes in their own buffer, so that they can be transferred', () => {
  for (const bytes of [encodeServerMessage(FRAME), encodeClientMessage(INPUTS)]) {
    expect(bytes.constructor).toBe(Uint8Array);
    expect(bytes.buffer.byteLength).toBe(bytes.byteLength);
  }
});

it('reads a message inside a larger buffer', () => {
  const bytes = encodeServerMessage(FRAME);
  const larger = new Uint8Array(bytes.length + 20).fill(0xff);
  larger.set(bytes, 7);
  expect(decodeServerMessage(larger.subarray(7, 7 + bytes.length))).toEqual({ ok: true, value: FRAME });
});
