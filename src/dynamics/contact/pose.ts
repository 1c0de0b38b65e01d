import { ANGULAR_VELOCITY, ATTITUDE, POSITION, VELOCITY } from '../state/layout';
import { AXES, COS_TILT, GROUND_SPIN, quantities, SMI_MASK, step, SURFACE_NORMAL } from './quantities';

/** Fills AXES, the rotation matrix of the ship's current attitude. */
export function readAxes(): void {
  readMatrix(step.ships, step.at + ATTITUDE, AXES);
}

/** Fills the nine slots at `to` with the rotation matrix, row by row, of the unit quaternion at `from` in `rows`. */
export function readMatrix(rows: Float64Array, from: number, to: number): void {
  const q = quantities;
  const x = rows[from]!;
  const y = rows[from + 1]!;
  const z = rows[from + 2]!;
  const w = rows[from + 3]!;
  const x2 = x + x;
  const y2 = y + y;
  const z2 = z + z;
  q[to] = 1 - (y * y2 + z * z2);
  q[to + 1] = x * y2 - w * z2;
  q[to + 2] = x * z2 + w * y2;
  q[to + 3] = x * y2 + w * z2;
  q[to + 4] = 1 - (x * x2 + z * z2);
  q[to + 5] = y * z2 - w * x2;
  q[to + 6] = x * z2 - w * y2;
  q[to + 7] = y * z2 + w * x2;
  q[to + 8] = 1 - (x * x2 + y * y2);
}

/** COS_TILT = s · up at the substep's end; `up` is the third column of AXES. */
export function readTilt(): void {
  const q = quantities;
  q[COS_TILT] =
    q[SURFACE_NORMAL]! * q[AXES + 2]! +
    q[SURFACE_NORMAL + 1]! * q[AXES + 5]! +
    q[SURFACE_NORMAL + 2]! * q[AXES + 8]!;
}

/** u = Ω × r: the velocity of co-rotating ground at the ship's centre of mass. */
export function moveWithGround(): void {
  const q = quantities;
  const { ships } = step;
  const at = step.at & SMI_MASK;
  const ox = q[GROUND_SPIN]!;
  const oy = q[GROUND_SPIN + 1]!;
  const oz = q[GROUND_SPIN + 2]!;
  const rx = ships[at + POSITION]!;
  const ry = ships[at + POSITION + 1]!;
  const rz = ships[at + POSITION + 2]!;
  ships[at + VELOCITY] = oy * rz - oz * ry;
  ships[at + VELOCITY + 1] = oz * rx - ox * rz;
  ships[at + VELOCITY + 2] = ox * ry - oy * rx;
}

/** w = Ω: the ship rotates with the ground. */
export function spinWithGround(): void {
  const q = quantities;
  const { ships } = step;
  const at = step.at & SMI_MASK;
  ships[at + ANGULAR_VELOCITY] = q[GROUND_SPIN]!;
  ships[at + ANGULAR_VELOCITY + 1] = q[GROUND_SPIN + 1]!;
  ships[at + ANGULAR_VELOCITY + 2] = q[GROUND_SPIN + 2]!;
}
