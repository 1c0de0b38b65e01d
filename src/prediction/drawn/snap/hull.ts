import type { LoadedShipClass } from '../../../dynamics';

/** A ship's shape for ground contact: ship axes, m, from the centre of mass. */
export interface Hull {
  /** Feet of the landing legs, unloaded: [x, y, z] each. */
  readonly feet: Float64Array;
  /** How far a leg can be pressed in along the ship's −Z. */
  readonly stroke: number;
  /** Points of the rigid hull: [x, y, z] each. */
  readonly outline: Float64Array;
}

/** Legs of every class, as drawn. */
export const LEGS = 4;
/** In units of h: the legs' stroke, and the hull's radius and extent above the centre. */
const STROKE = 0.2;
const RADIUS = 0.5;
const TOP = 1;
/** In units of h: the hull's lower edge, above the feet by more than the stroke. */
const BOTTOM = -0.6;

/** The data that a ship's hull is derived from. */
export interface HullOwner {
  readonly shipClass: LoadedShipClass;
  /** The ship's own, m. */
  readonly groundContactOffset: number;
}

/**
 * The hull of a class, derived from h and leg radius: the game publishes no outline. Feet at 45°, 135°, … on the footprint's circle,
 * h below the centre; the hull a cylinder of half that height's radius, by the octagons of its two rims.
 * @param groundContactOffset a ship's own, m: the class's shape is moved along body z until its feet are this far below the centre
 *
 * @example
 * ```ts
 * const { own } = predictor.view(now);
 * if (own !== null) console.log(hullOf(own.shipClass, own.groundContactOffset)); // points in ship axes, m
 * ```
 */
export function hullOf(
  shipClass: LoadedShipClass,
  groundContactOffset = shipClass.groundContactOffset,
): Hull {
  return hullOfShip({ shipClass, groundContactOffset });
}

/** As hullOf, but in a record: a double as an argument is boxed at each call. */
export function hullOfShip(ship: HullOwner): Hull {
  const { shipClass } = ship;
  const known = hulls.get(shipClass) ?? [];
  for (const hull of known) if (hull.groundContactOffset === ship.groundContactOffset) return hull;
  const hull = buildHull(ship);
  if (known.length === MAX_HULLS) known.shift();
  known.push(hull);
  hulls.set(shipClass, known);
  return hull;
}

interface OffsetHull extends Hull {
  readonly groundContactOffset: number;
}

function buildHull({ shipClass, groundContactOffset }: HullOwner): OffsetHull {
  const { groundContactOffset: h, legRadius } = shipClass;
  const raised = h - groundContactOffset;
  const rim = (z: number) => ring(8, RADIUS * h, z * h + raised);
  return {
    groundContactOffset,
    feet: ring(LEGS, legRadius, -groundContactOffset),
    stroke: STROKE * h,
    outline: Float64Array.of(...rim(BOTTOM), ...rim(TOP)),
  };
}

/** Hulls cached per class. Ships of one class have few different offsets, but a hostile server may send any number. */
const MAX_HULLS = 16;
const hulls = new WeakMap<LoadedShipClass, OffsetHull[]>();

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
