import { describe, expect, it } from 'vitest';
import type { Operation } from '../../../src/playground/server/operation';
import { createSession, OWN_SHIP, type Session } from '../../../src/playground/server/session';
import { NETWORK_PRESETS } from '../../../src/scenarios';
import { decodeServerMessage, type ServerFrame, type ServerMessage } from '../../../src/wire';
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

/** Runs as the worker's timer does, from one happening to the next. */
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
  it('plays a scenario to its end over the protocol', () => {
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

  it('takes the operator’s orders', () => {
    const session = loaded({ network: NETWORK_PRESETS.lan });
    const operate = (operation: Operation, now: number) => expect(session.operate(operation, now)).toBeNull();
    runTo(session, 10, 12.5);
    operate({ kind: 'tickRate', tickRate: 10 }, 12.5);
    operate({ kind: 'timeScale', timeScale: 2 }, 12.5);
    expect(frames(runTo(session, 12.5, 13.95))).toHaveLength(10);
    operate({ kind: 'pause', paused: true }, 13.95);
    const paused = frames(runTo(session, 13.95, 15));
    expect(new Set(paused.map(({ tick }) => tick)).size).toBe(1);
    expect(session.status()).toMatchObject({ paused: true, tickRate: 10, timeScale: 2 });
    operate({ kind: 'step', unit: 'substep' }, 15);
    expect(session.status()!.tick).toBe(paused[0]!.tick + 1);
    operate({ kind: 'pause', paused: false }, 15);
    runTo(session, 15, 15.25);
    operate({ kind: 'freeze', frozen: true }, 15.25);
    expect(frames(runTo(session, 15.25, 20))).toHaveLength(0);
    operate({ kind: 'freeze', frozen: false }, 20);
    operate({ kind: 'drop' }, 20);
    expect(runTo(session, 20, 22)).toHaveLength(0);
    expect(session.status()).toMatchObject({ connected: false });
    operate({ kind: 'reconnect' }, 22);
    expect(runTo(session, 22, 23).some(({ kind }) => kind === 'hello')).toBe(true);
  });

  it('restarts the own ship, and pushes it up', () => {
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

  it.each([
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
  ])('refuses %s by name and plays on', (field, operation) => {
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
    expect(session.status()).toBeNull();
  });
});
