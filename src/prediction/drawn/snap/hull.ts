import type { LoadedShipClass } from '../../../dynamics';

/** A ship's shape as far as the ground is concerned: body axes, m, from the centre of mass. */
export interface Hull {
  /** Feet of the landing legs, unloaded: [x, y, z] each. */
  readonly feet: Float64Array;
  /** How far a leg can be pressed in along body −Z. */
  readonly stroke: number;
  /** Points of the rigid hull: [x, y, z] each. */
  readonly outline: Float64Array;
}

/** Legs of every class drawn. */
export const LEGS = 4;
/** Of h: the legs' stroke, and the hull's radius and extent above the centre. */
const STROKE = 0.2;
const RADIUS = 0.5;
const TOP = 1;
/** Of h: the hull's lower edge, above the feet by more than the stroke. */
const BOTTOM = -0.6;

/**
 * The hull of a class, derived from h and leg radius: the game publishes no outline. Feet at 45°, 135°, … on the footprint's circle,
 * h below the centre; the hull a cylinder of half that height's radius, by the octagons of its two rims.
 */
export function hullOf(shipClass: LoadedShipClass): Hull {
  const known = hulls.get(shipClass);
  if (known !== undefined) return known;
  const { groundContactOffset: h, legRadius } = shipClass;
  const feet = ring(LEGS, legRadius, -h);
  const outline = Float64Array.of(...ring(8, RADIUS * h, BOTTOM * h), ...ring(8, RADIUS * h, TOP * h));
  const hull: Hull = { feet, stroke: STROKE * h, outline };
  hulls.set(shipClass, hull);
  return hull;
}

const hulls = new WeakMap<LoadedShipClass, Hull>();

function ring(count: number, radius: number, z: number): Float64Array {
  const points = new Float64Array(count * 3);
  for (let i = 0; i < count; i++) {
    const angle = ((i + 0.5) / count) * 2 * Math.PI;
    points[i * 3] = radius * Math.cos(angle);
    points[i * 3 + 1] = radius * Math.sin(angle);
    points[i * 3 + 2] = z;
  }
  return points;
}
