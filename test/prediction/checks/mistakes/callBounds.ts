/** Counts and times on either side of the bound from which they are reported, as BOUNDS. */
import { NEUTRAL_CONTROLS } from '../../../../src/dynamics';
import type { Predictor } from '../../../../src/prediction';
import type { Bound } from './bounds';
import { frame, ship, ticks, warningsOf } from './given';

/** Calls of `advance` at these times, s, after a frame at `receivedAt`, if any. */
const advanced = (times: readonly number[], receivedAt?: number) =>
  warningsOf((p) => {
    if (receivedAt !== undefined) p.receive(frame, receivedAt);
    for (const now of times) p.advance(null, now);
  });
/** Times that begin at 0 and grow by each of `gaps`. */
const after = (...gaps: readonly number[]) => {
  const times = [0];
  for (const gap of gaps) times.push(times.at(-1)! + gap);
  return times;
};
const repeat = (count: number, gap: number) => Array<number>(count).fill(gap);

const GAPS: readonly Bound[] = [
  ['calls with one now', 'advance-twice', 10, 11, (n) => advanced(repeat(n, 3))],
  [
    'others between them',
    'advance-twice',
    2,
    1,
    (n) => advanced(after(...repeat(9, 0), ...repeat(n, 0.01), ...repeat(9, 0))),
  ],
  ['the gaps of milliseconds', 'now-in-milliseconds', 9, 10, (n) => advanced(after(...repeat(n, 16)))],
  ['the least', 'now-in-milliseconds', 3.99, 4, (gap) => advanced(after(...repeat(10, gap)))],
  ['the longest', 'now-in-milliseconds', 300.5, 300, (gap) => advanced(after(...repeat(10, gap)))],
  [
    'a gap of another kind',
    'now-in-milliseconds',
    1,
    16,
    (gap) => advanced(after(...repeat(5, 16), gap, ...repeat(5, 16))),
  ],
  ['the gaps of a slow loop', 'advance-seldom', 9, 10, (n) => advanced(after(...repeat(n, 1)))],
  ['the least of them', 'advance-seldom', 0.149, 0.151, (gap) => advanced(after(...repeat(10, gap)))],
  ['the longest of them', 'advance-seldom', 5, 4.99, (gap) => advanced(after(...repeat(10, gap)))],
  [
    'a gap of a quick loop',
    'advance-seldom',
    0.01,
    1,
    (gap) => advanced(after(...repeat(5, 1), gap, ...repeat(5, 1))),
  ],
  ['the time', 'now-of-calendar', 1e9, 1e9 + 1, (now) => advanced([now])],
  ['a step', 'now-went-back', 0, -0.001, (gap) => advanced(after(gap))],
  ['receive and advance', 'two-clocks', 100, 100.1, (now) => advanced([now], 0)],
  ['receive later than advance', 'two-clocks', 100, 100.1, (now) => advanced([0], now)],
  ['the same after a gap of milliseconds', 'two-clocks', 200, 200.1, (now) => advanced([60, now], 0)],
  [
    'advance and view',
    'two-clocks',
    100,
    100.1,
    (now) => warningsOf((p) => (p.advance(null, 0), p.view(now))),
  ],
  [
    'view earlier than advance',
    'two-clocks',
    100,
    100.1,
    (now) => warningsOf((p) => (p.advance(null, now), p.view(0))),
  ],
];

const viewed = (views: number, before: (p: Predictor) => void) =>
  warningsOf((p) => {
    before(p);
    for (let i = 0; i < views; i++) p.view(i / 60);
  });
const seenLast = (count: number, seen: number, own = 'a') =>
  warningsOf((p) => {
    p.setOwnShip(own);
    for (const one of ticks(count + seen))
      p.receive({ ...one, ships: one.tick > seen ? [{ ...ship, shipId: 'other' }] : [ship] }, one.tick);
  });
const steer = (p: Predictor, calls: number, from: number) => {
  for (let i = from; i < from + calls; i++)
    p.advance({ ...NEUTRAL_CONTROLS, thrustLevel: i % 2 ? 0.001 : 0 }, 0.01 + i / 500);
};

const COUNTS: readonly Bound[] = [
  ['views', 'advance-never', 9, 10, (n) => viewed(n, (p) => p.receive(frame, 0))],
  ['frames before views', 'advance-never', 0, 1, (n) => viewed(12, (p) => n && p.receive(frame, 0))],
  ['frames without the player’s ship', 'own-ship-never-seen', 9, 10, (n) => seenLast(n, 0)],
  ['frames after one with it', 'own-ship-never-seen', 1, 0, (n) => seenLast(12, n)],
  [
    'calls while inputs wait',
    'outgoing-not-taken',
    299,
    300,
    (n) =>
      warningsOf((p) => {
        p.receive(frame, 0);
        steer(p, n, 0);
      }),
  ],
  [
    'calls since they were taken',
    'outgoing-not-taken',
    299,
    300,
    (n) =>
      warningsOf((p) => {
        p.receive(frame, 0);
        steer(p, 50, 0);
        p.takeOutgoing();
        steer(p, n, 50);
      }),
  ],
];

interface Tempo {
  readonly count: number;
  /** s between frames. */
  readonly gap: number;
  readonly tickRate?: number;
  readonly timeScale?: number;
  /** Game time, s, that passes from one to the next. */
  readonly gameTime?: number;
  /** Frames of a pause, and frames that come twice. */
  readonly isPaused?: (n: number) => boolean;
}

const atTempo = ({ count, gap, tickRate = 1, timeScale = 1, gameTime, isPaused = () => false }: Tempo) =>
  warningsOf((p) => {
    for (const { tick, ...one } of ticks(count)) {
      const time = gameTime === undefined ? {} : { gameTime: 7 + tick * gameTime };
      p.receive({ ...one, ...time, tick, tickRate, timeScale, paused: isPaused(tick) }, tick * gap);
      p.advance(null, tick * gap);
    }
  });

const TEMPO: readonly Bound[] = [
  ['the period for a rate', 'tick-rate', 4.9, 5.1, (gap) => atTempo({ count: 14, gap })],
  ['late ticks', 'tick-rate', 10, 11, (count) => atTempo({ count, gap: 6 })],
  ['s of late ticks', 'tick-rate', 0.29, 0.31, (gap) => atTempo({ count: 11, gap, tickRate: 50 })],
  ['a rate for the period', 'tick-rate', 1 / 4.9, 1 / 5.1, (gap) => atTempo({ count: 30, gap })],
  ['s of early ticks', 'tick-rate', 24, 32, (count) => atTempo({ count, gap: 0.1 })],
  [
    'one on time among late ones',
    'tick-rate',
    6,
    99,
    (n) => atTempo({ count: 11, gap: 6, isPaused: (tick) => tick === n }),
  ],
  ['game time', 'game-time', 99, 101, (gameTime) => atTempo({ count: 3, gap: 1, gameTime })],
  ['less of it', 'game-time', 0.0101, 0.0099, (gameTime) => atTempo({ count: 3, gap: 1, gameTime })],
  [
    'at a tempo',
    'game-time',
    495,
    505,
    (gameTime) => atTempo({ count: 3, gap: 1, gameTime, tickRate: 2, timeScale: 10 }),
  ],
];

export const CALL_BOUNDS = [...GAPS, ...COUNTS, ...TEMPO];

/** The rate that is measured where a period, or the rate of another server, is sent, Hz. */
export const measuredRates = () =>
  [6, 0.1].map(
    (gap) => atTempo({ count: 40, gap }).find(({ code }) => code === 'tick-rate')?.details.measured,
  );
