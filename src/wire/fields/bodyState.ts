import { loadBody } from '../../dynamics';
import type { galaxy } from '../generated/codec.js';
import { BODY_MASS, METRES, METRES_PER_SECOND, RADIANS_PER_SECOND } from '../limits';
import { refuseLoaded } from '../loaders';
import { type Fields, nameIn, numberIn, type Reading } from './reading';
import type { BodyState } from '../records';
import { quaternionFields, quaternionIn, vectorFields, vectorIn } from './vectors';

/** A body with its motion; its constants are checked as in DYNAMICS, Ranges. */
export function readBodyState(r: Reading, from: Fields): BodyState {
  const body: BodyState = {
    name: nameIn(r, from, 'name'),
    mass: numberIn(r, from, 'mass', BODY_MASS),
    radius: numberIn(r, from, 'radius', METRES),
    position: vectorIn(r, from, 'position', METRES),
    velocity: vectorIn(r, from, 'velocity', METRES_PER_SECOND),
    attitude: quaternionIn(r, from, 'attitude'),
    angularVelocity: vectorIn(r, from, 'angular_velocity', RADIANS_PER_SECOND),
  };
  refuseLoaded(r, loadBody(body), `body ${body.name}: `);
  return body;
}

export function bodyStateFields(body: BodyState): galaxy.physics.BodyState.$Properties {
  return {
    name: body.name,
    mass: body.mass,
    radius: body.radius,
    position: vectorFields(body.position),
    velocity: vectorFields(body.velocity),
    attitude: quaternionFields(body.attitude),
    angular_velocity: vectorFields(body.angularVelocity),
  };
}
