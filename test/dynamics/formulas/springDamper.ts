/** One touch of a one-sided spring-damper on level ground, by formula: per unit of mass, SI. */
export interface Rebound {
  /** Deepest penetration, m. */
  readonly deepest: number;
  /** Upward speed at the level of first touch, m/s; 0 if it does not rebound. */
  readonly speed: number;
  /** Duration of contact, from touch to release, s. */
  readonly duration: number;
}

const RATE = 10;

/**
 * p'' = g − 100 p − 20 ζ p' from p = 0, p' = `impact`, as long as 100 p + 20 ζ p' > 0: the ground cannot pull. Then it
 * flies. ζ < 1.
 */
export function rebound(impact: number, damping: number, gravity: number): Rebound {
  const sag = gravity / (RATE * RATE);
  const decay = damping * RATE;
  const swing = RATE * Math.sqrt(1 - damping * damping);
  // p = sag + e^(−decay t) (A cos + B sin), p(0) = 0, p'(0) = impact
  const a = -sag;
  const b = (impact + decay * a) / swing;
  const depth = (t: number) =>
    sag + Math.exp(-decay * t) * (a * Math.cos(swing * t) + b * Math.sin(swing * t));
  const speed = (t: number) =>
    Math.exp(-decay * t) *
    ((swing * b - decay * a) * Math.cos(swing * t) - (swing * a + decay * b) * Math.sin(swing * t));
  const push = (t: number) => RATE * RATE * depth(t) + 2 * decay * speed(t);
  const turn = firstZero(speed, Math.PI / swing);
  const letGo = firstZero(push, (2 * Math.PI) / swing);
  const squared = speed(letGo) ** 2 - 2 * gravity * depth(letGo);
  return { deepest: depth(turn), speed: squared > 0 ? Math.sqrt(squared) : 0, duration: letGo };
}

/** The first root t in (0, `end`) of a function that begins above 0; `end` if there is none. */
function firstZero(of: (t: number) => number, end: number): number {
  const stride = end / 1000;
  let t = stride;
  while (t < end && of(t) > 0) t += stride;
  if (t >= end) return end;
  let [low, high] = [t - stride, t];
  for (let i = 0; i < 60; i++) {
    const middle = (low + high) / 2;
    if (of(middle) > 0) low = middle;
    else high = middle;
  }
  return low;
}
