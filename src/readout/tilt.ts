import type { LoadedSettings } from '../dynamics';
import type { Surface } from './surface';

/** How the ship leans, and the marks its gauge is read against. Degrees; NaN when not known. */
export interface Tilt {
  /** 0 … 180, from atan2(|n × up|, n · up). */
  degrees: number;
  /** 1 leaning over further, −1 coming up, 0 neither. */
  trend: -1 | 0 | 1;
  /** Unit, in ship axes (x, y): the side that is lowest; 0, 0 when upright. */
  leanX: number;
  leanY: number;
  /** Gauge marks, NaN before the first ship: below it settles; arctan(leg_radius / h); above it is tipped. */
  settle: number;
  noReturn: number;
  tipped: number;
  /** In contact or tipped it is the largest number. */
  prominent: boolean;
}

/** rad/s: the spin at which a ship may settle is 0.01, so below it nothing leans on. */
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
  // The side that faces down is the one local up points away from.
  const x = -surface.normalInShip[0]!;
  const y = -surface.normalInShip[1]!;
  const level = Math.sqrt(x * x + y * y);
  const leans = surface.tilt > UPRIGHT && level > 0;
  out.leanX = leans ? x / level : 0;
  out.leanY = leans ? y / level : 0;
  out.settle = settings.contactSettleTiltDeg;
  out.noReturn = (surface.noReturn * 180) / Math.PI;
  out.tipped = settings.contactTippedAngleDeg;
}

export function forgetTilt(out: Tilt): void {
  out.degrees = NaN;
  out.trend = 0;
  out.leanX = 0;
  out.leanY = 0;
  out.prominent = false;
}
