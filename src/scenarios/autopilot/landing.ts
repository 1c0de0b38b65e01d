import { ok, type Result, type Controls, DEFAULT_SETTINGS, err, NEUTRAL_CONTROLS } from '../../dynamics';
import type { ShipState } from '../../wire';
import { approachOf, descend, type LandingSite } from './descent';
import { planTravel } from './travel';

/** Phases of a landing; it ends in 'complete' or 'failed'. */
export type LandingPhase = 'descent' | 'touchdown' | 'complete' | 'failed';

/** A landing in progress as plain data: keep it, and pass it back with the next state. */
export interface LandingManeuver {
  readonly phase: LandingPhase;
  /** The reason of a failure; otherwise empty. */
  readonly reason: string;
  /** Controls until the next state. */
  readonly controls: Controls;
}

/** A landing before its first state. */
export const BEGIN_LANDING: LandingManeuver = Object.freeze<LandingManeuver>({
  phase: 'descent',
  reason: '',
  controls: NEUTRAL_CONTROLS,
});

/** In contact the engine is off and rates are damped; legs, friction and gravity do the rest. */
const HOLD: Controls = Object.freeze<Controls>({ ...NEUTRAL_CONTROLS, attitudeHold: true });

/** m: the autopilot does not fly hops below this height; even on Earth the ship comes down below the bounce speed. */
const LOW_HOP = 3;

/** m: a ship on the ground takes off if the plan at its place is higher than this, as ten metres from its target. */
const BESIDE = 4;

/**
 * The game's maneuver_landing for ships that have legs, a pure step from one ship state to the next: descends, takes contact for
 * the touchdown (engine off, hold), completes on landed, fails with a reason on tipped or crashed. A high
 * bounce is flown like the descent. With `site.target` the ship is carried there first, from the ground too. At 1 Hz the feet touch below 3 m/s from any attitude and spin if `site.delay` is given
 * and the height is enough to turn upright and brake: 200 m over the Moon, Mars and Phobos; over Earth an upside-down
 * lander needs 400 m at 10 Hz, and 600 m at 1 Hz with controls a tick late. With less, or too small a delay, the ship hits the ground: the
 * maneuver fails and gives the crash or the impact speed as its reason. A bounce between two states, or of a server that sends no
 * impact speed, is not seen: the maneuver then continues from it.
 * @returns the maneuver to keep and its controls; or an error that names the invalid field of the state, and `before` stays valid
 */
export function continueLanding(
  before: LandingManeuver,
  ship: ShipState,
  site: LandingSite,
): Result<LandingManeuver> {
  if (before.phase === 'complete' || before.phase === 'failed') return ok(before);
  if (ship.crashed) return ok(failed(`crashed on ${site.body.name}`));
  switch (ship.surfaceContactState) {
    case 'tipped':
      return ok(failed(`tipped over on ${site.body.name}`));
    case 'landed':
      if (before.phase === 'descent' && isBeside(ship, site)) return fly(before, ship, site);
      return ok({ phase: 'complete', reason: '', controls: NEUTRAL_CONTROLS });
    case 'contact':
      return ok(touchdown(ship, site));
    case '':
      return fly(before, ship, site);
    default:
      return err(`surfaceContactState: no state named ${ship.surfaceContactState}`);
  }
}

function fly(before: LandingManeuver, ship: ShipState, site: LandingSite): Result<LandingManeuver> {
  const approach = approachOf(ship, site);
  if (!approach.ok) return approach;
  if (before.phase === 'touchdown' && approach.value.height < LOW_HOP)
    return ok({ phase: 'touchdown', reason: '', controls: HOLD });
  const thrust = site.shipClass.mainEngineThrust;
  const weight = ship.mass * approach.value.gravity;
  if (!(thrust > weight))
    return ok(failed(`mainEngineThrust: ${thrust} N cannot hold a weight of ${Math.round(weight)} N`));
  const controls = descend(approach.value, ship.mass, site.shipClass);
  return ok({ phase: 'descent', reason: '', controls });
}

/** Whether a ship on the ground takes off again to land at the target. */
function isBeside(ship: ShipState, site: LandingSite): boolean {
  const approach = approachOf(ship, site);
  return approach.ok && planTravel(approach.value, ship.mass, site.shipClass).hold > BESIDE;
}

function touchdown({ contactImpactSpeed }: ShipState, site: LandingSite) {
  const { body, bounceSpeed = DEFAULT_SETTINGS.contactBounceSpeed } = site;
  const speed = contactImpactSpeed ?? 0;
  if (speed > bounceSpeed) return failed(`hit ${body.name} at ${speed.toFixed(1)} m/s`);
  return { phase: 'touchdown', reason: '', controls: HOLD } as const;
}

function failed(reason: string): LandingManeuver {
  return { phase: 'failed', reason, controls: HOLD };
}
