import { loadTiming, type Settings, type Timing, timingOfTick } from '../../dynamics';

/** How fast the server ticks. Changes are requested at any time and take effect at the next boundary. */
export interface Tempo {
  /** Hz */
  readonly tickRate: () => number;
  readonly timeScale: () => number;
  readonly paused: () => boolean;
  readonly timing: () => Timing;
  setTickRate: (tickRate: number) => string | null;
  setTimeScale: (timeScale: number) => string | null;
  setPaused: (paused: boolean) => void;
  /** While paused: runs for one interval of one tick or one substep, then pauses again. */
  armStep: (unit: 'substep' | 'tick') => string | null;
  /** Called at a boundary: requested changes take effect. */
  settle: () => void;
}

interface Values {
  readonly tickRate: number;
  readonly timeScale: number;
  readonly paused: boolean;
}

export function createTempo(tickRate: number, timeScale: number, timing: Timing, settings: Settings): Tempo {
  let current: Values = { tickRate, timeScale, paused: false };
  let requested: Values = current;
  let currentTiming = timing;

  function request(change: Partial<Values>): string | null {
    const next = { ...requested, ...change };
    const checked = loadTiming(next.tickRate, next.timeScale, settings);
    if (!checked.ok) return checked.reason;
    requested = next;
    return null;
  }

  function apply(values: Values): void {
    current = values;
    currentTiming = timingOfTick(values.timeScale / values.tickRate, settings.contactLongestSubstep);
  }

  return {
    tickRate: () => current.tickRate,
    timeScale: () => current.timeScale,
    paused: () => current.paused,
    timing: () => currentTiming,
    setTickRate: (tickRate) => request({ tickRate }),
    setTimeScale: (timeScale) => request({ timeScale }),
    setPaused: (paused) => void request({ paused }),
    armStep(unit) {
      if (!current.paused) return 'step: the server is not paused';
      requested = { ...requested, paused: true };
      if (unit === 'tick') apply({ ...current, paused: false });
      else apply({ tickRate: 100, timeScale: Math.max(0.1, currentTiming.dt * 100), paused: false });
      return null;
    },
    settle: () => {
      if (requested !== current) apply(requested);
    },
  };
}
