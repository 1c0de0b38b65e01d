import { describe, expect, it } from 'vitest';
import { createPredictor, type Connection } from '../../../src/prediction';
import { OWN } from '../faults/feed';
import { frameAt } from '../faults/restingShip';
import { withoutTickRate } from '../literalServer/literalRig';

const DELAY = 0.02;

/** A server that answers no pings and pauses without a word: its drawn instants and connection, per display frame. */
function fly(
  hz: number,
  every: number,
  pause: number,
  { before = 12, queued = false, sendsRate = true } = {},
) {
  const predictor = createPredictor(OWN);
  const interval = every / hz;
  const stopped = before * interval;
  // A pause holds the server's time, a stall only its messages.
  const sends = Array.from({ length: before * 2 + Math.ceil(6 / interval) }, (_, i) => {
    const sent = i * interval + (i > before && !queued ? pause : 0);
    const held = queued && i > before ? Math.max(sent, stopped + pause) : sent;
    return { tick: i * every, at: held + DELAY };
  });
  const shown: { now: number; instant: number; connection: Connection; newest: number }[] = [];
  let newest = 0;
  const until = sends.at(-1)!.at;
  for (let frame = 0; frame / 60 < until; frame++) {
    const now = frame / 60;
    while (sends.length > 0 && sends[0]!.at <= now) {
      const { tick } = sends.shift()!;
      const frame = frameAt(tick, hz);
      predictor.receive(sendsRate ? frame : withoutTickRate(frame), now);
      newest = tick / hz;
    }
    predictor.advance(null, now);
    const { tick, sinceTick, connection, ready } = predictor.view(now);
    if (ready) shown.push({ now, instant: tick / hz + sinceTick, connection, newest });
  }
  return { shown, resumed: stopped + interval + pause, stopped, interval };
}

describe('a server that pauses without saying so', () => {
  it.each([
    [1, 1, 4],
    [1, 1, 30],
    [20, 10, 5],
    [20, 2, 5],
    [50, 1, 12],
  ])(
    'of %d Hz, sent each %d ticks, for %d s, is silent; the picture waits and goes on',
    (hz, every, pause) => {
      const { shown, resumed, stopped, interval } = fly(hz, every, pause);
      const silent = shown.filter(({ now }) => now > stopped + 2 * interval + 0.5 && now < resumed);
      expect(new Set(silent.map(({ connection }) => connection))).toEqual(new Set(['silent']));
      for (const { instant, newest } of silent)
        expect(instant - newest).toBeLessThan(interval + 0.75 + 2 * DELAY + 0.1);
      let last = Number.NaN;
      for (const { now, instant } of shown.filter(({ now }) => now > stopped)) {
        if (!Number.isNaN(last)) {
          expect(instant, `at ${now} s`).toBeGreaterThanOrEqual(last - 1e-9);
          expect(instant - last, `at ${now} s`).toBeLessThan(0.025);
        }
        last = instant;
      }
      const after = shown.filter(({ now }) => now > resumed + interval + 1);
      expect(after.length).toBeGreaterThan(60);
      for (const { now, instant } of after) expect(Math.abs(instant - (now - pause))).toBeLessThan(0.1);
      expect(after.at(-1)!.connection).toBe('live');
    },
  );

  it('does not change the tick rate that was measured before', () => {
    const { shown, resumed } = fly(20, 10, 7, { sendsRate: false });
    const after = shown.filter(({ now }) => now > resumed + 2);
    for (const { now, instant } of after) expect(Math.abs(instant - (now - 7))).toBeLessThan(0.1);
  });

  it.each([3, 8])('is at the right instant when a link stalls for %d s instead', (pause) => {
    const { shown, stopped, interval } = fly(20, 4, pause, { before: 60, queued: true });
    const after = shown.filter(({ now }) => now > stopped + pause + interval + 0.1);
    expect(after.length).toBeGreaterThan(60);
    for (const { now, instant } of after) expect(Math.abs(instant - now)).toBeLessThan(0.1);
  });
});
