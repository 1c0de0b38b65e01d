import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  BODY_ATTITUDE,
  BODY_POSITION,
  BODY_STRIDE,
  CRASHED,
  FUEL,
  GROUND_CONTACT_OFFSET,
  POSITION,
  REFERENCE_BODY,
  SHIP_CLASS,
  SURFACE_STATE,
  SURFACE_STATES,
  VELOCITY,
  WHEEL_MOMENTUM,
} from '../../../dynamics';
import {
  angleOf,
  lengthOf,
  quaternion,
  rotateBack,
  relativeRotation,
  take,
  rotationBetween,
  vector,
} from '../../drawn/rotation';

/** A row at `at` in `rows`, and the bodies at its tick. */
export interface Place {
  rows: Float64Array;
  at: number;
  bodies: Float64Array;
}

/** Largest differences at which two states of one tick still count as equal: position m, velocity m/s, spin rad/s. */
export type Tolerance = Float64Array;
const PLACE = 0;
const SPEED = 1;
const SPIN = 2;

/** First field in which two states differ, in order of comparison; none if they are equal. */
export type Field =
  | 'none'
  | 'shipClass'
  | 'referenceBody'
  | 'crashed'
  | 'surfaceContactState'
  | 'position'
  | 'velocity'
  | 'attitude'
  | 'angularVelocity'
  | 'fuel'
  | 'wheelMomentum'
  | 'groundContactOffset';

/** Component of a quaternion: half the angle, rad. */
const ATTITUDE_TOLERANCE = 1e-7;
/** kg: the tolerance of the fixtures. */
const FUEL_TOLERANCE = 1e-6;
/** N m s, likewise. */
const WHEEL_TOLERANCE = 1e-4;

/** The tolerance for a server that sends the relative state. */
export const EXACT: Tolerance = Float64Array.of(1e-6, 1e-6, 1e-6);

/** The tolerance for a server that sends only ICRF positions: 8 ulp of the largest coordinate, and 10 s⁻¹ times that. */
export function writeInexact(out: Tolerance, server: Place): void {
  const body = server.rows[server.at + REFERENCE_BODY]! * BODY_STRIDE + BODY_POSITION;
  let largest = 0;
  for (let k = 0; k < 3; k++) {
    const x = Math.abs(server.bodies[body + k]! + server.rows[server.at + POSITION + k]!);
    if (x > largest) largest = x;
  }
  out[PLACE] = Math.max(EXACT[PLACE]!, 8 * ulpOf(largest));
  out[SPEED] = 10 * out[PLACE];
  out[SPIN] = EXACT[SPIN]!;
}

/**
 * Compares a server state with the prediction for the same tick, each relative to its own body and in that body's axes (PREDICTION,
 * Reconciliation).
 */
export function firstDifference(server: Place, predicted: Place, tolerance: Tolerance): Field {
  const s = server.rows;
  const p = predicted.rows;
  const i = server.at;
  const j = predicted.at;
  if (s[i + SHIP_CLASS] !== p[j + SHIP_CLASS]) return 'shipClass';
  if (s[i + REFERENCE_BODY] !== p[j + REFERENCE_BODY]) return 'referenceBody';
  if (s[i + CRASHED] !== p[j + CRASHED]) return 'crashed';
  if (s[i + SURFACE_STATE] !== p[j + SURFACE_STATE]) return 'surfaceContactState';
  seeBoth(server, predicted);
  if (!near(serverSeen.place, predictedSeen.place, tolerance, PLACE)) return 'position';
  if (!near(serverSeen.velocity, predictedSeen.velocity, tolerance, SPEED)) return 'velocity';
  if (!sameAttitude(serverSeen.attitude, predictedSeen.attitude)) return 'attitude';
  if (!near(serverSeen.spin, predictedSeen.spin, tolerance, SPIN)) return 'angularVelocity';
  if (!(Math.abs(s[i + FUEL]! - p[j + FUEL]!) <= FUEL_TOLERANCE)) return 'fuel';
  for (let k = WHEEL_MOMENTUM; k < WHEEL_MOMENTUM + 3; k++)
    if (!(Math.abs(s[i + k]! - p[j + k]!) <= WHEEL_TOLERANCE)) return 'wheelMomentum';
  if (s[i + GROUND_CONTACT_OFFSET] !== p[j + GROUND_CONTACT_OFFSET]) return 'groundContactOffset';
  return 'none';
}

/** The error of a prediction. */
export interface PredictionError {
  /** m */
  errorPosition: number;
  /** rad */
  errorAngle: number;
}

/** Writes the error of `predicted` relative to the server state of the same tick, in the body's axes; NaN if their bodies differ. */
export function writeError(out: PredictionError, server: Place, predicted: Place | null): void {
  const body = server.rows[server.at + REFERENCE_BODY];
  if (predicted === null || predicted.rows[predicted.at + REFERENCE_BODY] !== body) {
    out.errorPosition = Number.NaN;
    out.errorAngle = Number.NaN;
    return;
  }
  seeBoth(server, predicted);
  for (let k = 0; k < 3; k++) serverSeen.place[k] = serverSeen.place[k]! - predictedSeen.place[k]!;
  out.errorPosition = lengthOf(serverSeen.place);
  rotationBetween(turn, serverSeen.attitude, predictedSeen.attitude);
  out.errorAngle = angleOf(turn);
}

const turn = quaternion();

/** The field in words, with both values, in the body's axes where it is a vector. */
export function describeDifference(field: Field, server: Place, predicted: Place): string {
  seeBoth(server, predicted);
  const [serverValue, predictedValue] = valuesOf(field, server, predicted);
  return `${field}: server ${serverValue}, predicted ${predictedValue}`;
}

/** A state in the axes of its body. */
interface Seen {
  readonly place: Float64Array;
  readonly velocity: Float64Array;
  readonly attitude: Float64Array;
  readonly spin: Float64Array;
}

const seen = (): Seen => ({ place: vector(), velocity: vector(), attitude: quaternion(), spin: vector() });
const serverSeen = seen();
const predictedSeen = seen();
const body = quaternion();

function seeBoth(server: Place, predicted: Place): void {
  rowToBodyAxes(serverSeen, server);
  rowToBodyAxes(predictedSeen, predicted);
}

function rowToBodyAxes(out: Seen, { rows, at, bodies }: Place): void {
  take(body, bodies, rows[at + REFERENCE_BODY]! * BODY_STRIDE + BODY_ATTITUDE);
  take(out.place, rows, at + POSITION);
  rotateBack(out.place, body, out.place);
  take(out.velocity, rows, at + VELOCITY);
  rotateBack(out.velocity, body, out.velocity);
  take(out.attitude, rows, at + ATTITUDE);
  relativeRotation(out.attitude, body, out.attitude);
  take(out.spin, rows, at + ANGULAR_VELOCITY);
  rotateBack(out.spin, body, out.spin);
}

function near(a: Float64Array, b: Float64Array, tolerance: Tolerance, which: number): boolean {
  const x = a[0]! - b[0]!;
  const y = a[1]! - b[1]!;
  const z = a[2]! - b[2]!;
  return x * x + y * y + z * z <= tolerance[which]! * tolerance[which]!;
}

/** Compares component by component with q and with −q, which are the same rotation. */
function sameAttitude(q: Float64Array, p: Float64Array): boolean {
  let same = true;
  let opposite = true;
  for (let k = 0; k < 4; k++) {
    if (!(Math.abs(q[k]! - p[k]!) <= ATTITUDE_TOLERANCE)) same = false;
    if (!(Math.abs(q[k]! + p[k]!) <= ATTITUDE_TOLERANCE)) opposite = false;
  }
  return same || opposite;
}

function valuesOf(field: Field, server: Place, predicted: Place): [string, string] {
  const number = (column: number): [string, string] => [
    String(server.rows[server.at + column]),
    String(predicted.rows[predicted.at + column]),
  ];
  const list = (a: Float64Array, b: Float64Array): [string, string] => [
    `[${a.join(', ')}]`,
    `[${b.join(', ')}]`,
  ];
  switch (field) {
    case 'position':
      return list(serverSeen.place, predictedSeen.place);
    case 'velocity':
      return list(serverSeen.velocity, predictedSeen.velocity);
    case 'attitude':
      return list(serverSeen.attitude, predictedSeen.attitude);
    case 'angularVelocity':
      return list(serverSeen.spin, predictedSeen.spin);
    case 'surfaceContactState':
      return [
        `'${SURFACE_STATES[server.rows[server.at + SURFACE_STATE]!]}'`,
        `'${SURFACE_STATES[predicted.rows[predicted.at + SURFACE_STATE]!]}'`,
      ];
    case 'fuel':
      return number(FUEL);
    case 'wheelMomentum':
      return list(
        server.rows.slice(server.at + WHEEL_MOMENTUM, server.at + WHEEL_MOMENTUM + 3),
        predicted.rows.slice(predicted.at + WHEEL_MOMENTUM, predicted.at + WHEEL_MOMENTUM + 3),
      );
    case 'groundContactOffset':
      return number(GROUND_CONTACT_OFFSET);
    case 'crashed':
      return number(CRASHED);
    case 'referenceBody':
      return number(REFERENCE_BODY);
    case 'shipClass':
      return number(SHIP_CLASS);
    case 'none':
      return ['', ''];
  }
}

/** Spacing of doubles at `x` ≥ 1: 2⁻⁵² times the power of two at or below it, from its exponent. */
function ulpOf(x: number): number {
  DOUBLE[0] = x < 1 ? 1 : x;
  WORDS[HIGH] = (WORDS[HIGH]! & 0x7ff00000) - (52 << 20);
  WORDS[1 - HIGH] = 0;
  return DOUBLE[0];
}

const DOUBLE = new Float64Array(1);
const WORDS = new Uint32Array(DOUBLE.buffer);
/** The index of the 32-bit half that holds the exponent on this machine. */
const HIGH = new Uint8Array(new Uint32Array([1]).buffer)[0] === 1 ? 1 : 0;
