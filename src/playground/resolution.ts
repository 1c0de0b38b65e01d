/** Frames a second below which the picture is drawn coarser, and above which finer again. */
const SLOW = 24;
const FAST = 50;
const LEVELS = [1, 0.8, 0.62, 0.5] as const;
/** A coarser picture that is not so many times as fast is not worth it: the machine is held up by something else. */
const WORTH = 1.15;
/** Wall seconds of a measurement, and how many of them to wait after a step that was not worth it. */
const SPAN = 1.5;
const PATIENCE = 20;
/** Measurements above FAST before a finer picture is tried. */
const CALM = 4;

/** Picks the share of device pixels that the machine keeps up with: measured over whole seconds, one step at a time. */
export interface Resolution {
  /** Called once a frame with wall seconds; true when the share has changed. */
  readonly measure: (now: number) => boolean;
  readonly share: () => number;
}

export function createResolution(): Resolution {
  let level = 0;
  let frames = 0;
  let since = NaN;
  let calm = 0;
  let patience = 0;
  /** Frames a second before the last step to a coarser picture, while it has not proved its worth. */
  let before = NaN;

  const step = (rate: number): number => {
    calm = rate > FAST ? calm + 1 : 0;
    if (patience > 0) patience--;
    if (!Number.isNaN(before)) {
      const wasWorthIt = rate > before * WORTH;
      before = NaN;
      if (!wasWorthIt) {
        patience = PATIENCE;
        return -1;
      }
    }
    if (rate < SLOW && patience === 0 && level < LEVELS.length - 1) {
      before = rate;
      return 1;
    }
    if (calm < CALM || level === 0) return 0;
    calm = 0;
    return -1;
  };

  return {
    share: () => LEVELS[level]!,
    measure(now) {
      frames++;
      if (Number.isNaN(since)) since = now;
      const seconds = now - since;
      if (seconds < SPAN) return false;
      const rate = frames / seconds;
      frames = 0;
      since = now;
      // A hidden tab is not a slow machine.
      if (seconds > 4) return false;
      const change = step(rate);
      level += change;
      return change !== 0;
    },
  };
}
