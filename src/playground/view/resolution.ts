/** Frames per second below which the picture is drawn coarser, and above which finer again. */
const SLOW = 24;
const FAST = 50;
/** Wall seconds between two frames that mean that the tab was hidden. */
const HIDDEN = 4;
const LEVELS = [1, 0.8, 0.62, 0.5] as const;
/** A coarser picture must be at least this many times as fast; otherwise the picture is not the bottleneck. */
const WORTH = 1.15;
/** Frames that a measurement takes at least; the one after a change is not counted, since buffers are created in it. */
const FRAMES = 6;
/** Wall seconds of a measurement, and how many of them to wait after a step that did not help. */
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
  /** Wall seconds at which the measurement began, NaN from a change to the second frame after it. */
  let since = NaN;
  let last = NaN;
  let settling = false;
  let calm = 0;
  let patience = 0;
  /** Frames per second before the last step to a coarser picture; until it is known whether the step helped. */
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
      if (settling) {
        settling = false;
        return false;
      }
      // A hidden tab is not a slow machine.
      if (Number.isNaN(since) || now - last > HIDDEN) {
        since = now;
        frames = 0;
      } else frames++;
      last = now;
      const seconds = now - since;
      if (seconds < SPAN || frames < FRAMES) return false;
      const change = step(frames / seconds);
      level += change;
      frames = 0;
      settling = change !== 0;
      since = settling ? NaN : now;
      return settling;
    },
  };
}
