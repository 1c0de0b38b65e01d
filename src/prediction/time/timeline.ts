import { type Timing, timingOfTick } from '../../dynamics';

/**
 * Ticks and substeps on the server's wall clock, across changes of tempo and pauses (PREDICTION, Timeline).
 * Whole numbers for ticks and substeps; a wall time is a product of a tick count, never a sum of seconds.
 */

/** The server's tempo, sent with each frame; applies from that frame's tick on. */
export interface Tempo {
  /** Hz */
  readonly tickRate: number;
  readonly timeScale: number;
  readonly paused: boolean;
}

/** A range of ticks with one tempo; the last one is open-ended. */
export interface Span extends Tempo {
  readonly fromTick: number;
  /** Server wall s at `fromTick`; the origin is the first frame's. */
  readonly fromWall: number;
  /** Substeps from the origin to `fromTick`. */
  readonly fromIndex: number;
  readonly timing: Timing;
  /** Game s per substep, in an array of mixed types, where it is boxed once; a number field would be boxed at each call. */
  readonly step: readonly [dt: number, none: null];
}

export interface Timeline {
  readonly spans: Span[];
  /** Game s: the settings' contactLongestSubstep. */
  longestSubstep: number;
}

/** A substep boundary: the start of substep `substep` of the interval that begins at `tick`. */
export interface Position {
  tick: number;
  substep: number;
}

export const createPosition = (): Position => ({ tick: 0, substep: 0 });

/** Tempo changes kept: more than a ring of predicted states spans. */
const MAX_SPANS = 32;

export function createTimeline(longestSubstep: number): Timeline {
  return { spans: [], longestSubstep };
}

/** The span that holds `tick`; ticks before the first belong to the first. */
export function spanOf(timeline: Timeline, tick: number): Span {
  const { spans } = timeline;
  let i = spans.length - 1;
  while (i > 0 && spans[i]!.fromTick > tick) i--;
  return spans[i]!;
}

/**
 * Sets the tempo from `tick` on.
 * @param wall the server's wall time at `tick`, s, if it is known better than by counting ticks, as after a pause; otherwise null
 */
export function setTempo(timeline: Timeline, tick: number, tempo: Tempo, wall: number | null): void {
  const { spans } = timeline;
  const last = spans.at(-1);
  if (last === undefined) {
    spans.push(makeSpan(timeline, tempo, tick, wall ?? 0, 0));
    return;
  }
  const held = spanOf(timeline, tick);
  if (wall === null && held === last && isSameTempo(held, tempo)) return;
  const at = wall ?? wallOfTick(timeline, tick);
  const index = indexOf(timeline, tick, 0);
  while (spans.length > 0 && spans.at(-1)!.fromTick >= tick) spans.pop();
  spans.push(makeSpan(timeline, tempo, tick, at, index));
  if (spans.length > MAX_SPANS) spans.shift();
}

export function isSameTempo(a: Tempo, b: Tempo): boolean {
  return a.tickRate === b.tickRate && a.timeScale === b.timeScale && a.paused === b.paused;
}

/** Divides all ticks again, for another longest substep, game s: all substep counts change. */
export function changeLongestSubstep(timeline: Timeline, longestSubstep: number): void {
  timeline.longestSubstep = longestSubstep;
  const { spans } = timeline;
  for (let i = 0; i < spans.length; i++) {
    const span = spans[i]!;
    const index =
      i === 0 ? span.fromIndex : indexOf({ ...timeline, spans: [spans[i - 1]!] }, span.fromTick, 0);
    spans[i] = makeSpan(timeline, span, span.fromTick, span.fromWall, index);
  }
}

function makeSpan(
  { longestSubstep }: Timeline,
  tempo: Tempo,
  fromTick: number,
  fromWall: number,
  fromIndex: number,
): Span {
  const { tickRate, timeScale, paused } = tempo;
  const timing = timingOfTick(timeScale / tickRate, longestSubstep);
  return { tickRate, timeScale, paused, fromTick, fromWall, fromIndex, timing, step: [timing.dt, null] };
}

/** Server wall s at tick boundary `tick`; for a tick after a pause that has not ended, as if it ended now. */
export function wallOfTick(timeline: Timeline, tick: number): number {
  const span = spanOf(timeline, tick);
  return span.fromWall + (tick - span.fromTick) / span.tickRate;
}

/** Substeps from the origin to the start of substep `substep` of `tick`: positions as one number, for differences. */
export function indexOf(timeline: Timeline, tick: number, substep: number): number {
  const span = spanOf(timeline, tick);
  return span.fromIndex + (tick - span.fromTick) * span.timing.substeps + substep;
}

/** Writes the position `substeps` after (tick, substep), with the tempo of each tick on the way. */
export function addSubsteps(
  out: Position,
  timeline: Timeline,
  tick: number,
  substep: number,
  substeps: number,
): void {
  let t = tick;
  let s = substep + substeps;
  for (let n = spanOf(timeline, t).timing.substeps; s >= n; n = spanOf(timeline, t).timing.substeps) {
    s -= n;
    t += 1;
  }
  out.tick = t;
  out.substep = s;
}

/** An instant of the server's wall clock: the tick before it, and fractional substeps since that boundary. */
export interface Moment {
  tick: number;
  substeps: number;
}

/** Writes the instant at server wall time `wall`; during a pause it is the pause's tick. */
export function writeMoment(out: Moment, timeline: Timeline, wall: number): void {
  const { spans } = timeline;
  let i = spans.length - 1;
  while (i > 0 && spans[i]!.fromWall > wall) i--;
  const span = spans[i]!;
  const next = spans[i + 1];
  const ticks = span.paused ? 0 : (wall - span.fromWall) * span.tickRate;
  const whole = Math.floor(ticks);
  out.tick = span.fromTick + whole;
  out.substeps = (ticks - whole) * span.timing.substeps;
  if (next !== undefined && out.tick >= next.fromTick) {
    out.tick = next.fromTick;
    out.substeps = 0;
  }
}

/** Whether (tick, substep) is before (otherTick, otherSubstep). */
export function isBefore(tick: number, substep: number, otherTick: number, otherSubstep: number): boolean {
  return tick < otherTick || (tick === otherTick && substep < otherSubstep);
}
