import type { WorldView } from '../../prediction';
import { writeDot } from '../axes';
import type { LandingAids } from './landingAids';

/** The approach dial: the pad and the predicted touchdown relative to the ship, m, in the screen's axes: x right, y away. */
export interface TargetReadout {
  shown: boolean;
  /** Along the ground to the pad's centre. */
  distance: number;
  x: number;
  y: number;
  /** Of the predicted touchdown from the pad's centre; NaN while none is predicted. */
  missX: number;
  missY: number;
  /** m/s along the ground. */
  driftX: number;
  driftY: number;
  radius: number;
  /** Full deflection of the dial, m. */
  scale: number;
}

/** The pad aimed at: relative to the body's centre, ICRF axes at the body's present attitude, m. */
export interface Target {
  readonly place: Float64Array;
  readonly radius: number;
}

const SCALES = [10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000, 50_000] as const;
/** Keeps the target off the dial's rim. */
const MARGIN = 1.1;

/**
 * An empty readout of a target, filled by updateTargetReadout.
 *
 * @example
 * ```ts
 * const readout = createTargetReadout();
 * console.log(readout.shown); // false until a target is passed
 * ```
 */
export function createTargetReadout(): TargetReadout {
  return {
    shown: false,
    distance: NaN,
    x: NaN,
    y: NaN,
    missX: NaN,
    missY: NaN,
    driftX: NaN,
    driftY: NaN,
    radius: NaN,
    scale: 10,
  };
}

const product = new Float64Array(6);
const offset = new Float64Array(3);
const drift = new Float64Array(3);

/**
 * @param screen right, away and up in ICRF (nine numbers)
 *
 * @example
 * ```ts
 * const screen = new Float64Array(9);
 * scene.screenAxes(screen);
 * updateTargetReadout(createTargetReadout(), predictor.view(now), null, screen, createLandingAids());
 * ```
 */
export function updateTargetReadout(
  out: TargetReadout,
  view: WorldView,
  target: Target | null,
  screen: Float64Array,
  aids: LandingAids,
): TargetReadout {
  const ship = view.ready ? view.own : null;
  const body = ship === null ? undefined : view.bodies[ship.body];
  out.shown = target !== null && body !== undefined && ship?.shownState !== 'crashed';
  if (!out.shown || target === null || ship === null || body === undefined) return out;
  const right = screen.subarray(0, 3);
  const away = screen.subarray(3, 6);
  for (let k = 0; k < 3; k++) offset[k] = target.place[k]! - ship.position[k]!;
  const w = body.angularVelocity;
  const r = ship.position;
  drift[0] = ship.velocity[0]! - (w[1] * r[2]! - w[2] * r[1]!);
  drift[1] = ship.velocity[1]! - (w[2] * r[0]! - w[0] * r[2]!);
  drift[2] = ship.velocity[2]! - (w[0] * r[1]! - w[1] * r[0]!);
  writeDot(product, 0, offset, right);
  writeDot(product, 1, offset, away);
  writeDot(product, 2, drift, right);
  writeDot(product, 3, drift, away);
  out.x = product[0]!;
  out.y = product[1]!;
  out.driftX = product[2]!;
  out.driftY = product[3]!;
  out.distance = Math.sqrt(out.x * out.x + out.y * out.y);
  out.radius = target.radius;
  if (aids.outcome === 'touch') {
    for (let k = 0; k < 3; k++) offset[k] = aids.touchPlace[k]! - target.place[k]!;
    writeDot(product, 4, offset, right);
    writeDot(product, 5, offset, away);
    out.missX = product[4]!;
    out.missY = product[5]!;
  } else {
    out.missX = NaN;
    out.missY = NaN;
  }
  const needed = Math.max(out.distance, out.radius);
  out.scale = SCALES.find((scale) => scale >= needed * MARGIN) ?? SCALES[SCALES.length - 1]!;
  return out;
}
