import type { PerspectiveCamera } from 'three';
import { vec3 } from 'gl-matrix';
import { type MovingRig, placeEye, turnRig, updateRig } from './cameraRig';
import type { ShipActor } from '../ships/shipActor';

/** The camera positions. */
export const CAMERA_VIEWS = ['follow', 'chase', 'cockpit', 'above', 'free'] as const;

/**
 * follow: around the ship, turned by hand · chase: behind the ship, in its direction over the ground · cockpit: from the ship, turning
 * with it · above: straight down, with its heading kept at the top · free: the eye stays in place.
 */
export type CameraView = (typeof CAMERA_VIEWS)[number];

/** The eye's initial direction from the ship, rad: on the shadow's side, slightly above the ground. */
export const FIRST_AZIMUTH = 1.9;
export const FIRST_ELEVATION = 0.16;

/** The chase camera turns only above this speed along the ground, m/s; and at this rate, 1/s. */
const CHASE_SPEED = 1.5;
const CHASE_RATE = 1.2;
const CHASE_ELEVATION = 0.32;
/** rad: at a steeper angle the picture's top has no direction. */
const ABOVE_ELEVATION = 1.5;
const ABOVE_DISTANCE = 2.2;
/** Height of the cockpit's eye over the centre of mass, as a share of that one's height over the feet; how far it looks down, rad. */
const COCKPIT_HEIGHT = 0.75;
const COCKPIT_DIP = 0.3;
/** Near plane of the cockpit camera, m: it leaves out the ship's own hull. */
const HULL_REACH = 0.9;
const NEAR = 0.4;

export interface CameraPlace {
  readonly actor: ShipActor;
  /** Time since the last frame, s. */
  readonly seconds: number;
  readonly groundY: (x: number, z: number) => number;
  /** The pad to land on next, local, m; null without one. */
  readonly pad: ArrayLike<number> | null;
}

/** Moves the eye and aims the camera; afterwards `rig.eye` and `rig.focus` are local, m. */
export function aimCamera(
  camera: PerspectiveCamera,
  rig: MovingRig,
  view: CameraView,
  place: CameraPlace,
): void {
  const { actor, seconds } = place;
  camera.up.set(0, 1, 0);
  if (view === 'follow') showPad(rig, place);
  if (view === 'chase') turnBehind(rig, actor.velocity, seconds);
  if (view !== 'free') updateRig(rig, actor.place, actor.velocity, seconds);
  if (view === 'cockpit') placeInCockpit(camera, rig, place);
  else if (view === 'above') lookDown(rig, actor);
  else placeEye(rig, place.groundY);
  setNear(camera, view === 'cockpit' ? HULL_REACH * actor.height : NEAR);
  const { eye, focus } = rig;
  camera.lookAt(focus[0]! - eye[0]!, focus[1]! - eye[1]!, focus[2]! - eye[2]!);
}

/** Heights of the feet over the pad, m: between them the camera sinks, and below the lower one it sees the ship from the side. */
const PAD_HIGH = 18;
const PAD_LOW = 4;
/** m: closer to the pad's centre the direction to it is meaningless. */
const OVER_PAD = 2;
/** rad: smaller turns wait, so that the picture does not swim. */
const PAD_STEP = 0.02;

/** Keeps the pad in the picture below the ship: faced at the start, and seen from as far above as needed. Manual rotation is added. */
function showPad(rig: MovingRig, { actor, pad }: CameraPlace): void {
  let wanted = 0;
  if (pad !== null) {
    const [x, y, z] = actor.place as unknown as [number, number, number];
    const [east, up, south] = [pad[0]! - x, y - pad[1]!, pad[2]! - z];
    const away = Math.hypot(east, south);
    if (!rig.facesPad && away > OVER_PAD) rig.azimuth = Math.atan2(-south, -east);
    rig.facesPad = true;
    const share = (up - actor.height - PAD_LOW) / (PAD_HIGH - PAD_LOW);
    const elevation = elevationOver(away, up, rig);
    wanted = Math.max(elevation - FIRST_ELEVATION, 0) * Math.min(Math.max(share, 0), 1);
  }
  if (Math.abs(wanted - rig.raised) < PAD_STEP && wanted !== 0) return;
  turnRig(rig, 0, wanted - rig.raised);
  rig.raised = wanted;
}

/**
 * rad: the lowest view of a ship from distance · reach m that has a pad `away` m ahead of the ship and `up` m below it in the picture.
 * With r, φ the pad's range and depression from the ship, the pad is r·sin(φ − e) below the line of sight and
 * r·cos(φ − e) + distance · reach along it.
 */
function elevationOver(away: number, up: number, { distance, reach, padBelow }: MovingRig): number {
  const range = Math.hypot(away, up);
  const sine = (padBelow * distance * reach) / (range * Math.hypot(1, padBelow));
  return Math.atan2(up, away) - Math.atan(padBelow) - Math.asin(Math.min(sine, 1));
}

function turnBehind(rig: MovingRig, velocity: Float64Array, seconds: number): void {
  const along = Math.hypot(velocity[0]!, velocity[2]!);
  if (along < CHASE_SPEED) return;
  const behind = Math.atan2(-velocity[2]!, -velocity[0]!);
  const off = behind - rig.azimuth;
  // The shorter way around.
  const turn = off - 2 * Math.PI * Math.round(off / (2 * Math.PI));
  const share = 1 - Math.exp(-CHASE_RATE * seconds);
  rig.azimuth += turn * share;
  rig.elevation += (CHASE_ELEVATION - rig.elevation) * share;
}

const forward = new Float64Array(3);
const upward = new Float64Array(3);

/** Body axes: x right, y ahead for the pilot of an upright ship, z up. */
function placeInCockpit(camera: PerspectiveCamera, rig: MovingRig, { actor }: CameraPlace): void {
  vec3.transformQuat(forward, [0, Math.cos(COCKPIT_DIP), -Math.sin(COCKPIT_DIP)], actor.turn);
  vec3.transformQuat(upward, [0, 0, 1], actor.turn);
  for (let k = 0; k < 3; k++) {
    rig.eye[k] = actor.place[k]! + upward[k]! * COCKPIT_HEIGHT * actor.height;
    rig.focus[k] = rig.eye[k]! + forward[k]! * 10;
  }
  camera.up.set(upward[0]!, upward[1]!, upward[2]);
}

function lookDown(rig: MovingRig, actor: ShipActor): void {
  const { eye, focus, motion } = rig;
  const distance = motion.distance * rig.reach * ABOVE_DISTANCE;
  focus.set(actor.place);
  eye[0] = focus[0]! + distance * Math.cos(ABOVE_ELEVATION) * Math.cos(motion.azimuth);
  eye[1] = focus[1]! + distance * Math.sin(ABOVE_ELEVATION);
  eye[2] = focus[2]! + distance * Math.cos(ABOVE_ELEVATION) * Math.sin(motion.azimuth);
}

function setNear(camera: PerspectiveCamera, near: number): void {
  if (camera.near === near) return;
  camera.near = near;
  camera.updateProjectionMatrix();
}
