import { quat, vec3 } from 'gl-matrix';

/** gl-matrix on plain lists of doubles: its own are single. */
export type Vec = [number, number, number];
/** [x, y, z, w] */
export type Turn = [number, number, number, number];

export const zero = (): Vec => [0, 0, 0];
export const plus = (a: Vec, b: Vec): Vec => vec3.add(zero(), a, b) as Vec;
export const minus = (a: Vec, b: Vec): Vec => vec3.subtract(zero(), a, b) as Vec;
export const times = (a: Vec, s: number): Vec => vec3.scale(zero(), a, s) as Vec;
export const cross = (a: Vec, b: Vec): Vec => vec3.cross(zero(), a, b) as Vec;
export const dot = (a: Vec, b: Vec): number => vec3.dot(a, b);
export const length = (a: Vec): number => vec3.length(a);
export const unit = (a: Vec): Vec => times(a, 1 / length(a));
export const turned = (q: Turn, v: Vec): Vec => vec3.transformQuat(zero(), v, q) as Vec;
export const conjugate = (q: Turn): Turn => quat.conjugate([0, 0, 0, 1], q) as Turn;
export const product = (a: Turn, b: Turn): Turn => quat.multiply([0, 0, 0, 1], a, b) as Turn;

/** Turned on by ω for `dt`, as one rotation. */
export function turnOn(q: Turn, w: Vec, dt: number): Turn {
  const angle = length(w) * dt;
  if (angle === 0) return q;
  const turn = quat.setAxisAngle([0, 0, 0, 1], unit(w), angle) as Turn;
  return quat.normalize([0, 0, 0, 1], product(turn, q)) as Turn;
}

/** The shortest rotation of one unit vector onto another, not its opposite. */
export const shortest = (from: Vec, to: Vec): Turn =>
  quat.normalize([0, 0, 0, 1], [...cross(from, to), 1 + dot(from, to)]) as Turn;
