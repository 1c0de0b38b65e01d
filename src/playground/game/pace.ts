/** Runs something on where frames come too rarely: those of a slow display are seconds apart, and a hidden tab has none. */
export interface Pace {
  /** `next` runs after `milliseconds` of wall time, unless this is called again before. */
  readonly within: (milliseconds: number, next: () => void) => void;
  readonly stop: () => void;
}

export function createPace(): Pace {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const stop = () => clearTimeout(timer);
  return {
    within(milliseconds, next) {
      stop();
      timer = setTimeout(next, milliseconds);
    },
    stop,
  };
}
