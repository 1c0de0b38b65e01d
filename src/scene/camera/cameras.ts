import type { PerspectiveCamera } from 'three';
import { type MovingRig, placeEye, turnRig, updateRig } from './cameraRig';
import { rotateByQuat, type ShipActor } from '../ships/shipActor';

/** The camera positions. */
export const CAMERA_VIEWS = ['follow', 'chase', 'cockpit', 'above', 'free'] as const;

/**
 * follow: around the ship, turned by hand · chase: behind the ship, in its direction over the ground · cockpit: from the ship, turning
 * with it · above: straight down, with its heading kept at the top · free: the eye stays in place.
 */
export type CameraView = (typeof CAMERA_VIEWS)[number];

/** The chase camera turns only above this speed along the ground, m/s; and at this rate, 1/s. */
const CHASE_SPEED = 1.5;
const CHASE_RATE = 1.2;
const CHASE_ELEVATION = 0.32;
/** rad: at a steeper angle the picture's top has no direction. */
const ABOVE_ELEVATION = 1.5;
const ABOVE_DISTANCE = 2.2;
/** Of the cockpit's eye over the centre of mass, in heights of it over the feet; how far it looks down, rad. */
const COCKPIT_HEIGHT = 0.75;
const COCKPIT_DIP = 0.3;
/** m in front of the cockpit's eye: nearer, the ship's own hull is left out. */
const HULL_REACH = 0.9;
const NEAR = 0.4;

export interface CameraPlace {
  readonly actor: ShipActor;
  /** Time since the last frame, s. */
  readonly seconds: number;
  readonly groundY: (x: number, z: number) => number;
  /** There is a pad to land on. */
  readonly hasPad: boolean;
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
  if (view === 'follow') raiseOverPad(rig, place);
  if (view === 'chase') turnBehind(rig, actor.velocity, seconds);
  if (view !== 'free') updateRig(rig, actor.place, actor.velocity, seconds);
  if (view === 'cockpit') placeInCockpit(camera, rig, place);
  else if (view === 'above') lookDown(rig, actor);
  else placeEye(rig, place.groundY);
  setNear(camera, view === 'cockpit' ? HULL_REACH * actor.height : NEAR);
  const { eye, focus } = rig;
  camera.lookAt(focus[0]! - eye[0]!, focus[1]! - eye[1]!, focus[2]! - eye[2]!);
}

/** rad over the first view from PAD_HEIGHT m up; lower than PAD_LOW m the ship is seen from the side. */
const PAD_ELEVATION = 1.15;
const PAD_HEIGHT = 68;
const PAD_LOW = 8;
/** rad: smaller turns wait, so that the picture does not swim. */
const PAD_STEP = 0.02;

/** High over its pad a ship is seen from above, so that the pad is in the picture. Manual rotation is added. */
function raiseOverPad(rig: MovingRig, { actor, groundY, hasPad }: CameraPlace): void {
  const [x, y, z] = actor.place as unknown as [number, number, number];
  const height = hasPad ? y - actor.height - groundY(x, z) : 0;
  const share = Math.min(Math.max((height - PAD_LOW) / (PAD_HEIGHT - PAD_LOW), 0), 1);
  const wanted = PAD_ELEVATION * share;
  if (Math.abs(wanted - rig.raised) < PAD_STEP && wanted !== 0) return;
  turnRig(rig, 0, wanted - rig.raised);
  rig.raised = wanted;
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

/** Body axes: x right, y ahead of a pilot whose ship stands on the ground, z up. */
function placeInCockpit(camera: PerspectiveCamera, rig: MovingRig, { actor }: CameraPlace): void {
  rotateByQuat(forward, actor.turn, [0, Math.cos(COCKPIT_DIP), -Math.sin(COCKPIT_DIP)]);
  rotateByQuat(upward, actor.turn, [0, 0, 1]);
  for (let k = 0; k < 3; k++) {
    rig.eye[k] = actor.place[k]! + upward[k]! * COCKPIT_HEIGHT * actor.height;
    rig.focus[k] = rig.eye[k]! + forward[k]! * 10;
  }
  camera.up.set(upward[0]!, upward[1]!, upward[2]);
}

function lookDown(rig: MovingRig, actor: ShipActor): void {
  const { eye, focus, motion } = rig;
  const distance = motion.distance * ABOVE_DISTANCE;
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
