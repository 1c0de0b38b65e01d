import type { ShipClass, Vec3 } from '../../dynamics';
import { minus, scaled } from '../vectors';

/** m/s along the ground to a target, at most: the thrusters stop the ship from it in half a minute. */
const CARRY_SPEED = 6;
/** s⁻¹: wanted speed along the ground per metre from the target; slower than RESPONSE, so that the ship does not swing past it. */
const APPROACH_RATE = 0.15;
/** m/s²: with weaker thrusters a ship lands where it is. */
const LEAST_ACCELERATION = 0.02;
/** The descent to a target: height per metre from it beyond the first few, and at most. */
const GLIDE = 0.5;
const NEAR = 2;
const CLEARANCE = 25;
/** s: height per m/s of speed beyond the thrusters' authority, in which the main engine can be turned against it. */
const TURNING_HEIGHT = 8;
/** m/s along the ground that a landing at a target may have, and s: each m/s more counts as a way of so many seconds. */
const SLOW_DRIFT = 0.4;
const DRIFT_SECONDS = 6;

/** Motion along the ground, body axes. */
interface Along {
  /** m/s */
  readonly drift: Vec3;
  /** To the target, m; null without one. */
  readonly away: Vec3 | null;
}

/** The way to the target along the ground. */
export interface Travel {
  /** Velocity along the ground less the wanted one, body axes, m/s. */
  readonly error: Vec3;
  /** m above the ground that the ship keeps until it is over the target. */
  readonly hold: number;
}

/** The way of a ship of `mass` kg; without a target, and for a ship without thrusters, only the drift to cancel. */
export function planTravel({ drift, away }: Along, mass: number, { rcsThrust }: ShipClass): Travel {
  const acceleration = Math.min(rcsThrust[0], rcsThrust[1]) / mass;
  // With weaker thrusters it would wait for ever.
  if (away === null || acceleration < LEAST_ACCELERATION) return { error: drift, hold: 0 };
  const distance = Math.hypot(...away);
  const speed = Math.min(CARRY_SPEED, APPROACH_RATE * distance, Math.sqrt(acceleration * distance));
  const share = distance > 0 ? speed / distance : 0;
  const error = minus(drift, scaled(away, share));
  const drifting = Math.hypot(...drift);
  const left = Math.max(distance - NEAR, 0) + DRIFT_SECONDS * Math.max(drifting - SLOW_DRIFT, 0);
  const most = CLEARANCE + TURNING_HEIGHT * Math.max(drifting - CARRY_SPEED, 0);
  return { error, hold: Math.min(GLIDE * left, most) };
}
