import type { Authority } from './authority';

/**
 * When an authority's ticks are due on a wall clock that is handed in: shared by the page's worker, tests and benchmarks.
 * Wall seconds, monotonic.
 */
export interface Loop {
  /** When the next boundary is due. */
  nextAt: number;
  /** A frozen server neither ticks nor sends; it goes on where it stood. */
  frozen: boolean;
  /** Boundaries that came later than the schedule because the host slept: moved, not made up for. */
  slipped: number;
}

/** Ticks made up for at once after a stall; the schedule of the rest moves. A server that bursts on is a server that spirals. */
export const MAX_CATCH_UP = 5;

/** A loop whose present boundary is at `now`. */
export function startLoop(authority: Authority, now: number): Loop {
  authority.startAt(now);
  return { nextAt: now + 1 / authority.tempo.tickRate(), frozen: false, slipped: 0 };
}

/**
 * Advances the authority over every boundary due by `now`; `sent(at)` is called after each, for the frames.
 * @returns the number of boundaries passed
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

/** Moves a schedule that is too far behind, so that at most MAX_CATCH_UP boundaries are due by `now`. */
export function skipBacklog(loop: Loop, authority: Authority, now: number): void {
  if (loop.frozen) return;
  const tickRate = authority.tempo.tickRate();
  const due = Math.floor((now - loop.nextAt) * tickRate) + 1;
  if (due <= MAX_CATCH_UP) return;
  loop.slipped += due - MAX_CATCH_UP;
  loop.nextAt += (due - MAX_CATCH_UP) / tickRate;
}

/** Advances the authority over the next boundary; the wall second at which that was due. */
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
