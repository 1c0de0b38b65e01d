import type { LoadedSettings } from '../../dynamics';
import type { Surface } from '../surface';

/** How the ship leans, and the marks its gauge is read against. Degrees; NaN when not known. */
export interface Tilt {
  /** From the ground's own normal: 0 … 180, from atan2(|s × up|, s · up). */
  degrees: number;
  /** 1 leaning over further, −1 coming up, 0 neither. */
  trend: -1 | 0 | 1;
  /** The lowest side, a unit vector in ship axes (x, y); 0, 0 when upright. */
  leanX: number;
  leanY: number;
  /**
   * Gauge marks, NaN before the first ship: below it settles; where the ship, leaning on the way it leans, is arctan(leg_radius / h)
   * from the vertical; above it is tipped.
   */
  settle: number;
  noReturn: number;
  tipped: number;
  /** Whether it is shown as the largest number: in contact or tipped. */
  prominent: boolean;
}

/** rad/s: the law lets a ship settle below a spin of 0.01, so below that no lean counts as growing. */
const STILL = 0.01;
/** rad: below a tenth of a degree a direction is noise. */
const UPRIGHT = 0.0017;

export function createTilt(): Tilt {
  return {
    degrees: NaN,
    trend: 0,
    leanX: 0,
    leanY: 0,
    settle: NaN,
    noReturn: NaN,
    tipped: NaN,
    prominent: false,
  };
}

export function measureTilt(out: Tilt, surface: Surface, settings: LoadedSettings): void {
  out.degrees = (surface.tilt * 180) / Math.PI;
  out.trend = surface.tiltRate > STILL ? 1 : surface.tiltRate < -STILL ? -1 : 0;
  // The ground's normal points away from the side that faces down.
  const x = -surface.groundInShip[0]!;
  const y = -surface.groundInShip[1]!;
  const level = Math.sqrt(x * x + y * y);
  const leans = surface.tilt > UPRIGHT && level > 0;
  out.leanX = leans ? x / level : 0;
  out.leanY = leans ? y / level : 0;
  out.settle = settings.contactSettleTiltDeg;
  out.noReturn = toppleTilt(surface);
  out.tipped = settings.contactTippedAngleDeg;
}

/** Degrees of tilt from the ground at which the ship is its point of no return from the vertical, leaning the way it leans. */
export function toppleTilt({ tilt, lean, noReturn }: Surface): number {
  return ((tilt + noReturn - lean) * 180) / Math.PI;
}

export function forgetTilt(out: Tilt): void {
  out.degrees = NaN;
  out.trend = 0;
  out.leanX = 0;
  out.leanY = 0;
  out.prominent = false;
}
