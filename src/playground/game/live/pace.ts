/** Calls a function again where frames are too rare: on a slow display they are seconds apart, and a hidden tab has none. */
export interface Pace {
  /** `next` runs in a moment, unless this is called again before. */
  readonly expect: (next: () => void) => void;
  readonly stop: () => void;
}

/** Wall ms: the autopilot's sampling interval. */
const GAP = 200;

export function createPace(): Pace {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const stop = () => clearTimeout(timer);
  return {
    expect(next) {
      stop();
      timer = setTimeout(next, GAP);
    },
    stop,
  };
}
