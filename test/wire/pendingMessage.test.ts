import fc from 'fast-check';
import { expect, it } from 'vitest';
import { encodeServerMessage, pendingServerMessage } from '../../src/wire';
import { frame } from './arbitraries';
import { EVENT, FRAME, HELLO } from './messages';
import { bytesOf, delimited, double, integer, START_GROUP, tag, text } from './protobuf/bytes';

const eventsOf = (bytes: Uint8Array) => pendingServerMessage(bytes).events();

/** The fields of a frame with one event, by stream.proto. */
const HEAD = [integer(1, 42), double(2, 1), double(3, 1)].flat();
const LANDED = delimited(7, text(1, 'ship.landed'), text(2, 'ship-1'), integer(3, 41));
const LANDED_READ = [{ type: 'ship.landed', shipId: 'ship-1', tick: 41, substep: null }];

it('reads the events of every legal frame without the rest', () => {
  fc.assert(
    fc.property(frame, (message) => {
      expect(eventsOf(encodeServerMessage(message))).toEqual(message.events);
    }),
    { numRuns: 40 },
  );
  expect(eventsOf(encodeServerMessage(FRAME))).toEqual(FRAME.events);
  expect(eventsOf(encodeServerMessage({ ...FRAME, events: [] }))).toEqual([]);
});

it('reads events beside ships and bodies that are invalid: it does not open those', () => {
  expect(eventsOf(bytesOf(delimited(2, HEAD, delimited(6, [255]), delimited(5, [255]), LANDED)))).toEqual(
    LANDED_READ,
  );
});

it.each([null, undefined, 'text', new ArrayBuffer(2), { data: [18] }, [18, 0]])(
  'a value that is no bytes is no frame, has no events and is refused: %s',
  (value) => {
    const pending = pendingServerMessage(value as never);
    expect([pending.isFrame, pending.events()]).toEqual([false, []]);
    const decoded = pending.decode();
    expect(decoded.ok ? '' : decoded.reason).toMatch(/^message: expected bytes/);
  },
);

it.each([
  ['text', 'a string: JSON goes to decodeFrameJson'],
  [new ArrayBuffer(2), 'an ArrayBuffer: pass new Uint8Array(buffer)'],
  [new Blob(['x']), 'a Blob: set socket.binaryType to "arraybuffer"'],
  [Promise.resolve(), 'a Promise: await it first'],
  [{ data: [18] }, 'an object: bytes are in the .data of an event'],
  [new Event('message'), 'an object: bytes are in the .data of an event'],
  [[18, 0], 'Array'],
  [null, 'Null'],
])('says what %s is, and what to do', (value, help) => {
  expect(pendingServerMessage(value as never).decode()).toEqual({
    ok: false,
    reason: `message: expected bytes in a Uint8Array, got ${help}`,
  });
});

it('decodes the whole message, and distinguishes a frame from other messages', () => {
  for (const message of [FRAME, HELLO]) {
    const pending = pendingServerMessage(encodeServerMessage(message));
    expect(pending.isFrame).toBe(message === FRAME);
    expect(pending.decode()).toEqual({ ok: true, value: message });
  }
  expect(pendingServerMessage(new Uint8Array()).isFrame).toBe(false);
});

it.each([
  ['nothing', []],
  ['a hello', [...encodeServerMessage(HELLO)]],
  ['a field 7 outside a frame', delimited(7, LANDED)],
  ['a frame cut off inside its event', [...bytesOf(delimited(2, HEAD, LANDED))].slice(0, -3)],
  ['a length beyond the end', [...tag(2, 2), 200, 1, ...LANDED]],
  ['a length without an end', [...tag(2, 2), 10, ...tag(4, 2), ...Array<number>(9).fill(255)]],
  ['an event that is invalid', delimited(2, HEAD, delimited(7, text(1, 'ship.landed')))],
])('reads no events, and does not throw, from %s', (_, bytes) => {
  expect(eventsOf(bytesOf(bytes))).toEqual([]);
});

it.each([
  ['a number', integer(99, 300)],
  ['a double', double(99, 7)],
  ['bytes', delimited(99, Array<number>(300).fill(7))],
  ['32 bits', [...tag(99, 5), 1, 2, 3, 4]],
  ['a group', [...tag(99, START_GROUP), ...tag(99, 4)]],
  ['a short number', integer(12, 1)],
  ['a short tag and a long number', integer(12, 2 ** 21)],
  ['a short tag and a double', double(12, 7)],
  ['a short tag and a double of zeros', double(12, 0)],
  ['short bytes', delimited(12, [58, 58, 58])],
  ['32 bits of a low field', [...tag(12, 5), 1, 2, 3, 4]],
])('finds the events behind an unknown field: %s', (_, unknown) => {
  expect(eventsOf(bytesOf(delimited(2, HEAD, unknown, LANDED)))).toEqual(LANDED_READ);
});

it('finds an event of any length behind unknown bytes of any length', () => {
  const missed: string[] = [];
  for (const length of [0, 1, 128, 300])
    for (let letters = 1; letters < 70; letters++) {
      const landed = delimited(7, text(1, 'ship.landed'), text(2, 'a'.repeat(letters)), integer(3, 41));
      const bytes = bytesOf(delimited(2, HEAD, delimited(12, Array<number>(length).fill(0)), landed));
      if (eventsOf(bytes).length !== 1) missed.push(`${letters} letters behind ${length} bytes`);
    }
  expect(missed).toEqual([]);
});

it('takes all events', () => {
  const all = [EVENT, { ...EVENT, substep: null }, { ...EVENT, type: 'ship.landed' }];
  expect(eventsOf(encodeServerMessage({ ...FRAME, events: all }))).toEqual(all);
});
