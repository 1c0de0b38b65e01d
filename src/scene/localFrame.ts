import { mat3, quat, vec3 } from 'gl-matrix';
import type { Body, Quat } from '../dynamics';

/**
 * The axes of the scene: fixed in the body, origin on its sphere of `radius`; x points along the ground
 * towards the sun (so that shadows of the terrain fall along rows of the ground's grid), y up, z = x × y. Metres, doubles.
 */
export interface LocalFrame {
  readonly bodyName: string;
  readonly radius: number;
  /** 3×3, row by row: body axes -> local axes. */
  readonly axes: Float64Array;
  /** Tangent of the sun's elevation at the origin. */
  readonly sunSlope: number;
}

/** The sun's place over a frame's origin: degrees above the horizon, and from east towards north. */
export interface SunPlace {
  readonly elevation: number;
  readonly azimuth: number;
}

const RADIANS = Math.PI / 180;

const inverse = new Float64Array(4) as unknown as quat;

/** ICRF -> the axes of a body with this attitude. */
export function toBodyAxes(out: Float64Array, attitude: Quat, way: Float64Array): void {
  quat.conjugate(inverse, attitude);
  vec3.transformQuat(out, way, inverse);
}

/** A frame under a point in body axes. */
export function createLocalFrame(body: Body, point: ArrayLike<number>, sun: SunPlace): LocalFrame {
  const length = Math.hypot(point[0]!, point[1]!, point[2]!);
  const [ux, uy, uz] = [point[0]! / length, point[1]! / length, point[2]! / length];
  // East is pole × up; at the poles any horizontal direction will do.
  const across = Math.hypot(ux, uz);
  const [ex, ez] = across > 1e-6 ? [uz / across, -ux / across] : [1, 0];
  // North is up × east, whose y is 0.
  const [nx, ny, nz] = [uy * ez, uz * ex - ux * ez, -uy * ex];
  const cos = Math.cos(sun.azimuth * RADIANS);
  const sin = Math.sin(sun.azimuth * RADIANS);
  const [xx, xy, xz] = [cos * ex + sin * nx, sin * ny, cos * ez + sin * nz];
  const [zx, zy, zz] = [xy * uz - xz * uy, xz * ux - xx * uz, xx * uy - xy * ux];
  return {
    bodyName: body.name,
    radius: body.radius,
    axes: Float64Array.of(xx, xy, xz, ux, uy, uz, zx, zy, zz),
    sunSlope: Math.tan(sun.elevation * RADIANS),
  };
}

/** The rotation ICRF -> local axes, now: as 3×3 row by row, and as a quaternion. */
export interface Turn {
  readonly matrix: Float64Array;
  readonly quaternion: Float64Array;
}

export function createTurn(): Turn {
  return { matrix: new Float64Array(9), quaternion: Float64Array.of(0, 0, 0, 1) };
}

const bodyColumns = new Float64Array(9);
const columns = new Float64Array(9);

export function turnOfFrame(out: Turn, frame: LocalFrame, bodyAttitude: Quat): Turn {
  const { matrix } = out;
  const { axes } = frame;
  // Columns of the body's attitude are its axes in ICRF.
  mat3.fromQuat(bodyColumns, bodyAttitude);
  for (let row = 0; row < 3; row++) {
    for (let k = 0; k < 3; k++) {
      let sum = 0;
      for (let i = 0; i < 3; i++) sum += axes[row * 3 + i]! * bodyColumns[i * 3 + k]!;
      matrix[row * 3 + k] = sum;
      columns[k * 3 + row] = sum;
    }
  }
  quat.fromMat3(out.quaternion, columns);
  quat.normalize(out.quaternion, out.quaternion);
  return out;
}

/** out = matrix · vector; `out` may be `vector`. */
export function rotate(out: Float64Array, matrix: Float64Array, vector: ArrayLike<number>): Float64Array {
  const [x, y, z] = [vector[0]!, vector[1]!, vector[2]!];
  out[0] = matrix[0]! * x + matrix[1]! * y + matrix[2]! * z;
  out[1] = matrix[3]! * x + matrix[4]! * y + matrix[5]! * z;
  out[2] = matrix[6]! * x + matrix[7]! * y + matrix[8]! * z;
  return out;
}

/** out[at …] = a local vector in ICRF axes: matrixᵀ · vector. */
function writeIcrf(out: Float64Array, at: number, { matrix }: Turn, v: readonly number[]): void {
  for (let k = 0; k < 3; k++)
    out[at + k] = matrix[k]! * v[0]! + matrix[3 + k]! * v[1]! + matrix[6 + k]! * v[2]!;
}

/** The screen's axes for an eye that looks at a focus: right, away along the ground, and up; in ICRF axes, nine numbers. */
export function writeScreenAxes(out: Float64Array, turn: Turn, eye: Float64Array, focus: Float64Array): void {
  const x = focus[0]! - eye[0]!;
  const z = focus[2]! - eye[2]!;
  const length = Math.hypot(x, z) || 1;
  // Local axes are x, up, z, right-handed: right = away × up.
  writeIcrf(out, 0, turn, [-z / length, 0, x / length]);
  writeIcrf(out, 3, turn, [x / length, 0, z / length]);
  writeIcrf(out, 6, turn, [0, 1, 0]);
}

/** Local coordinates of a point given relative to the body's centre in ICRF axes. */
export function toLocalPoint(
  out: Float64Array,
  frame: LocalFrame,
  turn: Turn,
  point: ArrayLike<number>,
): Float64Array {
  rotate(out, turn.matrix, point);
  out[1] = out[1]! - frame.radius;
  return out;
}
