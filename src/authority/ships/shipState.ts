import {
  landedBodyName,
  type LoadedShipClass,
  readControls,
  readShip,
  readBodyMotion,
  BODY_STRIDE,
  type ShipRecord,
  type World,
} from '../../dynamics';
import type { BodyState, ShipState } from '../../wire';
import { add } from './rotation';

/** A ship's names; its row holds the rest. */
export interface ShipIdentity {
  readonly shipId: string;
  readonly playerId: string;
  readonly name: string;
}

/** A ship's row and its bodies, at a tick boundary. */
export interface ShipPlace {
  readonly ships: Float64Array;
  readonly at: number;
  readonly bodies: Float64Array;
  readonly world: World;
}

/**
 * Converts a row to a ShipState (PREDICTION, Server messages): ICRF position and velocity are computed only here, from
 * the state relative to the reference body (DYNAMICS, Frame). `legacy` omits fields that the game's own server does not send.
 */
export function toShipState(place: ShipPlace, identity: ShipIdentity, legacy = false): ShipState {
  const { ships, at, bodies, world } = place;
  const ship = readShip(ships, at, world);
  const index = world.bodies.findIndex((body) => body.name === ship.referenceBody);
  const motion = readBodyMotion(bodies, index * BODY_STRIDE);
  return {
    shipId: identity.shipId,
    playerId: identity.playerId,
    name: identity.name,
    shipClass: ship.shipClass,
    position: add(motion.position, ship.relativePosition),
    velocity: add(motion.velocity, ship.relativeVelocity),
    attitude: ship.attitude,
    angularVelocity: ship.angularVelocity,
    ...readControls(ships, at),
    fuel: ship.fuel,
    mass: classOf(ship, world).dryMass + ship.fuel,
    wheelMomentum: legacy ? null : ship.wheelMomentum,
    groundContactOffset: legacy ? null : ship.groundContactOffset,
    landedBodyName: landedBodyName(ship),
    surfaceContactState: ship.surfaceContactState,
    contactImpactSpeed: legacy ? null : ship.contactImpactSpeed,
    referenceBody: legacy ? '' : ship.referenceBody,
    relativePosition: legacy ? null : ship.relativePosition,
    relativeVelocity: legacy ? null : ship.relativeVelocity,
    crashed: ship.crashed,
  };
}

/** The bodies of `world` as plain records. */
export function toBodyStates(bodies: Float64Array, world: World): BodyState[] {
  return world.bodies.map(({ name, mass, radius }, i) => ({
    name,
    mass,
    radius,
    ...readBodyMotion(bodies, i * BODY_STRIDE),
  }));
}

function classOf(ship: ShipRecord, world: World): LoadedShipClass {
  return world.shipClasses.find((candidate) => candidate.name === ship.shipClass)!;
}
