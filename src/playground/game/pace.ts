/** Runs something on where frames come too rarely: those of a slow display are seconds apart, and a hidden tab has none. */
export interface Pace {
  /** `next` runs in a moment, unless this is called again before. */
  readonly expect: (next: () => void) => void;
  readonly stop: () => void;
}

/** Wall ms: the autopilot samples as often. */
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
