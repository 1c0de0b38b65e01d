/** What is recorded, hashed and drawn of messages that the predictor decodes later, or never. */
import { expect, it, vi } from 'vitest';
import { createPendingTap } from '../../../../src/playground/game/live/pendingTap';
import {
  encodeServerMessage,
  pendingServerMessage,
  type ServerFrame,
  type WorldEvent,
} from '../../../../src/wire';

const event = (tick: number): WorldEvent => ({ type: 'contact', shipId: 'own', tick, substep: 1 });
const frame = (tick: number, events: readonly WorldEvent[] = []): ServerFrame => ({
  ...{ kind: 'frame', tick, tickRate: 1, timeScale: 1, paused: false, lastInput: null },
  ...{ bodies: [], ships: [], events },
});
const pendingOf = (tick: number, events: readonly WorldEvent[] = []) =>
  pendingServerMessage(encodeServerMessage(frame(tick, events)));

it('a message is taken when it is decoded', () => {
  const took = vi.fn();
  const wrapped = createPendingTap().wrap(pendingOf(3, [event(2)]), took, () => undefined);
  expect([wrapped.isFrame, took.mock.calls.length]).toEqual([true, 0]);
  expect(wrapped.decode()).toEqual({ ok: true, value: frame(3, [event(2)]) });
  expect(took.mock.calls).toEqual([[frame(3, [event(2)]), true]]);
});

it('events of superseded frames go into the next that is decoded', () => {
  const took = vi.fn();
  const passed = vi.fn();
  const tap = createPendingTap();
  for (const [tick, events] of [
    [1, [event(0), event(1)]],
    [2, []],
  ] as const)
    expect(tap.wrap(pendingOf(tick, events), took, passed).events()).toEqual(events);
  expect([passed.mock.calls.length, took.mock.calls.length]).toEqual([2, 0]);
  tap.wrap(pendingOf(3, [event(2)]), took, passed).decode();
  expect(took.mock.calls).toEqual([[frame(3, [event(0), event(1), event(2)]), false]]);
  tap.wrap(pendingOf(4), took, passed).decode();
  expect(took.mock.calls[1]).toEqual([frame(4), true]);
});

it('the newest thousand events are kept, none into another world, and a refused message is not taken', () => {
  const took = vi.fn();
  const tap = createPendingTap();
  const many = Array.from({ length: 1001 }, (_, i) => event(i));
  const pass = (events: readonly WorldEvent[]) =>
    tap.wrap(pendingOf(5000, events), took, () => undefined).events();
  const decode = () => tap.wrap(pendingOf(5001), took, () => undefined).decode();
  pass(many);
  decode();
  expect(took).toHaveBeenLastCalledWith(frame(5001, many.slice(1)), false);
  pass([event(7)]);
  tap.clear();
  decode();
  expect(took.mock.calls[1]![0]).toEqual(frame(5001));
  const refused = tap.wrap(pendingServerMessage(Uint8Array.of(0xff)), took, () => undefined);
  expect([refused.decode().ok, took.mock.calls.length]).toEqual([false, 2]);
});
