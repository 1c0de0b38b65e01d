import fc from 'fast-check';
import { expect, it } from 'vitest';
import type { Result } from '../../../src/dynamics';
import {
  decodeClientMessage,
  decodeServerMessage,
  encodeClientMessage,
  encodeServerMessage,
  MAX_CLIENT_BYTES,
  MAX_SERVER_BYTES,
} from '../../../src/wire';
import {
  bytesOf,
  DELIMITED,
  delimited,
  double,
  frameOf,
  integer,
  olderShip,
  START_GROUP,
  tag,
  varint,
} from './bytes';
import { FRAME, HELLO, INPUTS } from '../messages';
import { faultsOf } from '../sound';

const MESSAGES = [
  ['a frame', encodeServerMessage(FRAME), decodeServerMessage],
  ['a hello', encodeServerMessage(HELLO), decodeServerMessage],
  ['inputs', encodeClientMessage(INPUTS), decodeClientMessage],
] as const;

/** Refused with a reason, or valid; an exception fails the test. For thousands of messages: `expect` takes longer than to decode one. */
function expectChecked(decoded: Result<unknown>): void {
  const faults = decoded.ok
    ? faultsOf(decoded.value)
    : /^[a-z_]+[a-z_.[\]\d]*: ./.test(decoded.reason)
      ? []
      : [decoded.reason];
  if (faults.length > 0) expect(faults).toEqual([]);
}

function reasonOf(bytes: Uint8Array): string {
  const decoded = decodeServerMessage(bytes);
  return decoded.ok ? 'accepted' : decoded.reason;
}

it('accepts the messages that the fuzzing below starts from', () => {
  for (const [, bytes, decode] of MESSAGES) expect(decode(bytes).ok).toBe(true);
});

it('never throws for any bytes', () => {
  const anything = fc.uint8Array({ maxLength: 200 });
  fc.assert(
    fc.property(anything, (bytes) => {
      expectChecked(decodeServerMessage(bytes));
      expectChecked(decodeClientMessage(bytes));
      // Behind the envelope, where the fields are.
      for (const field of [1, 2, 3])
        expectChecked(decodeServerMessage(bytesOf(delimited(field, [...bytes]))));
      expectChecked(decodeServerMessage(frameOf([...olderShip('a'), ...bytes])));
      expectChecked(decodeClientMessage(bytesOf(delimited(1, delimited(1, [...bytes])))));
    }),
    { numRuns: 500 },
  );
});

it.each(MESSAGES)('refuses every truncation of %s', (_, bytes, decode) => {
  for (let length = 0; length < bytes.length; length++) {
    const decoded = decode(bytes.subarray(0, length));
    expect(decoded.ok ? `accepted ${length} bytes` : decoded.reason).toMatch(/^message: /);
  }
});

it.each(MESSAGES)('never throws for any flipped bit of %s', (_, bytes, decode) => {
  let refused = 0;
  for (let bit = 0; bit < bytes.length * 8; bit++) {
    const flipped = Uint8Array.from(bytes);
    flipped[bit >> 3]! ^= 1 << (bit & 7);
    const decoded = decode(flipped);
    expectChecked(decoded);
    if (!decoded.ok) refused++;
  }
  expect(refused).toBeGreaterThan(bytes.length / 2);
});

it.each(MESSAGES)('never throws for %s cut up and joined again', (_, bytes, decode) => {
  const place = fc.nat(bytes.length);
  fc.assert(
    fc.property(fc.array(fc.tuple(place, place), { minLength: 1, maxLength: 6 }), (cuts) => {
      expectChecked(
        decode(bytesOf(...cuts.map(([a, b]) => [...bytes.subarray(Math.min(a, b), Math.max(a, b))]))),
      );
    }),
    { numRuns: 300 },
  );
});

it('refuses empty input', () => {
  expect(reasonOf(new Uint8Array())).toBe('message: expected a hello, a frame or a pong');
  expect(decodeClientMessage(bytesOf(delimited(9)))).toEqual({
    ok: false,
    reason: 'message: expected inputs or a ping',
  });
});

it('refuses oversized input without reading it', () => {
  const over = 'message: expected at most';
  expect(reasonOf(new Uint8Array(MAX_SERVER_BYTES + 1))).toBe(
    `${over} ${MAX_SERVER_BYTES} bytes, got ${MAX_SERVER_BYTES + 1}`,
  );
  const decoded = decodeClientMessage(new Uint8Array(MAX_CLIENT_BYTES + 1));
  expect(decoded.ok ? 'accepted' : decoded.reason).toMatch(new RegExp(`^${over} ${MAX_CLIENT_BYTES} bytes`));
});

/** `count` empty entries of list `field` in message `message` of the envelope. */
function emptyEntries(message: number, field: number, count: number): Uint8Array {
  const head = bytesOf(tag(message, DELIMITED), varint(2 * count));
  const bytes = new Uint8Array(head.length + 2 * count);
  bytes.set(head);
  // A tag, and then a length of 0.
  for (let i = head.length; i < bytes.length; i += 2) bytes.set(tag(field, DELIMITED), i);
  return bytes;
}

it('refuses millions of empty entries before it allocates any', () => {
  expect(reasonOf(emptyEntries(2, 6, 1_000_000))).toBe('frame.ships: expected at most 10000, got more');
  expect(reasonOf(emptyEntries(2, 7, 1_000_000))).toBe('frame.events: expected at most 100000, got more');
  expect(reasonOf(emptyEntries(1, 4, 1_000_000))).toBe('hello.ship_classes: expected at most 256, got more');
  const inputs = decodeClientMessage(emptyEntries(1, 1, 400_000));
  expect(inputs).toEqual({ ok: false, reason: 'inputs: expected at most 1000, got more' });
});

it('counts the entries of a list sent in several parts', () => {
  const part = [...emptyEntries(2, 5, 200)];
  expect(reasonOf(bytesOf(part, part))).toBe('frame.bodies: expected at most 256, got more');
});

it('refuses deeply nested groups', () => {
  const groups = Array.from({ length: 100_000 }, () => tag(15, START_GROUP)).flat();
  expect(reasonOf(bytesOf(groups))).toMatch(/^message: not of this protocol \(.+\)$/);
  expect(reasonOf(bytesOf(delimited(2, groups)))).toMatch(/^message: not of this protocol \(.+\)$/);
  expect(reasonOf(frameOf([...olderShip('a'), ...groups]))).toMatch(/^message: not of this protocol \(.+\)$/);
});

it('refuses text that is not UTF-8', () => {
  expect(reasonOf(frameOf([...olderShip('a'), ...delimited(3, [0xc3, 0x28])]))).toMatch(/^message: /);
  expect(reasonOf(frameOf([...olderShip('a'), ...delimited(3, [0xed, 0xa0, 0x80])]))).toMatch(
    /^(message|frame)/,
  );
});

it('treats a field of another wire type as unknown', () => {
  const wrong = [...integer(33, 5), ...integer(15, 5), ...double(29, 1)];
  expect(decodeServerMessage(frameOf([...olderShip('a'), ...wrong]))).toEqual(
    decodeServerMessage(frameOf(olderShip('a'))),
  );
  expect(reasonOf(frameOf(integer(1, 5)))).toBe('frame.ships[0].ship_id: expected a non-empty string');
});

it('takes the last of several messages in one envelope', () => {
  const pong = delimited(3, integer(1, 4), integer(2, 5), double(3, 6));
  const both = bytesOf([...encodeServerMessage(FRAME)], pong);
  expect(decodeServerMessage(both)).toEqual({
    ok: true,
    value: { kind: 'pong', id: 4, tick: 5, sinceTick: 6 },
  });
});
