/** The gateway's reader of frames, against a Redis of this test's own making. */
import type { RedisClientType } from 'redis';
import { describe, expect, it, onTestFinished } from 'vitest';
import { createFeed, type WorldFrame } from '../../../src/gateway/redis/feed';
import { encodeFrameJson, encodeShipStateJson } from '../../../src/wire';
import { EVENT, FRAME } from '../../wire/messages';

interface Entry {
  readonly id: string;
  readonly message: Record<string, string>;
}

const FRAMES = 'touchdown:frames';

/** Streams in memory; a read that finds nothing new returns null at once, as after its wait. */
function fakeRedis() {
  const streams = new Map<string, Entry[]>();
  const asked: string[] = [];
  const entriesOf = (key: string) => streams.get(key) ?? [];
  const order = (id: string) => Number(id.split('-')[0]) * 1e6 + Number(id.split('-')[1]);
  const client = {
    async xRead({ key, id }: { key: string; id: string }, { COUNT }: { COUNT: number }) {
      asked.push(id);
      await new Promise((soon) => setTimeout(soon));
      const found = entriesOf(key).filter((entry) => order(entry.id) > order(id));
      return found.length === 0 ? null : [{ messages: found.slice(0, COUNT) }];
    },
    xRevRange: (key: string, _from: string, _to: string, { COUNT }: { COUNT: number }) =>
      Promise.resolve(entriesOf(key).toReversed().slice(0, COUNT)),
  };
  return { streams, asked, client: client as unknown as RedisClientType };
}

const eventOf = (tick: number) => ({ ...EVENT, tick });
const textOf = (tick: number, events: readonly ReturnType<typeof eventOf>[] = []) =>
  JSON.stringify({ ...encodeFrameJson({ ...FRAME, tick, events, lastInput: null }), due: tick / 10 });
const frameEntry = (id: string, tick: number, events?: readonly ReturnType<typeof eventOf>[]): Entry => ({
  id,
  message: { frame: textOf(tick, events) },
});
/** An event as the service writes it into its stream: every value is a text. */
function eventEntry(tick: number): Entry {
  const [sent] = encodeFrameJson({ ...FRAME, events: [eventOf(tick)], lastInput: null })[
    'events'
  ] as object[];
  return { id: `${tick}-0`, message: sent as Record<string, string> };
}

describe('the feed', () => {
  function follow(entries: Entry[], events: Entry[] = []) {
    const redis = fakeRedis();
    redis.streams.set(FRAMES, entries);
    redis.streams.set('touchdown:events', events);
    const told: WorldFrame[] = [];
    const refused: string[] = [];
    const logged: string[] = [];
    const feed = createFeed(redis.client, redis.client, {
      onFrame: (world) => told.push(world),
      onRefused(reason, isNew) {
        refused.push(reason);
        if (isNew) logged.push(reason);
      },
    });
    onTestFinished(feed.stop);
    const ticks = () => told.map(({ frame }) => frame.tick);
    return { ...redis, feed, told, refused, logged, ticks };
  }

  it('reports a part that stays invalid with each frame, as new only at first', async () => {
    const { feed, streams, refused, logged, ticks } = follow([]);
    const stream = streams.get(FRAMES)!;
    const frameWith = (tick: number, ships: readonly object[]): Entry => ({
      id: `1-${tick}`,
      message: { frame: JSON.stringify({ tick, ships }) },
    });
    const adrift = (fuel: number) => ({ ...encodeShipStateJson(FRAME.ships[0]!), fuel });
    void feed.run();
    const shipsOfTicks = [[adrift(-1)], [adrift(-2), { ship_id: 'b' }], [adrift(-3), null], [], [adrift(-4)]];
    for (const [tick, ships] of shipsOfTicks.entries()) stream.push(frameWith(tick, ships as object[]));
    await expect.poll(() => ticks().at(-1)).toBe(4);
    const fuel = (got: number) => `frame.ships[0].fuel: expected 0 to 2000000000000000 kg, got ${got}`;
    const [position, notShip] = [
      'frame.ships[1].position: missing',
      'frame.ships[1]: expected an object, got null',
    ];
    expect(refused).toEqual([fuel(-1), fuel(-2), position, fuel(-3), notShip, fuel(-4)]);
    expect(logged).toEqual([fuel(-1), position, notShip, fuel(-4)]);
  });

  it('starts with the newest frame, then reads on in order', async () => {
    const { feed, ticks, streams, asked } = follow([frameEntry('1-0', 1), frameEntry('1-1', 2)]);
    expect(feed.newest()).toBeNull();
    void feed.run();
    await expect.poll(ticks).toEqual([2]);
    expect(asked[0]).toBe('1-1');
    streams.get(FRAMES)!.push(frameEntry('1-2', 3), frameEntry('2-0', 4));
    await expect.poll(ticks).toEqual([2, 3, 4]);
    expect(feed.newest()).toMatchObject({ due: 0.4, frame: { tick: 4 } });
  });

  it('waits for the first frame of an empty stream', async () => {
    const { feed, ticks, streams, asked } = follow([]);
    void feed.run();
    await expect.poll(() => asked[0]).toBe('0-0');
    streams.get(FRAMES)!.push(frameEntry('5-0', 9));
    await expect.poll(ticks).toEqual([9]);
  });

  it('fetches only the events of ticks that it missed', async () => {
    const events = [4, 5, 6, 7, 8].map(eventEntry);
    const { feed, told, ticks, streams } = follow([frameEntry('1-0', 5)], events);
    void feed.run();
    await expect.poll(ticks).toEqual([5]);
    expect(told[0]!.frame.events).toEqual([]);
    streams.get(FRAMES)!.push(frameEntry('1-1', 6), frameEntry('1-2', 8, [eventOf(7), eventOf(8)]));
    await expect.poll(ticks).toEqual([5, 6, 8]);
    expect(told[1]!.frame.events).toEqual([]);
    expect(told[2]!.frame.events.map(({ tick }) => tick)).toEqual([6, 7, 8]);
    expect(told[2]!.frame.events[0]).toMatchObject({ type: 'ship.contact', shipId: 'ship-1', body: 'Moon' });
    expect((await feed.eventsSince(7, 500)).map(({ tick }) => tick)).toEqual([7, 8]);
    expect((await feed.eventsSince(0, 2)).map(({ tick }) => tick)).toEqual([7, 8]);
  });

  it.each([
    ['an earlier time', '8-9'],
    ['an earlier count of the same time', '9-2'],
  ])('reads anew from a Redis whose newest entry has %s', async (_, id) => {
    const { feed, ticks, streams } = follow([frameEntry('9-3', 5)]);
    void feed.run();
    await expect.poll(ticks).toEqual([5]);
    streams.set(FRAMES, [frameEntry(id, 3)]);
    await expect.poll(ticks).toEqual([5, 3]);
  });

  it('handles no frame twice while no new one arrives', async () => {
    const { feed, ticks, asked } = follow([frameEntry('9-3', 5)]);
    void feed.run();
    await expect.poll(() => asked.length).toBeGreaterThan(5);
    expect(ticks()).toEqual([5]);
  });

  it('reports an invalid frame and continues', async () => {
    const broken: Entry[] = [
      { id: '1-0', message: { frame: '{"tick":-1}' } },
      { id: '1-1', message: {} },
    ];
    const { feed, ticks, refused, streams } = follow([]);
    void feed.run();
    streams.get(FRAMES)!.push(...broken, frameEntry('1-2', 3));
    await expect.poll(ticks).toEqual([3]);
    expect(refused).toEqual([expect.stringMatching(/^frame\.tick: /), 'frame: not JSON']);
  });

  it('reports an error, once more after a read that succeeded, and retries until stopped', async () => {
    const { feed, ticks, refused, client } = follow([frameEntry('1-0', 5)]);
    const { xRead } = client;
    let reads = 0;
    const failing = (...given: Parameters<typeof xRead>) =>
      [0, 1, 3].includes(reads++) ? Promise.reject(new Error('gone')) : xRead(...given);
    Object.assign(client, { xRead: failing });
    const running = feed.run();
    await expect.poll(() => reads).toBeGreaterThan(4);
    expect(refused).toEqual(['redis: gone', 'redis: gone']);
    expect(ticks()).toEqual([5]);
    feed.stop();
    await running;
  });
});
