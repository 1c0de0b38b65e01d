import { type Controls, NEUTRAL_CONTROLS, ok, type Result, type Vec3 } from '../../dynamics';
import type { ShipState } from '../../wire';
import { approachOf, type LandingSite } from './descent';
import { dot } from '../vectors';

/** m/s along the ground: the main engine brakes from the first down to the second; thrusters take a minute for as much. */
const FAST = 8;
const SLOW = 2;
/** m/s² beyond gravity. */
const BRAKING = 3;
/** s to turn against the motion, and as long to turn upright again. */
const TURNING = 5;
/** m that are left for the descent. */
const RESERVE = 50;
/** Cosine of the angle between thrust and motion up to which the engine burns. */
const ALIGNED = 0.9;

/**
 * Controls that brake a fast drift by the main engine, against the motion over the ground; null where the thrusters of the vertical
 * descent suffice, or the height does not.
 * @param isBraking whether these controls acted before
 * @returns an error that names the invalid field of the state
 */
export function brakeDrift(isBraking: boolean, ship: ShipState, site: LandingSite): Result<Controls | null> {
  const approach = approachOf(ship, site);
  if (!approach.ok) return approach;
  const { height, climb, drift, away, gravity, retrograde } = approach.value;
  const speed = Math.hypot(...drift);
  if (speed < (isBraking ? SLOW : FAST)) return ok(null);
  const thrust = Math.min(site.shipClass.mainEngineThrust / ship.mass, gravity + BRAKING);
  if (thrust <= gravity) return ok(null);
  // Against the motion the thrust holds the descent at about its present speed.
  const lost = TURNING * gravity * TURNING - climb * (speed / BRAKING + 2 * TURNING);
  if (height < (isBraking ? 0 : lost) + RESERVE) return ok(null);
  if (!isBraking && away !== null && height > lost + 2 * RESERVE && canWait(speed, drift, away))
    return ok(null);
  return ok({
    ...NEUTRAL_CONTROLS,
    thrustLevel: retrograde > ALIGNED ? (ship.mass * thrust) / site.shipClass.mainEngineThrust : 0,
    attitudeHold: true,
    attitudeMode: 'surface_retrograde',
  });
}

/** Whether a ship that flies towards its target at `speed` along the ground would stop before it. */
function canWait(speed: number, drift: Vec3, away: Vec3): boolean {
  const distance = Math.hypot(...away);
  const towards = dot(drift, away);
  const toStop = speed * TURNING + (speed * speed) / (2 * BRAKING);
  return distance > toStop && towards > ALIGNED * speed * distance;
}
