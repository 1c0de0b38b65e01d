import { ANGULAR_VELOCITY } from '../state/layout';
import {
  AXES,
  AXIS,
  COS_TILT,
  DT,
  FROM,
  GROUND_SPIN,
  quantities,
  ROTATION,
  step,
  SURFACE_NORMAL,
  TO,
} from './quantities';
import { perpendicularAxis, rotateAttitude, shortestRotation } from '../arithmetic/rotations';
import { readAxes, readTilt } from './pose';
import { INVERSE_INERTIA } from '../constants/constantRows';

/**
 * Step 8: the hull of a tipped ship rests on its side. Past 90° of tilt an impulse of the ground stops further tilting, and the ship is
 * turned back to 90° at 1 rad/s. Reads the surface and `up` at the substep's end; updates `up`.
 */
export function restOnSide(): void {
  const q = quantities;
  readTilt();
  if (!(q[COS_TILT]! < 0)) return;
  readAxes();
  findAxis();
  stopFurtherTilt();
  if (-q[COS_TILT]! > q[DT]!) turnBack();
  else layFlat();
  rotateAttitude();
  readAxes();
}

/** ROTATION = normalize(−½ dt axis, 1): a turn back at 1 rad/s. */
function turnBack(): void {
  const q = quantities;
  const half = -0.5 * q[DT]!;
  const x = half * q[AXIS]!;
  const y = half * q[AXIS + 1]!;
  const z = half * q[AXIS + 2]!;
  const perLength = 1 / Math.sqrt(x * x + y * y + z * z + 1);
  q[ROTATION] = x * perLength;
  q[ROTATION + 1] = y * perLength;
  q[ROTATION + 2] = z * perLength;
  q[ROTATION + 3] = perLength;
}

/** Largest ‖s × up‖ of a ship that counts as upside down: s × up then has no usable direction. */
const ON_ITS_HEAD = 1e-6;

/** AXIS = unit(s × up), the tipping axis; any axis along the ground if the ship is upside down. */
function findAxis(): void {
  const q = quantities;
  const nx = q[SURFACE_NORMAL]!;
  const ny = q[SURFACE_NORMAL + 1]!;
  const nz = q[SURFACE_NORMAL + 2]!;
  const x = ny * q[AXES + 8]! - nz * q[AXES + 5]!;
  const y = nz * q[AXES + 2]! - nx * q[AXES + 8]!;
  const z = nx * q[AXES + 5]! - ny * q[AXES + 2]!;
  const length = Math.sqrt(x * x + y * y + z * z);
  if (length <= ON_ITS_HEAD) {
    perpendicularAxis(SURFACE_NORMAL);
    return;
  }
  const perLength = 1 / length;
  q[AXIS] = x * perLength;
  q[AXIS + 1] = y * perLength;
  q[AXIS + 2] = z * perLength;
}

/**
 * w −= j f / (j · axis), with j = I_world⁻¹ axis and f the spin about the axis: an impulse of the ground about the axis. The inertia
 * factor cancels. Removing the component of w along the axis instead would feed spin into the other axes of a full tensor.
 */
function stopFurtherTilt(): void {
  const q = quantities;
  const { ships, at, shipClass } = step;
  const ax = q[AXIS]!;
  const ay = q[AXIS + 1]!;
  const az = q[AXIS + 2]!;
  const wx = ships[at + ANGULAR_VELOCITY]! - q[GROUND_SPIN]!;
  const wy = ships[at + ANGULAR_VELOCITY + 1]! - q[GROUND_SPIN + 1]!;
  const wz = ships[at + ANGULAR_VELOCITY + 2]! - q[GROUND_SPIN + 2]!;
  const speed = wx * ax + wy * ay + wz * az;
  if (!(speed > 0)) return;
  const bx = q[AXES]! * ax + q[AXES + 3]! * ay + q[AXES + 6]! * az;
  const by = q[AXES + 1]! * ax + q[AXES + 4]! * ay + q[AXES + 7]! * az;
  const bz = q[AXES + 2]! * ax + q[AXES + 5]! * ay + q[AXES + 8]! * az;
  const ix =
    shipClass[INVERSE_INERTIA]! * bx +
    shipClass[INVERSE_INERTIA + 1]! * by +
    shipClass[INVERSE_INERTIA + 2]! * bz;
  const iy =
    shipClass[INVERSE_INERTIA + 3]! * bx +
    shipClass[INVERSE_INERTIA + 4]! * by +
    shipClass[INVERSE_INERTIA + 5]! * bz;
  const iz =
    shipClass[INVERSE_INERTIA + 6]! * bx +
    shipClass[INVERSE_INERTIA + 7]! * by +
    shipClass[INVERSE_INERTIA + 8]! * bz;
  const jx = q[AXES]! * ix + q[AXES + 1]! * iy + q[AXES + 2]! * iz;
  const jy = q[AXES + 3]! * ix + q[AXES + 4]! * iy + q[AXES + 5]! * iz;
  const jz = q[AXES + 6]! * ix + q[AXES + 7]! * iy + q[AXES + 8]! * iz;
  const impulse = speed / (jx * ax + jy * ay + jz * az);
  ships[at + ANGULAR_VELOCITY] = ships[at + ANGULAR_VELOCITY]! - jx * impulse;
  ships[at + ANGULAR_VELOCITY + 1] = ships[at + ANGULAR_VELOCITY + 1]! - jy * impulse;
  ships[at + ANGULAR_VELOCITY + 2] = ships[at + ANGULAR_VELOCITY + 2]! - jz * impulse;
}

/** ROTATION = the shortest rotation from up to unit(up − cos_tilt s). */
function layFlat(): void {
  const q = quantities;
  const cos = q[COS_TILT]!;
  q[FROM] = q[AXES + 2]!;
  q[FROM + 1] = q[AXES + 5]!;
  q[FROM + 2] = q[AXES + 8]!;
  const x = q[FROM] - cos * q[SURFACE_NORMAL]!;
  const y = q[FROM + 1]! - cos * q[SURFACE_NORMAL + 1]!;
  const z = q[FROM + 2]! - cos * q[SURFACE_NORMAL + 2]!;
  const perLength = 1 / Math.sqrt(x * x + y * y + z * z);
  q[TO] = x * perLength;
  q[TO + 1] = y * perLength;
  q[TO + 2] = z * perLength;
  shortestRotation();
}
