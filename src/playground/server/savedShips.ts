import { add, compose, cross, inverse, rotate } from '../../authority';
import { err, ok, type Result, type ShipInit, type SurfaceState, type Vec3 } from '../../dynamics';
import type { BodyState, ServerFrame, ShipState } from '../../wire';

/** A ship's state in the axes of its body, which turns: it can be put back over the same ground later. */
export interface SavedShip {
  readonly shipId: string;
  readonly state: ShipInit;
}

/** All ships of a frame as they are now; a reason where the frame lacks what is needed (the legacy protocol). */
export function saveShips(frame: ServerFrame): Result<readonly SavedShip[]> {
  const saved: SavedShip[] = [];
  for (const ship of frame.ships) {
    const body = frame.bodies.find(({ name }) => name === ship.referenceBody);
    if (body === undefined || ship.relativePosition === null || ship.relativeVelocity === null)
      return err('the legacy protocol does not send complete states');
    const toBody = inverse(body.attitude);
    saved.push({
      shipId: ship.shipId,
      state: {
        ...stateOf(ship, ship.relativePosition, ship.relativeVelocity),
        relativePosition: rotate(toBody, ship.relativePosition),
        relativeVelocity: rotate(toBody, ship.relativeVelocity),
        attitude: compose(toBody, ship.attitude),
        angularVelocity: rotate(toBody, ship.angularVelocity),
      },
    });
  }
  return ok(saved);
}

function stateOf(ship: ShipState, relativePosition: Vec3, relativeVelocity: Vec3): ShipInit {
  return {
    shipClass: ship.shipClass,
    referenceBody: ship.referenceBody,
    relativePosition,
    relativeVelocity,
    attitude: ship.attitude,
    angularVelocity: ship.angularVelocity,
    fuel: ship.fuel,
    surfaceContactState: ship.surfaceContactState as SurfaceState,
    contactImpactSpeed: ship.contactImpactSpeed ?? 0,
    crashed: ship.crashed,
  };
}

/** The saved state over the same ground, as the body is turned now. */
export function stateNow({ state }: SavedShip, { attitude }: BodyState): ShipInit {
  return {
    ...state,
    relativePosition: rotate(attitude, state.relativePosition),
    relativeVelocity: rotate(attitude, state.relativeVelocity),
    attitude: compose(attitude, state.attitude),
    angularVelocity: rotate(attitude, state.angularVelocity),
  };
}

/** The saved ship displaced by `offset` (ICRF axes, m), at rest over the ground and in flight: it falls from there. */
export function movedTo(saved: SavedShip, body: BodyState, offset: Vec3): ShipInit {
  const state = stateNow(saved, body);
  const relativePosition = add(state.relativePosition, offset);
  return {
    ...state,
    relativePosition,
    relativeVelocity: cross(body.angularVelocity, relativePosition),
    angularVelocity: body.angularVelocity,
    surfaceContactState: '',
    contactImpactSpeed: 0,
    crashed: false,
  };
}
