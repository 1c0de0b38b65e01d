import type { Quat, Vec3 } from '../../../src/dynamics';
import type { ContactOptions, LiteralBody, LiteralShip } from './contactStep';
import { conjugate, cross, length, minus, multiply, plus, rotate, rotationBy, scale } from './vectors';

/** Controller and torque, I w' = τ, then the attitude. */
export function turn(
  ship: LiteralShip,
  body: LiteralBody,
  { gain, massFactor }: ContactOptions,
  { dt, torque }: { readonly dt: number; readonly torque: Vec3 },
): void {
  const { shipClass, attitude } = ship;
  const [ix, iy, iz] = shipClass.inertiaTensor.map((row, k) => row[k]! * massFactor) as [
    number,
    number,
    number,
  ];
  const toBody = (v: Vec3) => rotate(conjugate(ship.attitude), v);
  const asked = askedTorque(ship, body, gain);
  const outer = toBody(torque);
  const alpha: Vec3 = [(asked[0] + outer[0]) / ix, (asked[1] + outer[1]) / iy, (asked[2] + outer[2]) / iz];
  ship.angularVelocity = plus(ship.angularVelocity, scale(rotate(attitude, alpha), dt));
  ship.attitude = multiply(rotationBy(scale(ship.angularVelocity, dt)), attitude);
  const size = Math.hypot(...ship.attitude);
  ship.attitude = ship.attitude.map((x) => x / size) as unknown as Quat;
}

/** The game's critically damped PD, N m in body axes. */
function askedTorque(ship: LiteralShip, body: LiteralBody, gain: number): Vec3 {
  const { controls, shipClass } = ship;
  const most = [0, 1, 2].map((k) => shipClass.rcsTorque[k]! + shipClass.reactionWheelTorque[k]!);
  const stick = controls.rotationInput;
  const grounded = ship.state === 'contact' || ship.state === 'tipped';
  if (stick.some((x) => x !== 0)) return stick.map((x, k) => x * most[k]!) as unknown as Vec3;
  const mode = controls.attitudeMode;
  if (mode === 'none' && !controls.attitudeHold) return [0, 0, 0];
  const toBody = (v: Vec3) => rotate(conjugate(ship.attitude), v);
  const w = toBody(ship.angularVelocity);
  const omega = gain * shipClass.attitudeNaturalFrequency;
  let error: Vec3 = [0, 0, 0];
  if (mode === 'radial' && !grounded) {
    const r = minus(ship.position, body.position);
    error = cross([0, 0, 1], toBody(scale(r, 1 / length(r))));
  }
  return [0, 1, 2].map((k) => {
    const wish = shipClass.inertiaTensor[k]![k]! * (omega * omega * error[k]! - 2 * omega * w[k]!);
    return Math.max(-most[k]!, Math.min(most[k]!, wish));
  }) as unknown as Vec3;
}
