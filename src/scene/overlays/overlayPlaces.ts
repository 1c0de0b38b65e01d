import { quat } from 'gl-matrix';
import { Quaternion, Vector3 } from 'three';
import { GRAVITATIONAL_CONSTANT } from '../../dynamics';
import type { ShipView, WorldView } from '../../prediction';
import { type LocalFrame, rotate, type Turn } from '../localFrame';
import type { OverlayChoice, OverlayPlaces } from './overlays';
import type { ShipActor } from '../ships/shipActor';

/** Everything of a frame that the overlays depend on. */
export interface OverlayScene {
  readonly view: WorldView;
  readonly ship: ShipView;
  readonly actor: ShipActor;
  readonly frame: LocalFrame;
  readonly turn: Turn;
  /** Local, m. */
  readonly eye: Float64Array;
  readonly groundY: (x: number, z: number) => number;
}

type Places = { -readonly [Name in keyof OverlayPlaces]: OverlayPlaces[Name] };

const point = new Float64Array(3);
const attitude = new Float64Array(4);

/** Writes the places of this frame's overlays, relative to the eye. */
export function placeOverlays(out: Places, scene: OverlayScene): void {
  const { view, ship, actor, frame, turn, eye, groundY } = scene;
  const { place } = actor;
  out.ship.set(place[0]! - eye[0]!, place[1]! - eye[1]!, place[2]! - eye[2]!);
  out.ghostKnown = ship.serverKnown;
  rotate(point, frame.axes, ship.ghostPosition);
  out.ghost.set(point[0]! - eye[0]!, point[1]! - frame.radius - eye[1]!, point[2]! - eye[2]!);
  quat.multiply(attitude, view.bodies[ship.body]!.attitude, ship.ghostAttitude);
  quat.multiply(attitude, turn.quaternion, attitude);
  out.ghostTurn.set(attitude[0]!, attitude[1]!, attitude[2]!, attitude[3]!);
  const raised = ship.shipClass.groundContactOffset - ship.groundContactOffset;
  out.ghost.addScaledVector(way.set(0, 0, 1).applyQuaternion(out.ghostTurn), raised);
  for (let k = 0; k < 3; k++) point[k] = ship.position[k]! - ship.easedPosition[k]!;
  rotate(point, turn.matrix, point);
  out.error.set(point[0]!, point[1]!, point[2]);
  const [x, z] = [actor.place[0]!, actor.place[2]!];
  out.foot.set(x - eye[0]!, groundY(x, z) - eye[1]!, z - eye[2]!);
  rotate(point, turn.matrix, ship.groundNormal);
  out.ground.set(point[0]!, point[1]!, point[2]);
  placeFootprint(out, ship);
  out.legRadius = ship.shipClass.legRadius;

  const mass = ship.shipClass.dryMass + ship.fuel;
  const range = Math.hypot(ship.position[0]!, ship.position[1]!, ship.position[2]!);
  const gravity = (GRAVITATIONAL_CONSTANT * view.bodies[ship.body]!.mass) / (range * range);
  rotate(point, turn.matrix, ship.thrust);
  out.thrust.set(point[0]! / mass, point[1]! / mass, point[2]! / mass);
  rotate(point, turn.matrix, ship.position);
  out.up.set(point[0]!, point[1]!, point[2]).normalize();
  out.weight.copy(out.up).multiplyScalar(-gravity);
  // At rest the ground carries the weight that the thrust does not; the view does not know a bounce's peak.
  const carried = ship.surfaceContactState === '' ? 0 : Math.max(0, gravity - out.thrust.dot(out.up));
  out.support.copy(out.up).multiplyScalar(carried);
}

const way = new Vector3();

/**
 * The footprint's centre: below the ship along the surface normal, where the feet of a ship flush with the ground are. High above a slope
 * it is no further to the side than from the ship's own height.
 */
function placeFootprint(out: Places, ship: ShipView): void {
  way.subVectors(out.ship, out.foot);
  const off = way.dot(out.ground);
  way.addScaledVector(out.ground, -off);
  const share = off > ship.groundContactOffset ? ship.groundContactOffset / off : 1;
  out.footprint.copy(out.foot).addScaledVector(way, share);
}

export function anyChosen(choice: OverlayChoice): boolean {
  return choice.ghost || choice.errorSegment || choice.contactNormal || choice.footprint || choice.forces;
}

export function createPlaces(): Places {
  return {
    ship: new Vector3(),
    ghost: new Vector3(),
    ghostTurn: new Quaternion(),
    ghostKnown: false,
    error: new Vector3(),
    foot: new Vector3(),
    footprint: new Vector3(),
    ground: new Vector3(0, 1, 0),
    up: new Vector3(),
    legRadius: 1,
    thrust: new Vector3(),
    weight: new Vector3(),
    support: new Vector3(),
  };
}
