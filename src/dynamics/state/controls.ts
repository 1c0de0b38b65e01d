import {
  type Result,
  ok,
  notFinite,
  notFiniteTuple,
  type Quat,
  err,
  readQuat,
  readVec3,
  type Vec3,
} from '../result';
import {
  ATTITUDE_HOLD,
  ATTITUDE_MODE,
  ATTITUDE_MODES,
  type AttitudeMode,
  MODE_UNKNOWN,
  ROTATION_INPUT,
  TARGET_ATTITUDE,
  THRUST_LEVEL,
  TRANSLATION_INPUT,
} from './layout';

/** A pilot's controls, under the game's names. */
export interface Controls {
  /** 0 … 1 */
  readonly thrustLevel: number;
  /** −1 … 1 along body x, y, z. */
  readonly translationInput: Vec3;
  /** −1 … 1 about body x (pitch), y (yaw), z (roll). */
  readonly rotationInput: Vec3;
  /** Rate damping. */
  readonly attitudeHold: boolean;
  /** Target of the attitude controller. */
  readonly attitudeMode: AttitudeMode;
  /** For attitude mode hold. */
  readonly targetAttitude: Quat;
}

/** Controls at spawn. */
export const NEUTRAL_CONTROLS: Controls = Object.freeze<Controls>({
  thrustLevel: 0,
  translationInput: [0, 0, 0],
  rotationInput: [0, 0, 0],
  attitudeHold: false,
  attitudeMode: 'none',
  targetAttitude: [0, 0, 0, 1],
});

/** A target this close to unit length is not normalised: that would change its last bits each time it is loaded. */
const UNIT_WITHIN = 1e-12;

/** A target attitude is normalised if its length is between these, and refused otherwise. */
const MIN_LENGTH = 1e-3;
const MAX_LENGTH = 1e3;

/**
 * Clamps controls into range and normalises the target, or returns an error that names the invalid field (DYNAMICS, Actuators). Loading
 * loaded controls returns the same bits, so that a stored or sent input replays to the same flight.
 */
export function loadControls(given: Controls): Result<Controls> {
  const reason =
    notFinite('thrustLevel', given.thrustLevel) ??
    notFiniteTuple('translationInput', given.translationInput, 3) ??
    notFiniteTuple('rotationInput', given.rotationInput, 3) ??
    notFiniteTuple('targetAttitude', given.targetAttitude, 4);
  if (reason !== null) return err(reason);
  if (typeof given.attitudeHold !== 'boolean') return err('attitudeHold: expected true or false');
  if (typeof given.attitudeMode !== 'string') return err('attitudeMode: expected a string');
  const [x, y, z, w] = given.targetAttitude;
  const length = Math.sqrt(x * x + y * y + z * z + w * w);
  if (!(length > MIN_LENGTH && length < MAX_LENGTH))
    return err('targetAttitude: expected a quaternion of length 1');
  const isUnit = Math.abs(length - 1) <= UNIT_WITHIN;
  return ok({
    thrustLevel: clamp(given.thrustLevel, 0, 1),
    translationInput: clampTriple(given.translationInput),
    rotationInput: clampTriple(given.rotationInput),
    attitudeHold: given.attitudeHold,
    attitudeMode: attitudeModeOf(given.attitudeMode),
    targetAttitude: isUnit ? given.targetAttitude : [x / length, y / length, z / length, w / length],
  });
}

/** The mode of that name, or 'unknown', so that a ship with a mode unknown here still loads. */
export function attitudeModeOf(name: string): AttitudeMode {
  return (ATTITUDE_MODES as readonly string[]).includes(name) ? (name as AttitudeMode) : 'unknown';
}

/** Converts a mode to its value in column ATTITUDE_MODE, and back. */
export function modeNumber(mode: AttitudeMode): number {
  return mode === 'unknown' ? MODE_UNKNOWN : ATTITUDE_MODES.indexOf(mode);
}

export function modeName(number: number): AttitudeMode {
  return ATTITUDE_MODES[number] ?? 'unknown';
}

/** Writes loaded controls into a ship's row. */
export function writeControls(ships: Float64Array, at: number, controls: Controls): void {
  ships[at + THRUST_LEVEL] = controls.thrustLevel;
  ships.set(controls.translationInput, at + TRANSLATION_INPUT);
  ships.set(controls.rotationInput, at + ROTATION_INPUT);
  ships[at + ATTITUDE_HOLD] = controls.attitudeHold ? 1 : 0;
  ships[at + ATTITUDE_MODE] = modeNumber(controls.attitudeMode);
  ships.set(controls.targetAttitude, at + TARGET_ATTITUDE);
}

/** Reads the controls of a row. */
export function readControls(ships: Float64Array, at: number): Controls {
  return {
    thrustLevel: ships[at + THRUST_LEVEL]!,
    translationInput: readVec3(ships, at + TRANSLATION_INPUT),
    rotationInput: readVec3(ships, at + ROTATION_INPUT),
    attitudeHold: ships[at + ATTITUDE_HOLD] === 1,
    attitudeMode: modeName(ships[at + ATTITUDE_MODE]!),
    targetAttitude: readQuat(ships, at + TARGET_ATTITUDE),
  };
}

function clamp(value: number, low: number, high: number): number {
  return value < low ? low : value > high ? high : value;
}

function clampTriple([x, y, z]: Vec3): Vec3 {
  return [clamp(x, -1, 1), clamp(y, -1, 1), clamp(z, -1, 1)];
}
