/** Typical mistakes of a page that uses the connection: each is named, by the constructor or by `onRefused`. */
import { describe, expect, it } from 'vitest';
import { BODIES, NEUTRAL_CONTROLS } from '../../src/dynamics';
import { createGameConnection } from '../../src/game';

const socket = () => ({ close: () => undefined, send: () => undefined, readyState: 1 });
const clock = { now: () => 0, after: () => () => undefined };
const RIGHT = { address: 'ws://127.0.0.1/ws', token: 't', clock, jitter: () => 0, openSocket: socket };
const handlers = { onFrame: () => undefined };
const connect =
  (...given: readonly unknown[]) =>
  () =>
    (createGameConnection as (...given: readonly unknown[]) => unknown)(...given);
const withOption = (changes: object) => connect({ ...RIGHT, ...changes }, handlers);
const withHandler = (changes: object) => connect(RIGHT, { ...handlers, ...changes });

const THROWN: readonly (readonly [what: string, run: () => unknown, help: RegExp])[] = [
  ['no options', connect(), /^options: expected an object, got undefined/],
  ['the address alone', connect('ws://127.0.0.1/ws', handlers), /^options: expected an object, got ws:/],
  ['no handlers', connect(RIGHT), /^handlers: expected an object with onFrame, got undefined/],
  [
    'a function for the handlers',
    connect(RIGHT, () => undefined),
    /^handlers: expected an object with onFrame/,
  ],
  ['a status text for a handler', withHandler({ onStatus: 'live' }), /^handlers\.onStatus: .*got string/],
  ['an element for a handler', withHandler({ onRefused: {} }), /^handlers\.onRefused: .*got object/],
  ['a message type for open', withOption({ open: 'state' }), /^options\.open: expected a function/],
  ['a message for pack', withOption({ pack: { type: 'control' } }), /^options\.pack: expected a function/],
  [
    'bodies by name',
    withOption({ bodies: { Luna: BODIES[0] } }),
    /^options\.bodies: expected a list of bodies/,
  ],
  ['names for bodies', withOption({ bodies: ['Luna'] }), /^options\.bodies/],
  [
    'a drawn number for jitter',
    withOption({ jitter: 0.4 }),
    /^options\.jitter: expected a function, got 0\.4/,
  ],
  ['a clock without after', withOption({ clock: { now: () => 0 } }), /^options\.clock\.after/],
  [
    'a timer that cannot be cancelled',
    withOption({ clock: { ...clock, after: () => undefined } }),
    /^options\.clock\.after: .*cancels the timer, got undefined/,
  ],
  [
    'a timer’s number',
    withOption({ clock: { ...clock, after: () => 7 } }),
    /^options\.clock\.after: .*got 7/,
  ],
  [
    'an openSocket that returns nothing',
    withOption({ openSocket: () => undefined }),
    /^options\.openSocket: .*undefined/,
  ],
];

describe('an invalid option or handler of createGameConnection is named', () => {
  it.each(THROWN)('%s', (_what, run, help) => {
    expect(run).toThrow(RangeError);
    expect(run).toThrow(help);
  });
});

const circle: Record<string, unknown> = {};
circle['self'] = circle;

it.each([
  ['nothing', undefined],
  ['a function', () => undefined],
  ['a bigint', 7n],
  ['a circle', circle],
])('%s to send is refused, not thrown', (_what, message) => {
  const reasons: string[] = [];
  const opened: { onopen: ((event: never) => void) | null; onmessage: ((event: never) => void) | null } = {
    onopen: null,
    onmessage: null,
  };
  const openSocket = () => Object.assign(opened, socket(), { onclose: null, onerror: null });
  const connection = createGameConnection(
    { ...RIGHT, openSocket },
    { ...handlers, onRefused: (reason) => reasons.push(reason) },
  );
  opened.onopen?.({} as never);
  opened.onmessage?.({ data: '{"type":"welcome","ship_id":"a"}' } as never);
  expect(connection.sendControls(NEUTRAL_CONTROLS)).toBe(true);
  expect(connection.send(message)).toBe(false);
  expect(reasons).toEqual([`message: expected a JSON value, got ${typeof message}`]);
  connection.dispose();
});
