/** Tick boundaries whose wall time is kept, to compute the margins of late inputs. */
const BOUNDARIES_KEPT = 128;

/** When tick boundaries were due on the wall clock, in seconds. */
export interface Schedule {
  /** The newest boundary that has been due, and its wall time. */
  boundary: number;
  at: number;
  /** Wall time of boundary b at index b mod BOUNDARIES_KEPT; NaN where unknown. */
  readonly times: Float64Array;
}

export function createSchedule(boundary: number): Schedule {
  return { boundary, at: 0, times: new Float64Array(BOUNDARIES_KEPT).fill(Number.NaN) };
}

/** Notes that `boundary` was due at wall second `at`. */
export function passBoundary(schedule: Schedule, boundary: number, at: number): void {
  schedule.boundary = boundary;
  schedule.at = at;
  schedule.times[boundary % BOUNDARIES_KEPT] = at;
}

/** Wall seconds at which the interval of `tick` ended or will end; extrapolated at `tickRate` (Hz) where it was not kept. */
export function endOfTick({ boundary, at, times }: Schedule, tick: number, tickRate: number): number {
  const end = tick + 1;
  const kept = end <= boundary && end > boundary - BOUNDARIES_KEPT;
  const time = kept ? times[end % BOUNDARIES_KEPT]! : Number.NaN;
  return Number.isNaN(time) ? at + (end - boundary) / tickRate : time;
}
