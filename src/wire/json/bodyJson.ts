import { type Body, type BodyMotion, loadBody } from '../../dynamics';
import { BODY_MASS, METRES, METRES_PER_SECOND, RADIANS_PER_SECOND } from '../limits';
import { refuseLoaded } from '../loaders';
import { type Fields, nameIn, numberIn, type Reading, refuse } from '../fields/reading';
import type { BodyState } from '../records';
import { optionalQuaternionIn, optionalVectorIn, vectorIn } from '../fields/vectors';
import type { SpinReader } from './spin';

/** Values for absent members of a body. */
export interface BodyDefaults {
  /** Bodies by name, for mass, radius, attitude and spin. */
  readonly known: readonly (Body & BodyMotion)[];
  /** Game time of the message, s, which gives the rotation of a body with axis and period. */
  readonly time: number;
  /** Without, axis and period are ignored. */
  readonly spins?: SpinReader;
}

/**
 * A body. Without attitude or angular_velocity they are those of `spin_axis` (unit, ICRF) and `rotation_period`
 * (sidereal s, negative = retrograde); without these, the known body's of that name.
 */
export function readBodyJson(r: Reading, from: Fields, { known, time, spins }: BodyDefaults): BodyState {
  const name = nameIn(r, from, 'name');
  const own = known.find((body) => body.name === name);
  const spin = spins?.read(r, from, time);
  const attitude = optionalQuaternionIn(r, from, 'attitude') ?? spin?.attitude ?? own?.attitude;
  const angularVelocity =
    optionalVectorIn(r, from, 'angular_velocity', RADIANS_PER_SECOND) ??
    spin?.angularVelocity ??
    own?.angularVelocity;
  const missing = spins?.missing ?? 'missing';
  if (attitude === undefined) refuse(r, 'attitude', missing);
  if (angularVelocity === undefined) refuse(r, 'angular_velocity', missing);
  const body: BodyState = {
    name,
    mass: numberIn(r, from, 'mass', BODY_MASS, own?.mass),
    radius: numberIn(r, from, 'radius', METRES, own?.radius),
    position: vectorIn(r, from, 'position', METRES),
    velocity: vectorIn(r, from, 'velocity', METRES_PER_SECOND),
    attitude: attitude ?? [0, 0, 0, 1],
    angularVelocity: angularVelocity ?? [0, 0, 0],
  };
  refuseLoaded(r, loadBody(body), `body ${body.name}: `);
  return body;
}
