import { describe, expect, it } from 'vitest';
import { createTickRateMeter, measureTickRate } from '../../../src/prediction/time/tickRateMeter';
import { createRandom, normalNoise } from '../../../src/scenarios';

interface Sent {
  readonly tick: number;
  /** Wall s. */
  readonly at: number;
}

/** Sends of a server of `hz` ticks per second, every `every` ticks, after `last`. */
function sends(count: number, hz: number, every: number, last: Sent = { tick: 1000, at: 5 }): Sent[] {
  return Array.from({ length: count }, (_, i) => ({
    tick: last.tick + (i + 1) * every,
    at: last.at + ((i + 1) * every) / hz,
  }));
}

/** The measured rate after each arrival, in the order of one connection: none overtakes another. */
function ratesOf(sent: readonly Sent[], delay: (at: number, i: number) => number = () => 0.02) {
  const meter = createTickRateMeter();
  let last = 0;
  return sent.map(({ tick, at }, i) => {
    last = Math.max(last, at + delay(at, i));
    return measureTickRate(meter, tick, last);
  });
}

const jitter = (sigma: number, seed = 1) => {
  const random = createRandom(seed);
  return () => 0.1 + Math.max(-0.09, sigma * normalNoise(random));
};

describe('the tick rate', () => {
  it.each([
    [20, 10],
    [50, 50],
    [1, 1],
    [0.1, 1],
    [100, 1],
    [50, 5],
  ])('of %d Hz sent each %d ticks is measured from the third frame that arrives on time', (hz, every) => {
    const rates = ratesOf(sends(40, hz, every));
    expect(rates.slice(0, 2)).toEqual([null, null]);
    expect(rates.at(-1)).toBe(hz);
    const spacing = every / hz;
    if (spacing >= 0.125) expect(rates[2]).toBe(hz);
  });

  it('is the roundest one that the arrivals allow, and no rounder', () => {
    expect(ratesOf(sends(8, 20, 10), jitter(0.003)).at(-1)).toBe(20);
    expect(ratesOf(sends(60, 19.7, 10), jitter(0.003)).at(-1)).toBe(19.7);
    expect(ratesOf(sends(60, 1000 / 30, 10)).at(-1)).toBeCloseTo(1000 / 30, 1);
  });

  it.each([1, 2, 3, 4, 5, 6])(
    'is within 3 % of the real one on a line that delays by 100 ± 30 ms and stalls: seed %s',
    (seed) => {
      const noise = jitter(0.03, seed);
      const stall = createRandom(seed + 100);
      const rates = ratesOf(sends(200, 20, 2), () => noise() + (stall() < 0.1 ? 0.2 : 0));
      for (const rate of rates.slice(60)) expect(Math.abs(rate! - 20)).toBeLessThanOrEqual(0.6);
    },
  );

  it('does not count a first frame that was sent between two ticks', () => {
    const rates = ratesOf(sends(12, 1, 1), (_, i) => (i === 0 ? 0.92 : 0.02));
    expect(rates.slice(0, 3)).toEqual([null, null, null]);
    expect(rates.slice(3).every((rate) => rate === 1)).toBe(true);
  });

  it('is measured with sends missing', () => {
    const random = createRandom(5);
    const rates = ratesOf(
      sends(60, 20, 10).filter(() => random() > 0.4),
      jitter(0.003),
    );
    expect(rates.at(-1)).toBe(20);
  });

  it('does not change with a burst after a stall, nor with one that drains slowly', () => {
    const held = sends(400, 20, 2);
    for (const perMessage of [0, 0.02, 0.05])
      for (const stallAt of [8, 20]) {
        let free = 0;
        const rates = ratesOf(held, (at) => {
          const released = at > stallAt && at < stallAt + 3 ? stallAt + 3 : at;
          free = Math.max(released, free + perMessage);
          return free - at + 0.02;
        });
        expect(new Set(rates.slice(20)), `each ${perMessage} s from ${stallAt} s on`).toEqual(new Set([20]));
      }
  });

  it('does not change with a pause without a word', () => {
    const before = sends(30, 20, 10);
    const last = before.at(-1)!;
    for (const pause of [0.7, 5, 300]) {
      const after = sends(80, 20, 10, { ...last, at: last.at + pause });
      const rates = ratesOf([...before, ...after], jitter(0.003));
      expect(new Set(rates.slice(10))).toEqual(new Set([20]));
    }
  });

  it.each([
    [20, 10],
    [10, 20],
    [20, 15],
    [15, 20],
    [1, 50],
    [50, 1],
  ])('follows a change from %d to %d Hz after four sends', (from, to) => {
    const before = sends(50, from, 1);
    for (const every of [1, to]) {
      const after = sends(100, to, every, before.at(-1));
      const rates = ratesOf([...before, ...after], jitter(0.002));
      // The first send after the change ends a tick of the old rate.
      const seconds = Math.max(1, 4 * (every / to));
      const first = Math.ceil((seconds * to) / every) + 1;
      expect(rates[49]).toBe(from);
      for (const rate of rates.slice(50 + first)) expect(Math.abs(rate! / to - 1)).toBeLessThan(0.01);
      expect(rates.at(-1)).toBe(to);
    }
  });

  it('starts anew with a counter that goes back', () => {
    const rates = ratesOf([...sends(20, 20, 10), ...sends(20, 5, 5, { tick: 0, at: 20 })], jitter(0.002));
    expect(rates[19]).toBe(20);
    expect(rates.at(-1)).toBe(5);
  });

  it('is measured at the highest ticks of the wire', () => {
    expect(ratesOf(sends(12, 20, 10, { tick: 2 ** 52 - 1000, at: 5 })).at(-1)).toBe(20);
  });

  it('is never one that the game has not', () => {
    expect(ratesOf(sends(40, 400, 200)).every((rate) => rate === null)).toBe(true);
    expect(ratesOf(sends(40, 0.02, 1)).every((rate) => rate === null)).toBe(true);
  });
});
