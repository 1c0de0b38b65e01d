import { POSITION, VELOCITY } from './layout';
import {
  DT,
  END,
  GRAVITY,
  MASS,
  NORMAL,
  quantities as q,
  SMI_MASK,
  START,
  type Step,
  THRUST,
} from './quantities';
import { readPlace } from './surface';

/** Step 5 in the air: velocity Verlet under gravity and thrust. Leaves the place at END read. */
export function fly(step: Step): void {
  const { ships } = step;
  const at = step.at & SMI_MASK;
  const dt = q[DT]!;
  const half = 0.5 * dt;
  const halfSquared = half * dt;
  const perMass = 1 / q[MASS]!;
  const g = q[START + GRAVITY]!;
  const px = q[THRUST]! * perMass;
  const py = q[THRUST + 1]! * perMass;
  const pz = q[THRUST + 2]! * perMass;
  const ax = px - g * q[START + NORMAL]!;
  const ay = py - g * q[START + NORMAL + 1]!;
  const az = pz - g * q[START + NORMAL + 2]!;
  const ux = ships[at + VELOCITY]!;
  const uy = ships[at + VELOCITY + 1]!;
  const uz = ships[at + VELOCITY + 2]!;
  ships[at + POSITION] = ships[at + POSITION]! + (ux * dt + ax * halfSquared);
  ships[at + POSITION + 1] = ships[at + POSITION + 1]! + (uy * dt + ay * halfSquared);
  ships[at + POSITION + 2] = ships[at + POSITION + 2]! + (uz * dt + az * halfSquared);
  readPlace(END, step);
  const h = q[END + GRAVITY]!;
  ships[at + VELOCITY] = ux + (ax + (px - h * q[END + NORMAL]!)) * half;
  ships[at + VELOCITY + 1] = uy + (ay + (py - h * q[END + NORMAL + 1]!)) * half;
  ships[at + VELOCITY + 2] = uz + (az + (pz - h * q[END + NORMAL + 2]!)) * half;
}
