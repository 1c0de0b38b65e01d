import { describe, expect, it } from 'vitest';
import type { Operation } from '../../../src/playground/server/operation';
import { OWN_SHIP } from '../../../src/playground/server/loadedWorld';
import { createSession, type Session } from '../../../src/playground/server/session';
import { NETWORK_PRESETS } from '../../../src/scenarios';
import {
  decodeServerMessage,
  encodeClientMessage,
  type ServerFrame,
  type ServerMessage,
} from '../../../src/wire';
import { valueOf } from '../../authority/moon';

const LOAD: Operation = {
  kind: 'load',
  scenario: 'opening',
  body: '',
  shipClass: '',
  terrain: '',
  tickRate: 1,
  timeScale: 1,
  network: NETWORK_PRESETS.fourG,
  seed: 7,
  legacy: false,
  others: 0,
};

/** Runs like the worker's timer, from one event to the next. */
function runTo(session: Session, from: number, until: number): ServerMessage[] {
  const messages: ServerMessage[] = [];
  for (let now = from; now < until; now = Math.max(now, Math.min(session.nextAt(), until)))
    messages.push(...session.run(now).map(({ bytes }) => valueOf(decodeServerMessage(bytes))));
  return messages;
}

function frames(messages: readonly ServerMessage[]): ServerFrame[] {
  return messages.filter((message) => message.kind === 'frame');
}

function loaded(change: Partial<typeof LOAD> = {}): Session {
  const session = createSession();
  expect(session.operate({ ...LOAD, ...change }, 10)).toBeNull();
  return session;
}

describe('the server in the page', () => {
  it('runs a scenario to its end over the protocol', () => {
    const messages = runTo(loaded(), 10, 30);
    expect(messages[0]).toMatchObject({ kind: 'hello', shipId: OWN_SHIP });
    const events = frames(messages).flatMap(({ events }) => events.map(({ type }) => type));
    expect(events).toEqual(['ship.contact', 'ship.contact', 'ship.landed']);
    expect(frames(messages).at(-1)!.ships[0]).toMatchObject({ surfaceContactState: 'landed' });
  });

  it('is the same for the same seed, bytes and times', () => {
    const bytes = (seed: number) => {
      const session = loaded({ seed });
      return Array.from({ length: 100 }, (_, i) => session.run(10 + i / 10)).flat();
    };
    expect(bytes(3)).toEqual(bytes(3));
    expect(bytes(3)).not.toEqual(bytes(4));
  });

  it.each([
    ['body', { body: 'Earth' }, (frame: ServerFrame) => expect(frame.bodies[0]!.name).toBe('Earth')],
    [
      'class',
      { shipClass: 'cargo_hauler' },
      (frame: ServerFrame) => expect(frame.ships[0]!.shipClass).toBe('cargo_hauler'),
    ],
    ['tick rate', { tickRate: 20 }, (frame: ServerFrame) => expect(frame.tickRate).toBe(20)],
    ['others', { others: 200 }, (frame: ServerFrame) => expect(frame.ships).toHaveLength(201)],
  ])('loads another %s', (_what, change, check) => {
    check(frames(runTo(loaded(change), 10, 11))[0]!);
  });

  it('carries out the operator’s commands', () => {
    const session = loaded({ network: NETWORK_PRESETS.lan });
    const operate = (operation: Operation, now: number) => expect(session.operate(operation, now)).toBeNull();
    runTo(session, 10, 12.5);
    operate({ kind: 'tickRate', tickRate: 10 }, 12.5);
    operate({ kind: 'timeScale', timeScale: 2 }, 12.5);
    expect(frames(runTo(session, 12.5, 13.95))).toHaveLength(10);
    operate({ kind: 'pause', paused: true }, 13.95);
    const paused = frames(runTo(session, 13.95, 15));
    expect(new Set(paused.map(({ tick }) => tick)).size).toBe(1);
    expect(paused.at(-1)).toMatchObject({ paused: true, tickRate: 10, timeScale: 2 });
    operate({ kind: 'step', unit: 'substep' }, 15);
    expect(frames(runTo(session, 15, 15.15)).at(-1)!.tick).toBe(paused[0]!.tick + 1);
    operate({ kind: 'pause', paused: false }, 15.15);
    runTo(session, 15.15, 15.35);
    operate({ kind: 'freeze', frozen: true }, 15.35);
    expect(frames(runTo(session, 15.35, 20))).toHaveLength(0);
    operate({ kind: 'freeze', frozen: false }, 20);
    operate({ kind: 'drop' }, 20);
    expect(runTo(session, 20, 22)).toHaveLength(0);
    operate({ kind: 'reconnect' }, 22);
    expect(runTo(session, 22, 23).some(({ kind }) => kind === 'hello')).toBe(true);
  });

  it('restarts the player’s ship, and kicks it upward', () => {
    const session = loaded({ network: NETWORK_PRESETS.lan });
    const state = (from: number, until: number) => frames(runTo(session, from, until)).at(-1)!.ships[0]!;
    expect(state(10, 25.5).surfaceContactState).toBe('landed');
    expect(session.operate({ kind: 'kick', velocity: [0, 0, 4], spin: [0, 0, 0] }, 25.5)).toBeNull();
    expect(state(25.5, 26.5)).toMatchObject({ surfaceContactState: '' });
    expect(session.operate({ kind: 'restart' }, 26.5)).toBeNull();
    const height = Math.hypot(...state(26.5, 27.5).relativePosition!) - 1737400 - 4.56;
    // One second of the opening's fall: 12.2 m − 10.2 m − g/2.
    expect(height).toBeCloseTo(12.2 - 10.2 - 1.6233 / 2, 1);
  });

  it('restores a snapshot: the ship goes through the same states again', () => {
    const session = loaded({ network: NETWORK_PRESETS.lan });
    const own = (from: number, until: number) => frames(runTo(session, from, until)).at(-1)!.ships[0]!;
    expect(session.operate({ kind: 'restore' }, 10)).toBe('restore: take a snapshot first');
    own(10, 11.5);
    expect(session.operate({ kind: 'snapshot' }, 11.5)).toBeNull();
    const heights = (state: ReturnType<typeof own>) => Math.hypot(...state.relativePosition!);
    const first = [12.5, 13.5].map((until) => heights(own(until - 1, until)));
    own(13.5, 20.5);
    expect(session.operate({ kind: 'restore' }, 20.5)).toBeNull();
    const again = [21.5, 22.5].map((until) => heights(own(until - 1, until)));
    again.forEach((height, i) => expect(height).toBeCloseTo(first[i]!, 6));
  });

  it('moves the ship relative to where it was picked up, at rest above the ground', () => {
    const session = loaded({ network: NETWORK_PRESETS.lan, tickRate: 20 });
    const own = (from: number, until: number) => frames(runTo(session, from, until)).at(-1)!.ships[0]!;
    const before = own(10, 25).relativePosition!;
    const up = before.map((value) => (value / Math.hypot(...before)) * 30) as [number, number, number];
    expect(session.operate({ kind: 'drag', offset: [0, 0, 0], begins: true }, 25)).toBeNull();
    expect(session.operate({ kind: 'drag', offset: up, begins: false }, 25)).toBeNull();
    const after = own(25, 25.06);
    expect(Math.hypot(...after.relativePosition!) - Math.hypot(...before)).toBeCloseTo(30, 1);
    expect(after.surfaceContactState).toBe('');
  });

  it('holds all messages back in a lag spike, then delivers them in order', () => {
    const session = loaded({ network: NETWORK_PRESETS.lan, tickRate: 20 });
    runTo(session, 10, 12);
    expect(session.operate({ kind: 'spike', seconds: 1.5 }, 12)).toBeNull();
    // Messages in flight still arrive.
    expect(frames(runTo(session, 12.01, 13.4)).length).toBeLessThan(2);
    const ticks = frames(runTo(session, 13.4, 14)).map(({ tick }) => tick);
    expect(ticks.length).toBeGreaterThan(30);
    expect(ticks).toEqual([...ticks].sort((a, b) => a - b));
  });

  it('delays each direction separately', () => {
    const slow = { ...NETWORK_PRESETS.lan, delay: 0.5 };
    const answered = (change: object) => {
      const session = loaded({ network: NETWORK_PRESETS.lan, ...change });
      session.send(encodeClientMessage({ kind: 'ping', id: 5 }), 10);
      let at = 10;
      while (at < 12 && !runTo(session, at, at + 0.01).some(({ kind }) => kind === 'pong')) at += 0.01;
      return at - 10;
    };
    expect(answered({})).toBeLessThan(0.03);
    expect(answered({ upNetwork: slow })).toBeCloseTo(0.5, 1);
    expect(answered({ upNetwork: slow, network: slow })).toBeCloseTo(1, 1);
  });

  it.each([
    ['seconds', { kind: 'spike', seconds: 0 }],
    ['offset', { kind: 'drag', offset: [0, NaN, 0], begins: true }],
    ['begins', { kind: 'drag', offset: [0, 0, 0], begins: 1 }],
    ['up.jitter', { ...LOAD, upNetwork: { ...NETWORK_PRESETS.lan, jitter: -1 } }],
    ['own.plan[0]', { ...LOAD, plan: [{ tick: -1, substep: 0, controls: null }] }],
    ['kind', { kind: 'explode' }],
    ['operation', null],
    ['scenario', { ...LOAD, scenario: 'heist' }],
    ['body', { ...LOAD, body: 'Sun' }],
    ['tickRate', { ...LOAD, tickRate: 0 }],
    ['network.delay', { ...LOAD, network: { ...NETWORK_PRESETS.lan, delay: -1 } }],
    ['seed', { ...LOAD, seed: 0.5 }],
    ['others', { ...LOAD, others: 1e6 }],
    ['paused', { kind: 'pause', paused: 'yes' }],
    ['unit', { kind: 'step', unit: 'year' }],
    ['timeScale', { kind: 'timeScale', timeScale: 1e9 }],
    ['velocity', { kind: 'kick', velocity: [0, 0], spin: [0, 0, 0] }],
    ['delay', { kind: 'network', numbers: { ...NETWORK_PRESETS.lan, delay: Number.NaN } }],
  ])('refuses an invalid %s by name and goes on', (field, operation) => {
    const session = loaded();
    expect(session.operate(operation, 10.5)).toContain(field);
    expect(frames(runTo(session, 10.5, 15)).length).toBeGreaterThan(3);
  });

  it('does nothing before a world is loaded', () => {
    const session = createSession();
    expect(session.operate({ kind: 'restart' }, 0)).toBe('no world is loaded');
    session.send(Uint8Array.of(1), 0);
    expect(session.run(10)).toEqual([]);
    expect(session.nextAt()).toBe(Infinity);
    expect(session.world()).toEqual({ scenario: '', terrain: '' });
  });
});
