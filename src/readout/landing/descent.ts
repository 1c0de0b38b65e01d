import type { ShipView } from '../../prediction';
import { writeDot } from '../axes';
import type { Surface } from '../surface';

/** The design's descent data. m, m/s, s; NaN where a number is not known or has no meaning now. */
export interface Descent {
  /** Below 50 km AGL. */
  shown: boolean;
  /** VSPD: positive = descending. */
  verticalSpeed: number;
  /** HSPD: relative to the turning ground. */
  horizontalSpeed: number;
  /** TTI: NaN when ascending, on the ground, over unknown ground, or when the thrust stops the descent before it. */
  timeToImpact: number;
  /** AGL of the feet; NaN over unknown ground. */
  feetHeight: number;
}

/** Height of the feet, m, below which the design shows the descent data. */
const DESCENT_CEILING = 50_000;

export function createDescent(): Descent {
  return { shown: false, verticalSpeed: NaN, horizontalSpeed: NaN, timeToImpact: NaN, feetHeight: NaN };
}

export function measureDescent(out: Descent, surface: Surface, ship: ShipView): void {
  out.shown = !(ship.feetHeight >= DESCENT_CEILING);
  if (ship.shownState === 'crashed') {
    // A wreck does not move; the touchdown has the speeds of the impact.
    forgetDescent(out);
    return;
  }
  out.verticalSpeed = -surface.radialSpeed;
  out.horizontalSpeed = surface.tangentialSpeed;
  out.feetHeight = standsOnGround(ship) ? 0 : ship.feetHeight;
  out.timeToImpact = NaN;
  if (isGroundKnown(ship)) measureTimeToImpact(out, surface, ship);
  else if (ship.surfaceContactState === '') out.feetHeight = NaN;
}

/** Whether the ground under the ship is known; where its terrain is not loaded, no height above it is. */
export function isGroundKnown(ship: ShipView): boolean {
  return ship.extrapolated !== 'ground';
}

/** On the ground the drawn feet are on its surface, whatever the penetration (PREDICTION, "nothing is drawn underground"). */
export function standsOnGround(ship: ShipView): boolean {
  return ship.surfaceContactState !== '' || ship.feetHeight < 0;
}

export function forgetDescent(out: Descent): void {
  out.shown = false;
  out.verticalSpeed = NaN;
  out.horizontalSpeed = NaN;
  out.timeToImpact = NaN;
  out.feetHeight = NaN;
}

/**
 * Time until the law's contact (‖r‖ = surface_r) over level ground: clearance = v t + ½ a t², a the downward acceleration of
 * gravity, less thrust and the centrifugal effect of the speed along the curved ground, at their present values.
 */
function measureTimeToImpact(out: Descent, surface: Surface, ship: ShipView): void {
  const falling = -surface.radialSpeed;
  if (ship.surfaceContactState !== '' || ship.crashed || !(falling > 0)) return;
  if (surface.clearance <= 0) {
    out.timeToImpact = 0;
    return;
  }
  writeDot(product, 0, ship.velocity, surface.normal);
  writeDot(product, 1, ship.velocity, ship.velocity);
  const circling = (product[1]! - product[0]! * product[0]!) / surface.distance;
  const a = surface.gravity - surface.lift / surface.mass - circling;
  const discriminant = falling * falling + 2 * a * surface.clearance;
  // This form of the root stays exact as a goes through 0.
  if (discriminant >= 0) out.timeToImpact = (2 * surface.clearance) / (falling + Math.sqrt(discriminant));
}

const product = new Float64Array(2);
