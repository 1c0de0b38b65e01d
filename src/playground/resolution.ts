/** Frames a second below which the picture is drawn coarser, and above which finer again. */
const SLOW = 24;
const FAST = 50;
const LEVELS = [1, 0.8, 0.62, 0.5] as const;

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
  return {
    share: () => LEVELS[level]!,
    measure(now) {
      frames++;
      if (Number.isNaN(since)) since = now;
      const seconds = now - since;
      if (seconds < 1.5) return false;
      const rate = frames / seconds;
      frames = 0;
      since = now;
      // A hidden tab is not a slow machine.
      if (seconds > 4) return false;
      const before = level;
      calm = rate > FAST ? calm + 1 : 0;
      if (rate < SLOW && level < LEVELS.length - 1) level++;
      else if (calm >= 4 && level > 0) {
        level--;
        calm = 0;
      }
      return level !== before;
    },
  };
}
