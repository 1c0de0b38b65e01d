import { type Body, type BodyMotion, CONTACT_STIFFNESS, GRAVITATIONAL_CONSTANT } from '../dynamics';
import type { ShipView } from '../prediction';
import { cross, toBodyAxes, toInertial, writeDot } from './axes';

/**
 * A ship against the ground beneath it: the quantities of DYNAMICS ("Quantities, at the start of a substep"; step 3),
 * recomputed from a view. SI units, radians, ICRF axes unless stated. Nothing here enters the simulation, so
 * Math.atan2 and friends are allowed.
 */
export interface Surface {
  /** n: local up, unit. */
  readonly normal: Float64Array;
  /** The ship's +Z. */
  readonly up: Float64Array;
  /** Local up in ship axes. */
  readonly normalInShip: Float64Array;
  /** s: the surface normal, unit, and in ship axes. */
  readonly ground: Float64Array;
  readonly groundInShip: Float64Array;
  /** n · s. */
  cosSlope: number;
  /** Between them, rad. */
  slope: number;
  /** ‖r‖, m. */
  distance: number;
  /** m/s², m/s² · kg = N */
  gravity: number;
  mass: number;
  weight: number;
  /** thrust · n, N. */
  lift: number;
  /** Positive below the surface, m. */
  penetration: number;
  /** v_rel · n: positive = rising, m/s. */
  radialSpeed: number;
  /** Along the ground, relative to the turning ground, m/s. */
  readonly tangential: Float64Array;
  tangentialSpeed: number;
  /** ‖v_rel − v_s s‖, m/s: along the slope, where there is one. */
  slideSpeed: number;
  /** √(v_s² + 100 (penetration c_s − depth)²), m/s (step 3). */
  vertical: number;
  /** ‖w − Ω‖, rad/s. */
  spin: number;
  /** From the surface normal, 0 … π. */
  tilt: number;
  /** From the vertical, 0 … π. */
  lean: number;
  /** rad/s, positive = leaning over further. */
  tiltRate: number;
  /** Height of the law's contact point above the ground, m: ‖r‖ − surface_r, negative when sunk in. */
  clearance: number;
  /** arctan(leg_radius / h), rad: at a larger lean from the vertical the centre of mass is outside the feet. */
  noReturn: number;
}

/** Numbers start as NaN, a double: a field that starts with a whole number is laid out for those, and boxed as soon as it is not one. */
export function createSurface(): Surface {
  return {
    normal: new Float64Array(3),
    up: new Float64Array(3),
    normalInShip: new Float64Array(3),
    ground: new Float64Array(3),
    groundInShip: new Float64Array(3),
    cosSlope: NaN,
    slope: NaN,
    distance: NaN,
    gravity: NaN,
    mass: NaN,
    weight: NaN,
    lift: NaN,
    penetration: NaN,
    radialSpeed: NaN,
    tangential: new Float64Array(3),
    tangentialSpeed: NaN,
    slideSpeed: NaN,
    vertical: NaN,
    spin: NaN,
    tilt: NaN,
    lean: NaN,
    tiltRate: NaN,
    clearance: NaN,
    noReturn: NaN,
  };
}

/** Fills `out` from a ship's predicted truth and its reference body. */
export function measureSurface(out: Surface, ship: ShipView, body: Body & BodyMotion): void {
  measurePlace(out, ship, body);
  measureMotion(out, ship, body);
  measureLean(out, ship, body);
}

const BODY_UP = Float64Array.of(0, 0, 1);
const bodySpin = new Float64Array(3);
const groundVelocity = new Float64Array(3);
const spinAgainstGround = new Float64Array(3);
const tiltAxis = new Float64Array(3);
const across = new Float64Array(3);
const product = new Float64Array(2);

function measurePlace(out: Surface, ship: ShipView, body: Body): void {
  const r = ship.position;
  writeDot(product, 0, r, r);
  out.distance = Math.sqrt(product[0]!);
  for (let k = 0; k < 3; k++) out.normal[k] = r[k]! / out.distance;
  out.gravity = (GRAVITATIONAL_CONSTANT * body.mass) / (out.distance * out.distance);
  out.mass = ship.shipClass.dryMass + ship.fuel;
  out.weight = out.mass * out.gravity;
  writeDot(product, 0, ship.thrust, out.normal);
  out.lift = product[0]!;
  out.clearance = out.distance - (ship.groundRadius + ship.groundContactOffset);
  out.penetration = -out.clearance;
  for (let k = 0; k < 3; k++) out.ground[k] = ship.groundNormal[k]!;
  cross(across, out.normal, out.ground);
  writeDot(product, 0, across, across);
  writeDot(product, 1, out.normal, out.ground);
  out.cosSlope = product[1]!;
  out.slope = Math.atan2(Math.sqrt(product[0]!), product[1]!);
}

function measureMotion(out: Surface, ship: ShipView, body: BodyMotion): void {
  for (let k = 0; k < 3; k++) bodySpin[k] = body.angularVelocity[k]!;
  cross(groundVelocity, bodySpin, ship.position);
  for (let k = 0; k < 3; k++) out.tangential[k] = ship.velocity[k]! - groundVelocity[k]!;
  writeDot(product, 0, out.tangential, out.normal);
  out.radialSpeed = product[0]!;
  writeDot(product, 0, out.tangential, out.ground);
  writeDot(product, 1, out.tangential, out.tangential);
  const off = product[0]!;
  out.slideSpeed = Math.sqrt(Math.max(0, product[1]! - off * off));
  for (let k = 0; k < 3; k++) out.tangential[k]! -= out.radialSpeed * out.normal[k]!;
  writeDot(product, 0, out.tangential, out.tangential);
  out.tangentialSpeed = Math.sqrt(product[0]!);
  writeDot(product, 0, ship.thrust, out.ground);
  const load = Math.max(0, out.weight * out.cosSlope - product[0]!);
  const stored = out.penetration * out.cosSlope - load / (CONTACT_STIFFNESS * out.mass);
  out.vertical = Math.sqrt(off * off + CONTACT_STIFFNESS * stored * stored);
}

/** Sine of a tilt below which its axis, and so the rate about it, fades into round-off. */
const MIN_SINE = 1e-9;

function measureLean(out: Surface, ship: ShipView, body: BodyMotion): void {
  toInertial(out.up, ship.attitude, BODY_UP);
  toBodyAxes(out.normalInShip, ship.attitude, out.normal);
  toBodyAxes(out.groundInShip, ship.attitude, out.ground);
  cross(across, out.normal, out.up);
  writeDot(product, 0, across, across);
  writeDot(product, 1, out.normal, out.up);
  out.lean = Math.atan2(Math.sqrt(product[0]!), product[1]!);
  cross(tiltAxis, out.ground, out.up);
  writeDot(product, 0, tiltAxis, tiltAxis);
  writeDot(product, 1, out.ground, out.up);
  const sine = Math.sqrt(product[0]!);
  // atan2 keeps its precision at 0 and 90°, where acos and asin lose half the digits.
  out.tilt = Math.atan2(sine, product[1]!);
  for (let k = 0; k < 3; k++) spinAgainstGround[k] = ship.angularVelocity[k]! - body.angularVelocity[k]!;
  writeDot(product, 0, spinAgainstGround, spinAgainstGround);
  writeDot(product, 1, spinAgainstGround, tiltAxis);
  out.spin = Math.sqrt(product[0]!);
  out.tiltRate = product[1]! / Math.max(sine, MIN_SINE);
  out.noReturn = Math.atan2(ship.shipClass.legRadius, ship.groundContactOffset);
}
