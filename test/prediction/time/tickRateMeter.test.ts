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

  it('is the roundest rate that fits the arrivals', () => {
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

  it('does not change during an unannounced pause', () => {
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

  it('restarts when the tick counter goes back', () => {
    const rates = ratesOf([...sends(20, 20, 10), ...sends(20, 5, 5, { tick: 0, at: 20 })], jitter(0.002));
    expect(rates[19]).toBe(20);
    expect(rates.at(-1)).toBe(5);
  });

  it('is measured at the highest ticks of the wire', () => {
    expect(ratesOf(sends(12, 20, 10, { tick: 2 ** 52 - 1000, at: 5 })).at(-1)).toBe(20);
  });

  it('is always within the game’s range', () => {
    expect(ratesOf(sends(40, 400, 200)).every((rate) => rate === null)).toBe(true);
    expect(ratesOf(sends(40, 0.02, 1)).every((rate) => rate === null)).toBe(true);
  });
});

/** A meter after the arrivals of these ticks. */
function meterAfter(arrivals: readonly Sent[]) {
  const meter = createTickRateMeter();
  for (const { tick, at } of arrivals) measureTickRate(meter, tick, at);
  return meter;
}
const ticksKept = (arrivals: readonly Sent[]) => meterAfter(arrivals).arrivals.map(({ tick }) => tick);

describe('the stored arrivals', () => {
  it('are the newest 64', () => {
    const ticks = ticksKept(sends(70, 1, 1));
    expect(ticks).toHaveLength(64);
    expect(ticks[0]).toBe(1007);
  });

  it('are at most two in an eighth of a second', () => {
    const every = (seconds: number) => [0, 1, 2].map((k) => ({ tick: k, at: k * seconds }));
    expect(ticksKept(every(0.0625))).toEqual([0, 1, 2]);
    expect(ticksKept(every(0.0624))).toEqual([0, 2]);
  });

  it('end at an overtaken frame, and have each tick once, at its first arrival', () => {
    const sent = sends(6, 20, 10);
    const overtaken = { tick: 1045, at: sent[5]!.at + 0.2 };
    expect(ticksKept([...sent, overtaken])).toEqual([1010, 1020, 1030, 1040, 1045]);
    const twice = meterAfter([...sent, { ...sent[5]!, at: overtaken.at }]);
    expect(twice.arrivals).toEqual(sent);
  });

  it('are all kept if the newest ones give a rate outside the game’s range', () => {
    const before = sends(20, 20, 10);
    expect(ticksKept([...before, ...sends(6, 400, 200, before.at(-1))]).length).toBeGreaterThan(6);
  });
});

describe('the lateness of the newest frame', () => {
  const onTime = sends(12, 20, 10);
  const next = sends(2, 20, 10, onTime.at(-1));

  it('is measured from the least delayed arrivals', () => {
    expect(meterAfter(onTime).late).toBeCloseTo(0, 9);
    const late = { ...next[0]!, at: next[0]!.at + 0.03 };
    expect(meterAfter([...onTime, late]).late).toBeCloseTo(0.03, 9);
    expect(meterAfter([...onTime, late, next[1]!]).late).toBeCloseTo(0, 9);
  });

  it('is 0 while the arrivals are on no schedule', () => {
    expect(createTickRateMeter().late).toBe(0);
    const late = { ...next[0]!, at: next[0]!.at + 0.03 };
    const paused = sends(3, 20, 10, { ...next[1]!, at: next[1]!.at + 5 });
    const meter = meterAfter([...onTime, late, ...paused]);
    expect([meter.late, meter.rate]).toEqual([0, 20]);
  });
});

describe('three frames', () => {
  it('give no rate if one is late by more than a twentieth of their span', () => {
    const third = (late: number) => ratesOf(sends(3, 20, 3), (_, i) => (i === 1 ? late : 0))[2];
    expect(third(0.014)).toBe(20);
    expect(third(0.016)).toBe(null);
  });
});

it('a rate is kept although a rounder one also fits later, less certain arrivals', () => {
  const exact = sends(20, 10.02, 5);
  const noise = jitter(0.03);
  const rates = ratesOf([...exact, ...sends(20, 10.02, 5, exact.at(-1))], (_, i) =>
    i < 20 ? 0.02 : noise(),
  );
  expect(new Set(rates.slice(19))).toEqual(new Set([10.02]));
});

it('a new rate is adopted at its fourth frame', () => {
  const before = sends(20, 2, 1);
  const rates = ratesOf([...before, ...sends(6, 1, 1, before.at(-1))]).slice(19);
  // The first of the four is the last of the old rate.
  expect(rates).toEqual([2, 2, 2, 1, 1, 1, 1]);
});
