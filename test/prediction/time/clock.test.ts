import { describe, expect, it } from 'vitest';
import {
  createClock,
  jitterOf,
  leadOf,
  sampleDown,
  samplePong,
  serverTime,
  steerByMargin,
} from '../../../src/prediction/time/clock';
import { boundBothSides, createOffsetBounds } from '../../../src/prediction/time/offsetBounds';
import { advanceClock } from '../../../src/prediction/time/present';
import { createRandom } from '../../../src/scenarios';

const SUBSTEP = 0.01;
const PACING = { deadZone: SUBSTEP, latest: Number.POSITIVE_INFINITY };

/** Pings every 0.2 s over a link, the server's clock `offset` s behind the client's. */
function run(
  seconds: number,
  link: { up: () => number; down: () => number; offset?: (now: number) => number },
  clock = createClock(),
  from = 0,
) {
  const presents: number[] = [];
  for (let i = 0; i < seconds * 60; i++) {
    const now = from + i / 60;
    const offset = link.offset?.(now) ?? 100;
    if (i % 12 === 0) {
      const [up, down] = [link.up(), link.down()];
      samplePong(clock, now - up - down, { at: now - down - offset, hasStopped: false }, now);
    }
    advanceClock(clock, now, PACING);
    presents.push(clock.present);
  }
  return { clock, presents, now: from + seconds };
}

describe('the clock', () => {
  it('estimates server time to half the path asymmetry, and the lead compensates for that half', () => {
    const { clock, now } = run(6, { up: () => 0.08, down: () => 0.02 });
    expect(serverTime(clock, now)).toBeCloseTo(now - 100 + 0.03, 9);
    // An input stamped with the present arrives 0.08 s after it left, in time by the slack.
    expect(serverTime(clock, now) + leadOf(clock)).toBeCloseTo(now - 100 + 0.08 + 0.01, 9);
  });

  it('follows the smallest delays, not stalls', () => {
    const rng = createRandom(3);
    const delay = () => 0.04 + 0.02 * rng() + (rng() < 0.1 ? 0.2 : 0);
    const { clock, now } = run(20, { up: delay, down: delay });
    expect(Math.abs(serverTime(clock, now) - (now - 100))).toBeLessThan(0.004);
  });

  it('does not count pings that stalled both ways as jitter', () => {
    let pings = 0;
    // Three of ten: 0.35 s longer in all, of which 0.2 s upstream are too few for a stall by themselves.
    const stalls = () => pings % 10 < 3;
    const up = () => {
      pings += 1;
      return stalls() ? 0.25 : 0.05;
    };
    const { clock } = run(20, { up, down: () => (stalls() ? 0.2 : 0.05) });
    expect(jitterOf(clock)).toBeLessThan(1e-9);
  });

  it('counts the pongs that waited in one queue as one delay', () => {
    const { clock, now } = run(6, { up: () => 0.05, down: () => 0.05 });
    const before = leadOf(clock);
    // More than the delays kept, sent over 12 s and received at once.
    for (let i = 60; i > 0; i--) {
      const pinged = now - 0.1 - i * 0.2;
      samplePong(clock, pinged, { at: pinged + 0.05 - 100, hasStopped: false }, now);
    }
    expect(leadOf(clock)).toBeCloseTo(before, 9);
  });

  it('drops a lower bound that an arrival contradicts: the schedule moved ahead', () => {
    const { clock, now } = run(6, { up: () => 0.05, down: () => 0.05 });
    sampleDown(clock, now - 0.05 - 99, now);
    expect(serverTime(clock, now)).toBeCloseTo(now - 99, 9);
  });

  it('ignores a pong that arrives before its ping was sent: `now` was put back', () => {
    const { clock, now } = run(6, { up: () => 0.05, down: () => 0.05 });
    const before = structuredClone(clock);
    samplePong(clock, now, { at: now - 100, hasStopped: false }, now - 5);
    expect(clock).toEqual(before);
  });

  it('slews by at most a tenth, and ignores an error below one substep', () => {
    let late = 0;
    const link = { up: () => 0.05 + late, down: () => 0.05 };
    const first = run(6, link);
    // Pings now take longer upstream, by more than the lead includes: the lead grows, the offset stays.
    late = 0.2;
    const second = run(20, link, first.clock, first.now);
    const rates = second.presents.slice(1).map((present, i) => (present - second.presents[i]!) * 60);
    expect(Math.max(...rates)).toBeLessThanOrEqual(1.1 + 1e-9);
    expect(Math.max(...rates)).toBeGreaterThan(1.05);
    expect(Math.min(...rates)).toBeGreaterThanOrEqual(0.9 - 1e-9);
    expect(second.clock.rate).toBe(1);
    const settled = second.clock.present;
    const third = run(3, link, second.clock, second.now);
    expect(Math.abs(third.clock.present - settled - 3)).toBeLessThan(SUBSTEP);
  });

  it('corrects a shifted schedule at the first pong, forward at once, back by waiting', () => {
    let shift = 0;
    const link = { up: () => 0.05, down: () => 0.05, offset: () => 100 + shift };
    const first = run(6, link);
    shift = -0.6;
    const ahead = run(1, link, first.clock, first.now);
    expect(Math.abs(ahead.clock.present - (ahead.now - 1 / 60 - 100 + 0.6 + 0.06))).toBeLessThan(0.02);
    shift = -0.1;
    const back = run(1, link, ahead.clock, ahead.now);
    expect(Math.abs(back.clock.present - (back.now - 1 / 60 - 100 + 0.1 + 0.06))).toBeLessThan(0.02);
    const drawn = [...ahead.presents.slice(-1), ...back.presents];
    for (const [i, present] of drawn.slice(1).entries()) expect(present).toBeGreaterThanOrEqual(drawn[i]!);
    shift = -10;
    const far = run(1, link, back.clock, back.now);
    expect(Math.abs(far.clock.present - (far.now - 1 / 60 - 90 + 0.06))).toBeLessThan(0.02);
  });

  it('raises the lead at the second late input, not at the first, not for a stall, and once per round trip', () => {
    const { clock, now } = run(6, { up: () => 0.05, down: () => 0.05 });
    const before = leadOf(clock);
    steerByMargin(clock, -0.03, 0, now);
    expect(leadOf(clock)).toBe(before);
    steerByMargin(clock, -3, 0, now + 1);
    expect(leadOf(clock)).toBe(before);
    steerByMargin(clock, -0.03, 0, now + 2);
    expect(leadOf(clock) - before).toBeCloseTo(0.035, 9);
    steerByMargin(clock, -0.03, 0, now + 3);
    expect(leadOf(clock) - before).toBeCloseTo(0.035, 9);
    steerByMargin(clock, 0.2, clock.steer, now + 4);
    expect(leadOf(clock) - before).toBeCloseTo(0.035, 9);
  });

  it('does not count one or two resent packets as jitter', () => {
    let pings = 0;
    const rng = createRandom(5);
    // 3 of 40 wait for 0.2 s, which is more than one in twenty.
    const up = () => 0.05 + 0.01 * rng() + (pings++ % 13 === 12 ? 0.2 : 0);
    const { clock } = run(8, { up, down: () => 0.05 });
    expect(jitterOf(clock)).toBeLessThan(0.025);
  });

  it('keeps valid bounds when pongs queue while the clocks drift', () => {
    const bounds = createOffsetBounds();
    const offset = (now: number) => 100 - 5e-4 * now;
    // Nothing arrives for a minute; then all answers arrive at once.
    for (let pinged = 0; pinged < 60; pinged += 0.2)
      boundBothSides(bounds, { pinged, answered: pinged + 0.002 - offset(pinged), now: 60 }, 0);
    expect(bounds.lower).toBeLessThanOrEqual(offset(60));
    expect(bounds.lower).toBeGreaterThan(offset(60) - 0.01);
    expect(bounds.upper).toBeGreaterThanOrEqual(offset(60));
  });

  it('stays at a paused server’s time until the server is known to run again', () => {
    const { clock, now } = run(6, { up: () => 0.3, down: () => 0.3 });
    const stood = now - 100;
    for (let i = 0; i < 300; i++) {
      const at = now + 2 + i / 60;
      if (i % 12 === 0) samplePong(clock, at - 0.6, { at: stood, hasStopped: true }, at);
      advanceClock(clock, at, PACING);
    }
    expect(Math.abs(clock.present - (stood + leadOf(clock)))).toBeLessThan(2 * SUBSTEP);
    // It resumes, and its next tick arrives 0.3 s later.
    sampleDown(clock, stood, now + 7.1);
    advanceClock(clock, now + 7.1, PACING);
    expect(clock.present - (stood + leadOf(clock))).toBeGreaterThanOrEqual(0.3);
    expect(clock.present - (stood + leadOf(clock))).toBeLessThan(0.5);
  });

  it('uses half an assumed round trip when no pong ever comes', () => {
    const clock = createClock();
    for (let tick = 0; tick < 8; tick++) sampleDown(clock, tick, tick + 100.03);
    expect(serverTime(clock, 108)).toBeCloseTo(8 - 0.03 + 0.05, 9);
  });
});
