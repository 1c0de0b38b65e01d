import { POSITION, VELOCITY } from '../state/layout';
import { DT, end, GRAVITY, MASS, NORMAL, quantities, start, type Step, THRUST } from './quantities';
import { readPlace } from './surface';

/** Step 5 in flight: velocity Verlet under gravity and thrust. Also fills the position columns of `end`. */
export function fly(step: Step): void {
  const q = quantities;
  const dt = q[DT]!;
  const half = 0.5 * dt;
  const halfSquared = half * dt;
  const perMass = 1 / q[MASS]!;
  const g = start[GRAVITY]!;
  const px = q[THRUST]! * perMass;
  const py = q[THRUST + 1]! * perMass;
  const pz = q[THRUST + 2]! * perMass;
  const ax = px - g * start[NORMAL]!;
  const ay = py - g * start[NORMAL + 1]!;
  const az = pz - g * start[NORMAL + 2]!;
  const ux = q[VELOCITY]!;
  const uy = q[VELOCITY + 1]!;
  const uz = q[VELOCITY + 2]!;
  q[POSITION] = q[POSITION]! + (ux * dt + ax * halfSquared);
  q[POSITION + 1] = q[POSITION + 1]! + (uy * dt + ay * halfSquared);
  q[POSITION + 2] = q[POSITION + 2]! + (uz * dt + az * halfSquared);
  readPlace(end, step);
  const h = end[GRAVITY]!;
  q[VELOCITY] = ux + (ax + (px - h * end[NORMAL]!)) * half;
  q[VELOCITY + 1] = uy + (ay + (py - h * end[NORMAL + 1]!)) * half;
  q[VELOCITY + 2] = uz + (az + (pz - h * end[NORMAL + 2]!)) * half;
}
