import { describe, expect, it } from 'vitest';
import {
  normalNoise,
  createRandom,
  createLink,
  type Link,
  loadNetwork,
  NETWORK_PRESETS,
  type NetworkPreset,
} from '../../src/scenarios';

/** From an independent implementation in Python with 32-bit masks. */
const SFC32_OF_7 = [2064663467, 741845084, 1743615334];

const PRESETS = Object.keys(NETWORK_PRESETS) as NetworkPreset[];

/** Sends `count` numbered messages `apart` seconds apart; their delays. Far apart, none waits behind another. */
function delays(link: Link, count: number, apart: number): number[] {
  const found: number[] = [];
  for (let i = 0; i < count; i++) {
    link.send(Uint8Array.of(i & 255), i * apart);
    for (const { at } of link.deliver((i + 1) * apart)) found.push(at - i * apart);
  }
  return found;
}

const mean = (values: number[]) => values.reduce((sum, value) => sum + value, 0) / values.length;
const deviation = (values: number[]) => {
  const middle = mean(values);
  return Math.sqrt(mean(values.map((value) => (value - middle) ** 2)));
};

describe('random numbers', () => {
  it('are sfc32: the first numbers of a seed match the author’s algorithm', () => {
    const rng = createRandom(7);
    expect([rng(), rng(), rng()].map((value) => value * 4294967296)).toEqual(SFC32_OF_7);
  });

  it('are uniform, and normal ones have deviation 1', () => {
    const rng = createRandom(1);
    const values = Array.from({ length: 50_000 }, rng);
    expect(mean(values)).toBeCloseTo(0.5, 2);
    expect(Math.min(...values)).toBeGreaterThanOrEqual(0);
    expect(Math.max(...values)).toBeLessThan(1);
    const bells = Array.from({ length: 50_000 }, () => normalNoise(rng));
    expect(Math.abs(mean(bells))).toBeLessThan(0.02);
    expect(deviation(bells)).toBeCloseTo(1, 1);
  });
});

describe.each(PRESETS)('the %s preset', (preset) => {
  const numbers = NETWORK_PRESETS[preset];

  it('has its declared delays, jitter and stalls', () => {
    const link = createLink(numbers, 42);
    const found = delays(link, 20_000, 2);
    expect(found).toHaveLength(20_000);
    const stalled = found.filter((delay) => delay > numbers.delay + 3 * numbers.jitter + 1e-9);
    const smooth = found.filter((delay) => delay <= numbers.delay + 3 * numbers.jitter + 1e-9);
    expect(mean(smooth)).toBeCloseTo(numbers.delay, 3);
    expect(deviation(smooth)).toBeCloseTo(numbers.jitter, 3);
    expect(Math.abs(stalled.length / found.length - numbers.stallShare)).toBeLessThan(0.01);
    expect(stalled).toHaveLength(link.counters.stalled);
    if (numbers.stallShare > 0) expect(mean(stalled)).toBeCloseTo(numbers.delay + numbers.stallSeconds, 2);
  });

  it('gives the same delays for the same seed, and others for another seed', () => {
    const of = (seed: number) => delays(createLink(numbers, seed), 200, 2);
    expect(of(3)).toEqual(of(3));
    if (numbers.jitter > 0) expect(of(3)).not.toEqual(of(4));
  });
});

describe('a link', () => {
  it('loses packets in bursts of the declared length', () => {
    const numbers = { ...NETWORK_PRESETS.broken, jitter: 0, stallRun: 4, stallSeconds: 1 };
    const late = delays(createLink(numbers, 9), 40_000, 3).map((delay) => delay > 0.5);
    const runs = late.filter((stalled, i) => stalled && !late[i - 1]).length;
    expect(late.filter(Boolean).length / runs).toBeCloseTo(4, 0);
  });

  it('stalls a packet where the draw is below the probability, not where it equals it', () => {
    const shareOf = (probability: number) => probability / (1 + probability);
    // A seed whose first draw p is p / (1 + p) / (1 - p / (1 + p)) to the last bit.
    const seed = Array.from({ length: 100 }, (_, i) => i).find((i) => {
      const [drawn, share] = [createRandom(i)(), shareOf(createRandom(i)())];
      return share / (1 - share) === drawn;
    })!;
    const stallsAt = (probability: number) => {
      const numbers = { ...NETWORK_PRESETS.lan, stallShare: shareOf(probability), stallRun: 1 };
      const link = createLink(numbers, seed);
      link.send(new Uint8Array(1), 0);
      return link.counters.stalled;
    };
    const drawn = createRandom(seed)();
    expect([drawn, drawn + 1e-9].map(stallsAt)).toEqual([0, 1]);
  });

  it('keeps the order: later packets wait behind a stalled one', () => {
    const link = createLink({ ...NETWORK_PRESETS.broken, stallShare: 0.3 }, 5);
    for (let i = 0; i < 500; i++) link.send(Uint8Array.of(i & 255, i >> 8), i * 0.01);
    const arrived = link.deliver(1000);
    expect(arrived.map(({ bytes }) => bytes[0]! + 256 * bytes[1]!)).toEqual([...Array(500).keys()]);
    for (let i = 1; i < 500; i++) expect(arrived[i]!.at).toBeGreaterThanOrEqual(arrived[i - 1]!.at);
    // Head-of-line blocking: many arrive at one instant, right behind the lost one.
    const bunched = arrived.filter(({ at }, i) => i > 0 && at === arrived[i - 1]!.at).length;
    expect(bunched).toBeGreaterThan(100);
    expect(link.counters).toMatchObject({ sent: 500, lost: 0, reordered: 0, duplicated: 0 });
  });

  it('delivers nothing early, and returns when the next packet is due', () => {
    const link = createLink(NETWORK_PRESETS.satellite, 1);
    expect(link.nextAt()).toBeNull();
    link.send(Uint8Array.of(1), 10);
    const at = link.nextAt()!;
    expect(link.deliver(at - 1e-9)).toEqual([]);
    expect(link.deliver(at)).toHaveLength(1);
    expect(link.deliver(at)).toEqual([]);
  });

  it('across a reconnect delivers, loses, duplicates or reorders every message, and counts each', () => {
    const link = createLink(NETWORK_PRESETS.satellite, 11);
    let [sent, arrived] = [0, 0];
    const seen = new Map<number, number>();
    const take = (now: number) => {
      for (const { bytes } of link.deliver(now)) {
        arrived += 1;
        const id = bytes[0]! + 256 * bytes[1]!;
        seen.set(id, (seen.get(id) ?? 0) + 1);
      }
    };
    for (let round = 0; round < 50; round++) {
      const now = round * 10;
      for (let i = 0; i < 20; i++, sent++) link.send(Uint8Array.of(sent & 255, sent >> 8), now + i * 0.01);
      take(now + 0.35);
      link.drop();
      expect(link.nextAt()).toBeNull();
      take(now + 5);
      link.reconnect(now + 5);
      link.send(Uint8Array.of(sent & 255, sent >> 8), now + 5);
      sent += 1;
      take(now + 9);
    }
    const { lost, duplicated, reordered } = link.counters;
    expect(seen.size).toBe(sent - lost);
    expect(arrived).toBe(sent - lost + duplicated);
    expect(Math.max(...seen.values())).toBe(2);
    for (const count of [lost, duplicated, reordered]) expect(count).toBeGreaterThan(50);
  });

  it('loses what is sent while it is down', () => {
    const link = createLink(NETWORK_PRESETS.lan, 1);
    link.drop();
    link.send(Uint8Array.of(1), 0);
    link.reconnect(1);
    expect(link.deliver(100)).toEqual([]);
    expect(link.counters.lost).toBe(1);
  });
});

describe('network numbers', () => {
  it.each(PRESETS)('of %s are in range', (preset) => {
    expect(loadNetwork(NETWORK_PRESETS[preset])).toEqual({ ok: true, value: NETWORK_PRESETS[preset] });
  });

  it.each([
    ['delay', { delay: Number.NaN }],
    ['delay', { delay: -1 }],
    ['jitter', { jitter: 6 }],
    ['stallShare', { stallShare: 0.95 }],
    ['stallShare', { stallShare: 0.8, stallRun: 1 }],
    ['stallSeconds', { stallSeconds: '1' as unknown as number }],
    ['stallRun', { stallRun: 0.5 }],
  ])('refuse %s by name', (field, change) => {
    const loaded = loadNetwork({ ...NETWORK_PRESETS.fourG, ...change });
    expect(loaded.ok ? '' : loaded.reason).toContain(`${field}: expected`);
  });
});
