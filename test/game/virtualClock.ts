import type { GameClock } from '../../src/game';

/** A clock that advances only on request: 30 s of pings take no time. */
export interface VirtualClock extends GameClock {
  /** Lets `seconds` pass and runs the timers due in that time, in order. */
  readonly pass: (seconds: number) => void;
}

export function createVirtualClock(): VirtualClock {
  let now = 0;
  const timers = new Set<{ readonly at: number; readonly act: () => void }>();
  return {
    now: () => now,
    after(seconds, act) {
      const timer = { at: now + seconds, act };
      timers.add(timer);
      return () => timers.delete(timer);
    },
    pass(seconds) {
      const end = now + seconds;
      for (;;) {
        const next = [...timers].sort((a, b) => a.at - b.at)[0];
        if (next === undefined || next.at > end) break;
        timers.delete(next);
        now = Math.max(now, next.at);
        next.act();
      }
      now = end;
    },
  };
}
