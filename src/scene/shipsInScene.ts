import type { Vector3 } from 'three';
import type { ShipView, WorldView } from '../prediction';
import { raiseDust } from './effects/dustSources';
import { frameOf, type SceneState } from './sceneState';
import { poseActors } from './ships/actors';
import { placeJets, type ShipActor } from './ships/shipActor';
import { coneMeets } from './camera/viewCone';

/** A crash raises as much dust as a touch at this speed, m/s. */
const CRASH_SPEED = 50;
/** No ship is larger than this around its centre of mass, m. */
const SHIP_REACH = 30;
/** With more ships than this only the player’s raises dust. */
const MAX_DUSTY = 12;

/** Poses the ships near the watched one's body and starts their dust and crashes. `seconds` since the last picture. */
export function poseShips(state: SceneState, view: WorldView, watched: ShipView, seconds: number): void {
  const { parts, turn } = state;
  const { jets, shipResources } = parts;
  const place = { frame: frameOf(state), turn, jets, shipResources, inAir: state.look.air !== null };
  const isFew = view.ships.length < MAX_DUSTY;
  poseActors(state.actors, view, watched.body, place, (actor, ship) => {
    actor.isTranslucent = state.translucent.has(ship.shipId);
    if (actor.isTranslucent) {
      actor.jets.visible = false;
      return;
    }
    if (ship.own || isFew) raise(state, actor, ship, seconds);
    const isWreck = ship.shownState === 'crashed';
    // A ship first seen as a wreck crashed earlier.
    if (isWreck && !actor.wasWreck && actor.posed > 1)
      parts.crash.begin(actor.place, 2 * actor.height, state.groundY);
    actor.wasWreck = isWreck;
  });
}

function raise(state: SceneState, actor: ShipActor, ship: ShipView, seconds: number): void {
  const { place, velocity, blows } = actor;
  raiseDust(
    state.parts.dust,
    actor.dust,
    {
      place,
      velocity,
      blows,
      groundY: state.groundY(place[0]!, place[2]!),
      feetHeight: 0,
      legRadius: ship.shipClass.legRadius,
      grounded: ship.surfaceContactState !== '' || ship.crashed,
      impactSpeed: ship.crashed ? CRASH_SPEED : ship.impactSpeed,
      thrust: ship.crashed ? 0 : ship.shipClass.mainEngineThrust * ship.controls.thrustLevel,
    },
    seconds,
  );
}

/** Hulls and jets of the ships in sight, and the shadows of those that the shadow map does not reach. */
export function placeShips(state: SceneState, watched: ShipActor): void {
  const { hulls, shadows, translucent, ground } = state.parts;
  const { eye } = state.rig;
  hulls.clear();
  shadows.clear();
  translucent.clear();
  for (const actor of state.actors.byId.values()) {
    const { place } = actor;
    const isWatched = actor === watched;
    if (actor.isTranslucent) translucent.put(actor, eye);
    else if (isWatched || coneMeets(state.cone, place[0]!, place[2]!, SHIP_REACH)) {
      actor.sunlit = sunlitShare(place[1]! - ground.shadowY(place[0]!, place[2]!), actor.height);
      hulls.put(actor, eye, isWatched);
      if (!isWatched && actor.sunlit > 0) throwShadow(state, actor);
    }
    if (actor.jets.visible) placeJets(actor, eye);
  }
  hulls.finish();
  shadows.finish();
}

/** Share of the sun that reaches a ship whose centre of mass is `over` m above the terrain's shadow, 0 … 1. */
function sunlitShare(over: number, height: number): number {
  return Math.min(Math.max(0.5 + over / (2 * height), 0), 1);
}

/** m: between the points that a shadow's slope is taken from. */
const SLOPE_SPAN = 4;
/** m: a ship that has moved by less keeps its shadow. The slope under it is computed less often. */
const SHADOW_STEP = 0.03;
const SLOPE_STEP = 1.5;

function throwShadow({ parts, rig, groundY }: SceneState, { place, height, shadow }: ShipActor): void {
  if (!isWithin(SHADOW_STEP, shadow.from, place)) {
    shadow.from.set(place);
    findShadow(shadow.at, place, parts.light.direction, groundY);
  }
  if (!isWithin(SLOPE_STEP, shadow.slopeFrom, place)) {
    shadow.slopeFrom.set(place);
    findNormal(shadow.normal, shadow.at, groundY);
  }
  parts.shadows.put(place, shadow.at, shadow.normal, rig.eye, height);
}

/** False for a position that was never set (NaN). */
function isWithin(distance: number, from: Float64Array, to: Float64Array): boolean {
  const x = to[0]! - from[0]!;
  const y = to[1]! - from[1]!;
  const z = to[2]! - from[2]!;
  return x * x + y * y + z * z < distance * distance;
}

/** Down-sun from the ship to the ground: two steps find it well enough on anything but a cliff. */
function findShadow(out: Vector3, place: Float64Array, sun: Vector3, groundY: SceneState['groundY']): void {
  let x = place[0]!;
  let z = place[2]!;
  for (let n = 0; n < 2; n++) {
    const way = (place[1]! - groundY(x, z)) / Math.max(sun.y, 0.05);
    x = place[0]! - sun.x * way;
    z = place[2]! - sun.z * way;
  }
  out.set(x, groundY(x, z), z);
}

function findNormal(out: Vector3, { x, z }: Vector3, groundY: SceneState['groundY']): void {
  const riseX = groundY(x + SLOPE_SPAN, z) - groundY(x - SLOPE_SPAN, z);
  const riseZ = groundY(x, z + SLOPE_SPAN) - groundY(x, z - SLOPE_SPAN);
  out.set(-riseX / (2 * SLOPE_SPAN), 1, -riseZ / (2 * SLOPE_SPAN)).normalize();
}
