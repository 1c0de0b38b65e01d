import { POSITION, VELOCITY } from '../state/layout';
import {
  DISTANCE_SQUARED,
  DT,
  GRAVITY_PARAMETER,
  MASS,
  NORMAL,
  quantities,
  SMI_MASK,
  START_POSITION,
  step,
  THRUST,
} from './quantities';
import { readPlace } from './surface';

/** Step 5 in flight: velocity Verlet under gravity and thrust. */
export function fly(): void {
  const q = quantities;
  const { ships } = step;
  const at = step.at & SMI_MASK;
  const dt = q[DT]!;
  const half = 0.5 * dt;
  const halfSquared = half * dt;
  const perMass = 1 / q[MASS]!;
  readPlace();
  const g = q[GRAVITY_PARAMETER]! / q[DISTANCE_SQUARED]!;
  const px = q[THRUST]! * perMass;
  const py = q[THRUST + 1]! * perMass;
  const pz = q[THRUST + 2]! * perMass;
  const ax = px - g * q[NORMAL]!;
  const ay = py - g * q[NORMAL + 1]!;
  const az = pz - g * q[NORMAL + 2]!;
  const ux = ships[at + VELOCITY]!;
  const uy = ships[at + VELOCITY + 1]!;
  const uz = ships[at + VELOCITY + 2]!;
  const rx = ships[at + POSITION]!;
  const ry = ships[at + POSITION + 1]!;
  const rz = ships[at + POSITION + 2]!;
  q[START_POSITION] = rx;
  q[START_POSITION + 1] = ry;
  q[START_POSITION + 2] = rz;
  ships[at + POSITION] = rx + (ux * dt + ax * halfSquared);
  ships[at + POSITION + 1] = ry + (uy * dt + ay * halfSquared);
  ships[at + POSITION + 2] = rz + (uz * dt + az * halfSquared);
  readPlace();
  const h = q[GRAVITY_PARAMETER]! / q[DISTANCE_SQUARED]!;
  ships[at + VELOCITY] = ux + (ax + (px - h * q[NORMAL]!)) * half;
  ships[at + VELOCITY + 1] = uy + (ay + (py - h * q[NORMAL + 1]!)) * half;
  ships[at + VELOCITY + 2] = uz + (az + (pz - h * q[NORMAL + 2]!)) * half;
}

/** Exchanges POSITION and START_POSITION: later reads of the ship see the other end of the substep. */
export function swapPositions(): void {
  const q = quantities;
  const { ships, at } = step;
  for (let k = 0; k < 3; k++) {
    const other = q[START_POSITION + k]!;
    q[START_POSITION + k] = ships[at + POSITION + k]!;
    ships[at + POSITION + k] = other;
  }
}
