/** Where the eye is, around a point that follows the ship. Angles in radians, lengths in metres, local axes. */
export interface CameraRig {
  azimuth: number;
  elevation: number;
  distance: number;
  /** Part of the elevation that the camera itself has added, rad. */
  raised: number;
  /** Multiple of the distance from which the ship fits between the picture's margins. */
  reach: number;
  /** Tangent of the angle below the ship at which the pad is kept. */
  padBelow: number;
  /** The camera has turned to the pad, once. */
  facesPad: boolean;
  /** Local, doubles. */
  readonly focus: Float64Array;
  readonly eye: Float64Array;
}

interface Motion {
  readonly velocity: Float64Array;
  /** The ship's velocity, smoothed. */
  readonly known: Float64Array;
  azimuth: number;
  elevation: number;
  distance: number;
  started: boolean;
}

/** 1/s: how fast the view follows the ship and the pointer. */
const FOLLOW = 5;
const HAND = 9;
/** 1/s: how fast the smoothed velocity follows the ship's, so that the view does not jerk at a bounce. */
const NOTICE = 9;
/** A stall longer than this, s, is not followed step by step. */
const STALL = 2;
/** How far above its lowest place the eye begins to be lifted, m. */
const SOFT = 1.2;
/** m: a larger move is a teleport. */
const JUMP = 60;

/** Of a whole picture: above the panels at its lower edge. */
export const PAD_BELOW = 0.18;

export type MovingRig = CameraRig & { readonly motion: Motion };

export function createRig(azimuth: number, elevation: number, distance: number): MovingRig {
  return {
    azimuth,
    elevation,
    distance,
    raised: 0,
    reach: 1,
    padBelow: PAD_BELOW,
    facesPad: false,
    focus: new Float64Array(3),
    eye: new Float64Array(3),
    motion: {
      velocity: new Float64Array(3),
      known: new Float64Array(3),
      azimuth,
      elevation,
      distance,
      started: false,
    },
  };
}

export function turnRig(rig: MovingRig, azimuth: number, elevation: number): void {
  rig.azimuth += azimuth;
  rig.elevation = Math.min(Math.max(rig.elevation + elevation, -0.25), 1.5);
}

export function zoomRig(rig: MovingRig, factor: number, closest: number): void {
  rig.distance = Math.min(Math.max(rig.distance * factor, closest), 4000);
}

/** The next update jumps to the ship's position. */
export function releaseRig(rig: MovingRig): void {
  rig.motion.started = false;
}

/**
 * Follows the drawn ship by a critically damped spring, with the ship's velocity fed forward: it does not lag behind a steady
 * flight, and neither a correction nor a bounce makes the picture jump.
 */
export function updateRig(
  rig: MovingRig,
  target: Float64Array,
  velocity: Float64Array,
  seconds: number,
): void {
  const { focus, motion } = rig;
  const far = Math.hypot(target[0]! - focus[0]!, target[1]! - focus[1]!, target[2]! - focus[2]!) > JUMP;
  if (!motion.started || far || seconds > STALL) {
    focus.set(target);
    motion.velocity.set(velocity);
    motion.known.set(velocity);
    motion.azimuth = rig.azimuth;
    motion.elevation = rig.elevation;
    motion.distance = rig.distance;
    motion.started = true;
  }
  const steps = Math.max(1, Math.ceil(seconds / 0.02));
  const dt = seconds / steps;
  const notice = 1 - Math.exp(-NOTICE * dt);
  for (let n = 0; n < steps; n++) {
    for (let i = 0; i < 3; i++) {
      // The target at the start of this step, like the focus.
      const then = target[i]! - velocity[i]! * (seconds - dt * n);
      motion.known[i] = motion.known[i]! + (velocity[i]! - motion.known[i]!) * notice;
      const pull =
        FOLLOW * FOLLOW * (then - focus[i]!) + 2 * FOLLOW * (motion.known[i]! - motion.velocity[i]!);
      motion.velocity[i] = motion.velocity[i]! + pull * dt;
      focus[i] = focus[i]! + motion.velocity[i]! * dt;
    }
  }
  const ease = 1 - Math.exp(-HAND * seconds);
  motion.azimuth += (rig.azimuth - motion.azimuth) * ease;
  motion.elevation += (rig.elevation - motion.elevation) * ease;
  motion.distance += (rig.distance - motion.distance) * ease;
}

/** The eye around the focus, never lower than `ground(x, z)` + 1 m. */
export function placeEye(rig: MovingRig, ground: (x: number, z: number) => number): void {
  const { focus, eye, motion } = rig;
  const cos = Math.cos(motion.elevation);
  const distance = motion.distance * rig.reach;
  eye[0] = focus[0]! + distance * cos * Math.cos(motion.azimuth);
  eye[1] = focus[1]! + distance * Math.sin(motion.elevation);
  eye[2] = focus[2]! + distance * cos * Math.sin(motion.azimuth);
  const lowest = ground(eye[0], eye[2]) + 1;
  const above = (eye[1] - lowest) / SOFT;
  // A soft maximum: the eye slides up a hill and does not bump into it.
  eye[1] = lowest + SOFT * (above > 30 ? above : Math.log1p(Math.exp(above)));
}
