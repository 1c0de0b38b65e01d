import type { ShipView } from '../prediction';
import { dot } from './axes';
import type { Surface } from './surface';

/** The design's descent data. m, m/s, s; NaN where a number is not known or has no meaning now. */
export interface Descent {
  /** Below 50 km AGL. */
  shown: boolean;
  /** VSPD: positive = descending. */
  verticalSpeed: number;
  /** HSPD: relative to the turning ground. */
  horizontalSpeed: number;
  /** TTI: NaN when ascending, on the ground, or when the thrust stops the descent before it. */
  timeToImpact: number;
  /** AGL of the feet. */
  feetHeight: number;
}

/** The design's limit of the landing HUD, m AGL. */
export const DESCENT_CEILING = 50_000;

export function createDescent(): Descent {
  return { shown: false, verticalSpeed: NaN, horizontalSpeed: NaN, timeToImpact: NaN, feetHeight: NaN };
}

export function measureDescent(out: Descent, surface: Surface, ship: ShipView): void {
  const feetHeight = feetAboveGround(ship);
  out.shown = feetHeight < DESCENT_CEILING;
  out.verticalSpeed = -surface.radialSpeed;
  out.horizontalSpeed = surface.tangentialSpeed;
  out.feetHeight = feetHeight;
  out.timeToImpact = ship.surfaceState === '' && !ship.crashed ? timeToImpact(surface, ship) : NaN;
}

/** On the ground the drawn legs stand on it, whatever depth the law has (PREDICTION, "nothing is drawn underground"). */
export function feetAboveGround(ship: ShipView): number {
  return ship.surfaceState !== '' || ship.feetHeight < 0 ? 0 : ship.feetHeight;
}

export function forgetDescent(out: Descent): void {
  out.shown = false;
  out.verticalSpeed = NaN;
  out.horizontalSpeed = NaN;
  out.timeToImpact = NaN;
  out.feetHeight = NaN;
}

/**
 * Until the law's own touch (‖r‖ = surface_r) over level ground: clearance = v t + ½ a t², a the downward acceleration of
 * gravity, less what thrust and the speed along the curved ground hold against it, all as they are now.
 */
function timeToImpact(surface: Surface, ship: ShipView): number {
  const falling = -surface.radialSpeed;
  if (!(falling > 0)) return NaN;
  if (surface.clearance <= 0) return 0;
  const u = ship.velocity;
  const rising = dot(u, surface.normal);
  const circling = (dot(u, u) - rising * rising) / surface.distance;
  const a = surface.gravity - surface.lift / surface.mass - circling;
  const discriminant = falling * falling + 2 * a * surface.clearance;
  // This form of the root stays exact as a goes through 0.
  return discriminant < 0 ? NaN : (2 * surface.clearance) / (falling + Math.sqrt(discriminant));
}
