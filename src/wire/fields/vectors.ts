import type { Quat, Vec3 } from '../../dynamics';
import { type Bound, FINITE } from '../limits';
import { describe, type Fields, fieldsOf, numberIn, type Reading, refuse, valueIn } from './reading';

/** Largest deviation of a quaternion's length from 1. */
const UNIT_WITHIN = 1e-3;
/** A quaternion whose length is this close to 1 keeps its bits, so that a sent state replays to the same bits. */
const KEPT_WITHIN = 1e-12;

/** In place of a missing vector, whose message is refused. */
const NO_VECTOR: Vec3 = [NaN, NaN, NaN];
const NO_QUATERNION: Quat = [NaN, NaN, NaN, NaN];

/** {x, y, z} or [x, y, z], in JSON also as a string of it; refused when it is not sent. */
export function vectorIn(r: Reading, from: Fields, name: string, bound: Bound): Vec3 {
  const vector = optionalVectorIn(r, from, name, bound);
  if (vector === null) refuse(r, name, 'missing');
  return vector ?? NO_VECTOR;
}

/** {x, y, z} or [x, y, z]; null when it is not sent. */
export function optionalVectorIn(r: Reading, from: Fields, name: string, bound: Bound): Vec3 | null {
  const value = valueIn(r, from, name);
  if (value === undefined) return null;
  r.path.push(name);
  const parts = partsOf(r, value, ['x', 'y', 'z']);
  const vector: Vec3 = [
    numberIn(r, parts, 'x', bound),
    numberIn(r, parts, 'y', bound),
    numberIn(r, parts, 'z', bound),
  ];
  r.path.pop();
  return vector;
}

/** {w, x, y, z} or [w, x, y, z], of length 1 within 1e-3, as [x, y, z, w]; refused when it is not sent. */
export function quaternionIn(r: Reading, from: Fields, name: string): Quat {
  const quaternion = optionalQuaternionIn(r, from, name);
  if (quaternion === null) refuse(r, name, 'missing');
  return quaternion ?? NO_QUATERNION;
}

/** As quaternionIn; null when it is not sent. */
export function optionalQuaternionIn(r: Reading, from: Fields, name: string): Quat | null {
  const value = valueIn(r, from, name);
  if (value === undefined) return null;
  r.path.push(name);
  const parts = partsOf(r, value, ['w', 'x', 'y', 'z']);
  const w = numberIn(r, parts, 'w', FINITE);
  const x = numberIn(r, parts, 'x', FINITE);
  const y = numberIn(r, parts, 'y', FINITE);
  const z = numberIn(r, parts, 'z', FINITE);
  const length = Math.sqrt(x * x + y * y + z * z + w * w);
  const error = Math.abs(length - 1);
  if (!(error <= UNIT_WITHIN))
    refuse(r, '', `expected a quaternion of length 1 within ${UNIT_WITHIN}, got ${length}`);
  r.path.pop();
  return error <= KEPT_WITHIN ? [x, y, z, w] : [x / length, y / length, z / length, w / length];
}

/** Longest string that is parsed as a vector or quaternion, with some white space. */
const MAX_VECTOR_TEXT = 256;

/** The components: an object's own, or a list's under `names`. */
function partsOf(r: Reading, sent: unknown, names: readonly string[]): Fields {
  const value = r.source === 'json' && typeof sent === 'string' ? parsedOr(sent) : sent;
  if (!Array.isArray(value)) return fieldsOf(r, value);
  if (value.length !== names.length)
    refuse(r, '', `expected ${names.length} numbers, got ${describe(value)}`);
  return Object.fromEntries(names.map((name, i) => [name, value[i] as unknown]));
}

/** The value of a JSON string; any other string unchanged. */
function parsedOr(text: string): unknown {
  if (text.length > MAX_VECTOR_TEXT) return text;
  try {
    return JSON.parse(text) as unknown;
  } catch {
    return text;
  }
}

/** As in protobuf and JSON. */
export function vectorFields([x, y, z]: Vec3): { x: number; y: number; z: number } {
  return { x, y, z };
}

/** As in protobuf and JSON, w first. */
export function quaternionFields([x, y, z, w]: Quat): { w: number; x: number; y: number; z: number } {
  return { w, x, y, z };
}
