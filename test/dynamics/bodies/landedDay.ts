/**
 * A ship landed on each body for a sidereal day of Earth, 8.6 million substeps. Run as a bundle (test/run.mjs), twenty times faster
 * than module by module; prints one LandedDay per body as JSON.
 */
import {
  ATTITUDE,
  BODIES,
  BODY_ANGULAR_VELOCITY,
  BODY_ATTITUDE,
  FUEL,
  type Quat,
  SURFACE_STATE,
} from '../../../src/dynamics';
import { createTrial, onTheBody, quaternionAt, run, type Trial, vectorAt } from '../provingGround';
import { angleBetween, conjugate, lengthOf, plus, product, turnAbout, unit } from '../vectors';

export interface LandedDay {
  readonly body: string;
  readonly state: number;
  /** Distance from its initial position, body's axes, m. */
  readonly moved: number;
  /** Change of its attitude in the body's axes, rad. */
  readonly turned: number;
  /** kg */
  readonly burnt: number;
  /** Difference of the body's attitude from a rotation by Ω t, rad. */
  readonly bodyMissed: number;
}

const DAY = 86164;

function leaning({ bodies, ships }: Trial): Quat {
  return product(conjugate(quaternionAt(bodies, BODY_ATTITUDE)), quaternionAt(ships, ATTITUDE));
}

const days = BODIES.map((body): LandedDay => {
  const trial = createTrial({ body, tilt: 3, state: 'landed' });
  const place = onTheBody(trial);
  const lean = leaning(trial);
  const before = quaternionAt(trial.bodies, BODY_ATTITUDE);
  const fuel = trial.ships[FUEL]!;
  run(trial, DAY);
  const spin = vectorAt(trial.bodies, BODY_ANGULAR_VELOCITY);
  const turn = product(quaternionAt(trial.bodies, BODY_ATTITUDE), conjugate(before));
  return {
    body: body.name,
    state: trial.ships[SURFACE_STATE]!,
    moved: lengthOf(plus(onTheBody(trial), place, -1)),
    turned: angleBetween(leaning(trial), lean),
    burnt: fuel - trial.ships[FUEL]!,
    bodyMissed: angleBetween(turn, turnAbout(unit(spin), lengthOf(spin) * DAY)),
  };
});
console.log(JSON.stringify(days));
