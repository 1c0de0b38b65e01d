import { describe, expect, it } from 'vitest';
import type { RecordingEntry } from '../../src/scenarios';
import { NETWORK_PRESETS } from '../../src/scenarios';
import { input } from '../authority/moon';
import { listen, moonExchange } from './recordedSession';

function received(entries: readonly RecordingEntry[], kind: string) {
  return entries.filter((entry) => entry.kind === 'received').filter(({ message }) => message.kind === kind);
}

/** The ticks of the frames in order of arrival. */
function ticks(entries: readonly RecordingEntry[]): number[] {
  return entries.flatMap((entry) =>
    entry.kind === 'received' && entry.message.kind === 'frame' ? [entry.message.tick] : [],
  );
}

describe('loopback link', () => {
  it('starts with a hello and the present frame, then sends one frame per tick, each delayed after its boundary', () => {
    const exchange = moonExchange('opening', 'satellite');
    const client = listen(exchange);
    client.runTo(105.9);
    expect(client.entries.map((entry) => entry.kind === 'received' && entry.message.kind)).toEqual([
      'hello',
      ...Array.from({ length: 6 }, () => 'frame'),
    ]);
    expect(ticks(client.entries)).toEqual([0, 1, 2, 3, 4, 5]);
    const { delay, jitter } = NETWORK_PRESETS.satellite;
    for (const [tick, { at }] of received(client.entries, 'frame').entries())
      expect(Math.abs(at - (100 + tick) - delay)).toBeLessThanOrEqual(3 * jitter + 1e-9);
  });

  it('delivers the same bytes at the same times however coarsely it is run', () => {
    const [fine, coarse] = [
      listen(moonExchange('opening', 'broken', 4)),
      listen(moonExchange('opening', 'broken', 4)),
    ];
    for (const client of [fine, coarse]) {
      client.say({ kind: 'inputs', inputs: [input(1, 1, 40, { thrustLevel: 0.4 })] }, 100.3);
      client.say({ kind: 'ping', id: 3 }, 100.4);
    }
    for (let now = 100.001; now < 108; now += 0.001) fine.runTo(now);
    fine.runTo(108);
    for (const now of [102.5, 106, 108]) coarse.runTo(now);
    expect(coarse.entries).toEqual(fine.entries);
    expect(coarse.entries.length).toBeGreaterThan(8);
  });

  it('acknowledges an input with its true margin', () => {
    const exchange = moonExchange('opening', 'lan');
    const client = listen(exchange);
    client.say({ kind: 'inputs', inputs: [input(1, 0, 60, { thrustLevel: 0.4 })] }, 100.2);
    client.runTo(102.5);
    const frames = received(client.entries, 'frame').map(({ message }) => message);
    expect(frames[1]).toMatchObject({ tick: 1, lastInput: { seq: 1, tick: 0, substep: 60 } });
    const margin = exchange.authority.frameFor('ann')!.lastInput!.margin;
    expect(margin).toBeCloseTo(101 - 100.202, 9);
  });

  it('treats an input that arrives after the boundary as late, even when both are due in one run', () => {
    const exchange = moonExchange('opening', 'lan');
    const client = listen(exchange);
    client.say({ kind: 'inputs', inputs: [input(1, 0, 60, {})] }, 100.999);
    client.runTo(102.5);
    const { lastInput } = exchange.authority.frameFor('ann')!;
    expect(lastInput).toMatchObject({ seq: 1, tick: 1, substep: 0 });
    expect(lastInput!.margin).toBeCloseTo(-0.001, 9);
  });

  it('returns when the next event is due, and nothing happens before', () => {
    const exchange = moonExchange('opening', 'broadband');
    const client = listen(exchange);
    for (let i = 0; i < 20; i++) {
      const at = exchange.nextAt();
      const before = [client.entries.length, exchange.authority.tickNumber()];
      client.runTo(at - 1e-9);
      expect([client.entries.length, exchange.authority.tickNumber()]).toEqual(before);
      client.runTo(at);
      expect([client.entries.length, exchange.authority.tickNumber()]).not.toEqual(before);
    }
  });

  it('keeps simulating while a connection is down, and welcomes its client back', () => {
    const exchange = moonExchange('opening', 'lan');
    const client = listen(exchange);
    client.runTo(102.5);
    exchange.drop('ann');
    client.runTo(107.5);
    expect(ticks(client.entries)).toEqual([0, 1, 2]);
    exchange.reconnect('ann', 107.5);
    client.runTo(108.5);
    expect(received(client.entries, 'hello')).toHaveLength(2);
    expect(ticks(client.entries)).toEqual([0, 1, 2, 7, 8]);
  });

  it('neither ticks nor answers while frozen, and afterwards reads what arrived meanwhile', () => {
    const exchange = moonExchange('opening', 'lan');
    const client = listen(exchange);
    client.runTo(102.5);
    exchange.setFrozen(true, 102.5);
    client.say({ kind: 'ping', id: 1 }, 103);
    client.runTo(130);
    expect(exchange.nextAt()).toBe(Infinity);
    expect(ticks(client.entries)).toEqual([0, 1, 2]);
    exchange.setFrozen(false, 130);
    client.runTo(131.5);
    expect(ticks(client.entries)).toEqual([0, 1, 2, 3]);
    const [pong] = received(client.entries, 'pong');
    expect(pong!.at).toBeCloseTo(130.002, 9);
    expect(pong!.message).toMatchObject({ tick: 2, sinceTick: 0 });
  });

  it('steps one substep while paused, and sends the frame before and after it', () => {
    const exchange = moonExchange('opening', 'lan');
    const client = listen(exchange);
    expect(exchange.step('substep', 100.5)).toContain('not paused');
    exchange.authority.setPaused(true);
    client.runTo(101.5);
    expect(exchange.step('substep', 101.5)).toBeNull();
    client.runTo(101.6);
    const frames = received(client.entries, 'frame').map(({ message }) => message);
    expect(frames.slice(-2)).toMatchObject([
      { tick: 1, paused: false, tickRate: 100 },
      { tick: 2, paused: true, tickRate: 1 },
    ]);
  });

  it.each(['before', 'after'])(
    'delays each direction by its own numbers, set %s a client connects',
    (when) => {
      const exchange = moonExchange('opening', 'lan');
      const still = { ...NETWORK_PRESETS.lan, jitter: 0 };
      const setDelays = () => exchange.setNetwork({ ...still, delay: 0.1 }, { ...still, delay: 0.3 });
      if (when === 'before') {
        setDelays();
        expect(exchange.connect('ann', 'own', 100)).toBeNull();
      }
      const client = listen(exchange);
      client.runTo(100.5);
      if (when === 'after') setDelays();
      client.say({ kind: 'ping', id: 3 }, 100.5);
      client.runTo(100.95);
      const [pong] = received(client.entries, 'pong');
      expect(pong!.at).toBeCloseTo(100.9, 9);
      expect(pong!.message).toMatchObject({ sinceTick: expect.closeTo(0.8, 9) as number });
    },
  );

  it('counts and survives invalid messages', () => {
    const exchange = moonExchange('opening', 'lan');
    exchange.send('ann', Uint8Array.of(255, 255, 255), 100);
    exchange.send('ann', new Uint8Array(0), 100);
    exchange.send('nobody', Uint8Array.of(1), 100);
    exchange.run(101);
    expect(exchange.counters.refused).toBe(2);
    expect(exchange.counters.lastRefusal).not.toBe('');
    expect(exchange.authority.tickNumber()).toBe(1);
  });
});
