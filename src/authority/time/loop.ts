import type { Authority } from '../authority';

/**
 * Schedules an authority's ticks; shared by the page's worker, tests and benchmarks. `now` is an argument.
 * All times are monotonic wall seconds.
 */
export interface Loop {
  /** When the next boundary is due. */
  nextAt: number;
  /** A frozen server neither ticks nor sends; afterwards it continues from the same boundary. */
  frozen: boolean;
  /** Boundaries postponed because the host slept. */
  slipped: number;
}

/** Most ticks run at once after a stall; later ones are postponed. A server that catches up without limit falls further behind. */
export const MAX_CATCH_UP = 5;

/** Starts a loop whose present boundary is at `now`. */
export function startLoop(authority: Authority, now: number): Loop {
  authority.startAt(now);
  return { nextAt: now + 1 / authority.tempo.tickRate(), frozen: false, slipped: 0 };
}

/**
 * Runs every tick due by `now`; `sent(at)` is called after each, to send the frames.
 * @returns the number of ticks run
 */
export function runDueTicks(
  loop: Loop,
  authority: Authority,
  now: number,
  sent: (at: number) => void,
): number {
  let passed = 0;
  skipBacklog(loop, authority, now);
  while (!loop.frozen && loop.nextAt <= now) {
    sent(runNextTick(loop, authority));
    passed += 1;
  }
  return passed;
}

/** Postpones a schedule that is too far behind, so that at most MAX_CATCH_UP ticks are due by `now`. */
export function skipBacklog(loop: Loop, authority: Authority, now: number): void {
  if (loop.frozen) return;
  const tickRate = authority.tempo.tickRate();
  const due = Math.floor((now - loop.nextAt) * tickRate) + 1;
  if (due <= MAX_CATCH_UP) return;
  loop.slipped += due - MAX_CATCH_UP;
  loop.nextAt += (due - MAX_CATCH_UP) / tickRate;
}

/** Runs the next tick; returns the wall second at which it was due. */
export function runNextTick(loop: Loop, authority: Authority): number {
  const at = loop.nextAt;
  authority.tick(at);
  loop.nextAt = at + 1 / authority.tempo.tickRate();
  return at;
}

/** Stops or resumes ticking; after a freeze the next boundary is one tick away. */
export function setFrozen(loop: Loop, authority: Authority, frozen: boolean, now: number): void {
  if (loop.frozen && !frozen) {
    authority.startAt(now);
    loop.nextAt = now + 1 / authority.tempo.tickRate();
  }
  loop.frozen = frozen;
}
