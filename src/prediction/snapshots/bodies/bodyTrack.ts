import { BODY_STRIDE, moveBodies, settleBodies, turnBodies } from '../../../dynamics';
import { spanOf, type Timeline } from '../../time/timeline';

/**
 * The bodies at each tick boundary and in each substep (DYNAMICS, Frame): as sent by the server, then advanced by the dynamics. The
 * rows of a substep are computed once and shared by the front and all replays.
 */
export interface BodyTrack {
  readonly count: number;
  readonly length: number;
  /** Rows at tick boundaries: slot = tick mod length. */
  readonly boundaries: Float64Array[];
  readonly ticks: Float64Array;
  readonly substepRows: SubstepRows[];
  /** The bodies as long as no boundary is known. */
  readonly start: Float64Array;
  /** The predicted rows of the boundary that a frame replaced. */
  readonly replaced: Float64Array;
  /** A boundary from before the ring. */
  readonly past: Float64Array;
}

/** One tick's rows, substep by substep, each turned for its substep. */
interface SubstepRows {
  tick: number;
  made: number;
  rows: Float64Array[];
}

export const createSubstepRows = (): SubstepRows => ({ tick: -1, made: 0, rows: [] });

/** A tick of more substeps is too long to follow: its rows alone would take 16 MB with four bodies. */
export const MAX_SUBSTEPS_PER_TICK = 12_800;

/** @param start rows of the bodies at the first tick, unless a frame has others */
export function createBodyTrack(start: Float64Array, length: number, substeps: number): BodyTrack {
  const size = start.length;
  const count = size / BODY_STRIDE;
  return {
    count,
    length,
    boundaries: Array.from({ length }, () => new Float64Array(size)),
    ticks: new Float64Array(length).fill(Number.NEGATIVE_INFINITY),
    substepRows: Array.from({ length: keptTicks(substeps) }, createSubstepRows),
    start,
    replaced: new Float64Array(size),
    past: new Float64Array(size),
  };
}

/** Number of ticks whose substeps are kept: as many as a memory limit allows, at least those of a replay across a boundary. */
export function keptTicks(substeps: number): number {
  return Math.max(3, Math.min(64, Math.floor(4096 / substeps)));
}

/** The same boundaries in a ring of another length. */
export function resizedBodies(track: BodyTrack, length: number, substeps: number): BodyTrack {
  const next = createBodyTrack(track.start, length, substeps);
  for (let slot = 0; slot < track.length; slot++) {
    const tick = track.ticks[slot]!;
    if (!(tick > next.ticks[tick % length]!)) continue;
    next.boundaries[tick % length]!.set(track.boundaries[slot]!);
    next.ticks[tick % length] = tick;
  }
  next.replaced.set(track.replaced);
  return next;
}

/** Whether the boundary at `tick` is known, sent or computed. */
export function knowsBoundary(track: BodyTrack, tick: number): boolean {
  return track.ticks[tick % track.length] === tick;
}

/** Rows at tick boundary `tick`, valid until the next call; computed from the newest boundary before it. */
export function boundaryAt(track: BodyTrack, timeline: Timeline, tick: number): Float64Array {
  if (knowsBoundary(track, tick)) return track.boundaries[tick % track.length]!;
  let from = tick;
  while (!knowsBoundary(track, from) && tick - from < track.length - 1 && from > 0) {
    if (track.ticks[from % track.length]! > from) return pastAt(track, timeline, tick);
    from--;
  }
  if (!knowsBoundary(track, from)) skipTo(track, timeline, from);
  for (; from < tick; from++) makeNext(track, timeline, from);
  return track.boundaries[tick % track.length]!;
}

/** Advances the bodies from the last known boundary in one rotation and one translation: no boundary within the ring's length is known. */
function skipTo(track: BodyTrack, timeline: Timeline, tick: number): void {
  let newest = -1;
  for (const known of track.ticks) if (known > newest && known < tick) newest = known;
  const rows = track.boundaries[tick % track.length]!;
  rows.set(newest < 0 ? track.start : track.boundaries[newest % track.length]!);
  if (newest >= 0) {
    const seconds = (tick - newest) * spanOf(timeline, tick).timing.tickSeconds;
    turnBodies(rows, track.count, seconds);
    settleBodies(rows, track.count);
    moveBodies(rows, track.count, seconds);
  }
  track.ticks[tick % track.length] = tick;
}

/**
 * The ring has advanced beyond `tick`, as after an absence: the bodies are moved back from the oldest boundary after it. They are not kept:
 * their slot is a newer tick's.
 */
function pastAt(
  { ticks, boundaries, past, count }: BodyTrack,
  timeline: Timeline,
  tick: number,
): Float64Array {
  let oldest = Number.POSITIVE_INFINITY;
  for (const known of ticks) if (known > tick && known < oldest) oldest = known;
  past.set(boundaries[oldest % ticks.length]!);
  const seconds = (tick - oldest) * spanOf(timeline, tick).timing.tickSeconds;
  turnBodies(past, count, seconds);
  settleBodies(past, count);
  moveBodies(past, count, seconds);
  return past;
}

function makeNext(track: BodyTrack, timeline: Timeline, tick: number): void {
  const { timing } = spanOf(timeline, tick);
  const next = track.boundaries[(tick + 1) % track.length]!;
  next.set(rowsAt(track, timeline, tick, timing.substeps - 1));
  settleBodies(next, track.count);
  moveBodies(next, track.count, timing.tickSeconds);
  track.ticks[(tick + 1) % track.length] = tick + 1;
}

/** Rows turned for substep `substep` of the interval that begins at `tick` (DYNAMICS, step 7). */
export function rowsAt(track: BodyTrack, timeline: Timeline, tick: number, substep: number): Float64Array {
  const cached = track.substepRows[tick % track.substepRows.length]!;
  if (cached.tick === tick && substep < cached.made) return cached.rows[substep]!;
  return makeRows(track, timeline, cached, { tick, substep });
}

function makeRows(
  track: BodyTrack,
  timeline: Timeline,
  cached: SubstepRows,
  to: { tick: number; substep: number },
): Float64Array {
  const { dt, substeps } = spanOf(timeline, to.tick).timing;
  if (cached.tick !== to.tick) {
    const start = boundaryAt(track, timeline, to.tick);
    cached.tick = to.tick;
    cached.made = 0;
    while (cached.rows.length < substeps) cached.rows.push(new Float64Array(track.count * BODY_STRIDE));
    cached.rows[0]!.set(start);
  }
  for (; cached.made <= to.substep; cached.made++) {
    const rows = cached.rows[cached.made]!;
    if (cached.made > 0) {
      rows.set(cached.rows[cached.made - 1]!);
      settleBodies(rows, track.count);
    }
    turnBodies(rows, track.count, dt);
  }
  return cached.rows[to.substep]!;
}

/** Before the first frame: sets the bodies to their start at `tick`. */
export function startBodiesAt(track: BodyTrack, tick: number): void {
  track.boundaries[tick % track.length]!.set(track.start);
  track.ticks.fill(Number.NEGATIVE_INFINITY);
  track.ticks[tick % track.length] = tick;
}

/** Forgets everything after boundary `tick`, which is then computed again, e.g. at another tempo. */
export function forgetAfter(track: BodyTrack, tick: number): void {
  for (let slot = 0; slot < track.length; slot++)
    if (track.ticks[slot]! > tick) track.ticks[slot] = Number.NEGATIVE_INFINITY;
  for (const cached of track.substepRows) if (cached.tick >= tick) cached.tick = -1;
}
