import { loadTiming, type Settings, type Timing, timingOfTick } from '../dynamics';

/** How fast the server ticks, and what has been asked for but does not hold before the next boundary. */
export interface Tempo {
  /** Hz */
  readonly tickRate: () => number;
  readonly timeScale: () => number;
  readonly paused: () => boolean;
  readonly timing: () => Timing;
  setTickRate: (tickRate: number) => string | null;
  setTimeScale: (timeScale: number) => string | null;
  setPaused: (paused: boolean) => void;
  /** While paused: run at once, for one interval of one tick or one substep, then be as before. */
  armStep: (unit: 'substep' | 'tick') => string | null;
  /** At a boundary: what has been asked for holds. */
  settle: () => void;
}

interface Values {
  readonly tickRate: number;
  readonly timeScale: number;
  readonly paused: boolean;
}

export function createTempo(tickRate: number, timeScale: number, timing: Timing, settings: Settings): Tempo {
  let held: Values = { tickRate, timeScale, paused: false };
  let asked: Values = held;
  let heldTiming = timing;

  function ask(change: Partial<Values>): string | null {
    const next = { ...asked, ...change };
    const checked = loadTiming(next.tickRate, next.timeScale, settings);
    if (!checked.ok) return checked.reason;
    asked = next;
    return null;
  }

  function hold(values: Values): void {
    held = values;
    heldTiming = timingOfTick(values.timeScale / values.tickRate, settings.contactLongestSubstep);
  }

  return {
    tickRate: () => held.tickRate,
    timeScale: () => held.timeScale,
    paused: () => held.paused,
    timing: () => heldTiming,
    setTickRate: (tickRate) => ask({ tickRate }),
    setTimeScale: (timeScale) => ask({ timeScale }),
    setPaused: (paused) => void ask({ paused }),
    armStep(unit) {
      if (!held.paused) return 'step: the server is not paused';
      asked = { ...asked, paused: true };
      if (unit === 'tick') hold({ ...held, paused: false });
      else hold({ tickRate: 100, timeScale: Math.max(0.1, heldTiming.dt * 100), paused: false });
      return null;
    },
    settle: () => {
      if (asked !== held) hold(asked);
    },
  };
}
