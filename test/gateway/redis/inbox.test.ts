/** The gateway's writer of inputs, against a Redis of this test's own making. */
import type { RedisClientType } from 'redis';
import { describe, expect, it } from 'vitest';
import { NEUTRAL_CONTROLS } from '../../../src/dynamics';
import { createInbox } from '../../../src/gateway/redis/inbox';

describe('the inbox', () => {
  const INPUT = { shipId: 's1', playerId: 'p1', session: 'page', controls: NEUTRAL_CONTROLS, stamp: null };

  function writer() {
    const written: Record<string, string>[] = [];
    const redis = {
      isReady: true,
      fails: 0,
      xAdd(key: string, id: string, entry: Record<string, string>, options: unknown) {
        expect([key, id]).toEqual(['touchdown:inbox', '*']);
        expect(options).toEqual({ TRIM: { strategy: 'MAXLEN', strategyModifier: '~', threshold: 100_000 } });
        if (redis.fails-- > 0) return Promise.reject(new Error('gone'));
        written.push(entry);
        return Promise.resolve('1-0');
      },
    };
    const logged: string[] = [];
    const inbox = createInbox(redis as unknown as RedisClientType, (line) => logged.push(line));
    return { redis, inbox, seqs: () => written.map(({ seq }) => Number(seq)), written, logged };
  }

  it('writes controls in the service’s format: vectors as lists, the quaternion w first', () => {
    const { inbox, written } = writer();
    const controls = {
      ...NEUTRAL_CONTROLS,
      translationInput: [1, 2, 3],
      rotationInput: [4, 5, 6],
      targetAttitude: [0.1, 0.2, 0.3, 0.9],
    } as const;
    inbox.controls({ ...INPUT, seq: 4, controls, stamp: { tick: 7, substep: 8 } });
    const { controls: sent, ...entry } = written[0]!;
    expect(entry).toEqual({
      type: 'controls',
      ship_id: 's1',
      player_id: 'p1',
      session: 'page',
      seq: '4',
      tick: '7',
      substep: '8',
    });
    expect(JSON.parse(sent!)).toMatchObject({
      thrust_level: 0,
      translation_input: [1, 2, 3],
      rotation_input: [4, 5, 6],
      target_attitude: [0.9, 0.1, 0.2, 0.3],
    });
    inbox.controls({ ...INPUT, seq: 5 });
    expect(written[1]).not.toHaveProperty('tick');
    inbox.command('spawn', { ship_id: 's2' });
    expect(written[2]).toEqual({ type: 'spawn', data: '{"ship_id":"s2"}' });
    expect(inbox.counts()).toEqual({ waiting: 0, dropped: 0 });
  });

  it('queues entries while Redis is unavailable and sends them in order afterwards', async () => {
    const { redis, inbox, seqs } = writer();
    redis.isReady = false;
    inbox.controls({ ...INPUT, seq: 1 });
    inbox.flush();
    redis.isReady = true;
    // What waits is not overtaken.
    inbox.controls({ ...INPUT, seq: 2 });
    expect([seqs(), inbox.counts().waiting]).toEqual([[], 2]);
    inbox.flush();
    inbox.flush();
    await expect.poll(() => inbox.counts().waiting).toBe(0);
    expect(seqs()).toEqual([1, 2]);
    inbox.controls({ ...INPUT, seq: 3 });
    expect(seqs()).toEqual([1, 2, 3]);
  });

  it('resends unacknowledged entries', async () => {
    const { redis, inbox, seqs } = writer();
    redis.fails = 2;
    inbox.controls({ ...INPUT, seq: 1 });
    await expect.poll(() => inbox.counts().waiting).toBe(1);
    inbox.flush();
    await expect.poll(() => redis.fails).toBe(0);
    expect([seqs(), inbox.counts().waiting]).toEqual([[], 1]);
    await expect
      .poll(() => {
        inbox.flush();
        return seqs();
      })
      .toEqual([1]);
  });

  it('queues the newest 2,048 entries and counts the dropped ones', async () => {
    const { redis, inbox, seqs } = writer();
    redis.isReady = false;
    for (let seq = 1; seq <= 2050; seq++) inbox.controls({ ...INPUT, seq });
    expect(inbox.counts()).toEqual({ waiting: 2048, dropped: 2 });
    redis.isReady = true;
    inbox.flush();
    await expect.poll(() => inbox.counts().waiting).toBe(0);
    expect([seqs()[0], seqs().at(-1)]).toEqual([3, 2050]);
  });
});
