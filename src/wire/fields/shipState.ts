import { controlFields, readStateControls } from './controls';
import type { galaxy } from '../generated/codec.js';
import {
  IMPACT_SPEED,
  METRES,
  METRES_PER_SECOND,
  NEWTON_METRE_SECONDS,
  RADIANS_PER_SECOND,
  SHIP_HEIGHT,
  SHIP_MASS,
} from '../limits';
import { type Fields, flagIn, nameIn, numberIn, type Reading, textIn, valueIn } from './reading';
import type { ShipState } from '../records';
import { optionalVectorIn, quaternionFields, quaternionIn, vectorFields, vectorIn } from './vectors';

/**
 * The game's ShipState, from protobuf or JSON. Many servers do not send the fields 30 to 35
 * (PREDICTION, Server messages): the predictor interprets them together, not this reader.
 */
export function readShipState(r: Reading, from: Fields): ShipState {
  const relativePosition = optionalVectorIn(r, from, 'relative_position', METRES);
  const relativeVelocity = optionalVectorIn(r, from, 'relative_velocity', METRES_PER_SECOND);
  const impactSpeed = numberIn(r, from, 'contact_impact_speed', IMPACT_SPEED, 0);
  // Protobuf does not distinguish 0 from not sent; a server that sends 33 and 34 sends 31 too.
  const sendsImpactSpeed = impactSpeed !== 0 || relativePosition !== null || relativeVelocity !== null;
  return {
    shipId: nameIn(r, from, 'ship_id'),
    playerId: textIn(r, from, 'player_id'),
    name: textIn(r, from, 'name'),
    shipClass: textIn(r, from, 'ship_class'),
    position: vectorIn(r, from, 'position', METRES),
    velocity: vectorIn(r, from, 'velocity', METRES_PER_SECOND),
    attitude: quaternionIn(r, from, 'attitude'),
    angularVelocity: vectorIn(r, from, 'angular_velocity', RADIANS_PER_SECOND),
    ...readStateControls(r, from),
    fuel: numberIn(r, from, 'fuel', SHIP_MASS),
    mass: numberIn(r, from, 'mass', SHIP_MASS, 0),
    wheelMomentum: optionalVectorIn(r, from, 'wheel_momentum', NEWTON_METRE_SECONDS),
    groundContactOffset:
      valueIn(r, from, 'ground_contact_offset') === undefined
        ? null
        : numberIn(r, from, 'ground_contact_offset', SHIP_HEIGHT),
    landedBodyName: textIn(r, from, 'landed_body_name'),
    surfaceContactState: textIn(r, from, 'surface_contact_state'),
    contactImpactSpeed: sendsImpactSpeed ? impactSpeed : null,
    referenceBody: textIn(r, from, 'reference_body'),
    relativePosition,
    relativeVelocity,
    crashed: flagIn(r, from, 'crashed'),
  };
}

/** Members that are null are omitted. */
export function shipStateFields(state: ShipState): galaxy.physics.ShipState.$Properties {
  const { contactImpactSpeed, relativePosition, relativeVelocity } = state;
  return {
    ship_id: state.shipId,
    player_id: state.playerId,
    name: state.name,
    ship_class: state.shipClass,
    position: vectorFields(state.position),
    velocity: vectorFields(state.velocity),
    attitude: quaternionFields(state.attitude),
    angular_velocity: vectorFields(state.angularVelocity),
    ...controlFields(state),
    fuel: state.fuel,
    mass: state.mass,
    ...(state.wheelMomentum !== null && { wheel_momentum: vectorFields(state.wheelMomentum) }),
    ...(state.groundContactOffset !== null && { ground_contact_offset: state.groundContactOffset }),
    landed_body_name: state.landedBodyName,
    surface_contact_state: state.surfaceContactState,
    ...(contactImpactSpeed !== null && { contact_impact_speed: contactImpactSpeed }),
    reference_body: state.referenceBody,
    ...(relativePosition !== null && { relative_position: vectorFields(relativePosition) }),
    ...(relativeVelocity !== null && { relative_velocity: vectorFields(relativeVelocity) }),
    crashed: state.crashed,
  };
}
