import { ANGULAR_VELOCITY, ATTITUDE, POSITION, VELOCITY } from '../state/layout';
import { AXES, COS_TILT, end, GROUND_SPIN, quantities, SURFACE_NORMAL } from './quantities';

/** Fills AXES, the rotation matrix of the ship's current attitude. */
export function readAxes(): void {
  const q = quantities;
  const x = q[ATTITUDE]!;
  const y = q[ATTITUDE + 1]!;
  const z = q[ATTITUDE + 2]!;
  const w = q[ATTITUDE + 3]!;
  const x2 = x + x;
  const y2 = y + y;
  const z2 = z + z;
  q[AXES] = 1 - (y * y2 + z * z2);
  q[AXES + 1] = x * y2 - w * z2;
  q[AXES + 2] = x * z2 + w * y2;
  q[AXES + 3] = x * y2 + w * z2;
  q[AXES + 4] = 1 - (x * x2 + z * z2);
  q[AXES + 5] = y * z2 - w * x2;
  q[AXES + 6] = x * z2 - w * y2;
  q[AXES + 7] = y * z2 + w * x2;
  q[AXES + 8] = 1 - (x * x2 + y * y2);
}

/** Fills only the third column of AXES, the current `up`. */
export function readUp(): void {
  const q = quantities;
  const x = q[ATTITUDE]!;
  const y = q[ATTITUDE + 1]!;
  const z = q[ATTITUDE + 2]!;
  const w = q[ATTITUDE + 3]!;
  const x2 = x + x;
  const y2 = y + y;
  const z2 = z + z;
  q[AXES + 2] = x * z2 + w * y2;
  q[AXES + 5] = y * z2 - w * x2;
  q[AXES + 8] = 1 - (x * x2 + y * y2);
}

/** COS_TILT = s · up at the substep's end; `up` is the third column of AXES. */
export function readTilt(): void {
  const q = quantities;
  q[COS_TILT] =
    end[SURFACE_NORMAL]! * q[AXES + 2]! +
    end[SURFACE_NORMAL + 1]! * q[AXES + 5]! +
    end[SURFACE_NORMAL + 2]! * q[AXES + 8]!;
}

/** u = Ω × r: the velocity of co-rotating ground at the ship's centre of mass. */
export function moveWithGround(): void {
  const q = quantities;
  const ox = q[GROUND_SPIN]!;
  const oy = q[GROUND_SPIN + 1]!;
  const oz = q[GROUND_SPIN + 2]!;
  const rx = q[POSITION]!;
  const ry = q[POSITION + 1]!;
  const rz = q[POSITION + 2]!;
  q[VELOCITY] = oy * rz - oz * ry;
  q[VELOCITY + 1] = oz * rx - ox * rz;
  q[VELOCITY + 2] = ox * ry - oy * rx;
}

/** w = Ω: the ship rotates with the ground. */
export function spinWithGround(): void {
  const q = quantities;
  q[ANGULAR_VELOCITY] = q[GROUND_SPIN]!;
  q[ANGULAR_VELOCITY + 1] = q[GROUND_SPIN + 1]!;
  q[ANGULAR_VELOCITY + 2] = q[GROUND_SPIN + 2]!;
}
