/** Wall seconds that can be slowed down or sped up, by 0.1 to 4, without a jump. Page and worker have one each. */
export interface PageClock {
  readonly now: () => number;
  readonly speed: () => number;
  readonly setSpeed: (speed: number) => void;
}

/** @param wall seconds, monotonic */
export function createPageClock(wall: () => number): PageClock {
  let speed = 1;
  let since = wall();
  let passed = since;
  const now = () => passed + (wall() - since) * speed;
  return {
    now,
    speed: () => speed,
    setSpeed(next) {
      if (!(next >= 0.1 && next <= 4)) return;
      passed = now();
      since = wall();
      speed = next;
    },
  };
}
