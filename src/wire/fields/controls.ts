import {
  attitudeModeOf,
  type AttitudeMode,
  type Controls,
  loadControls,
  NEUTRAL_CONTROLS,
} from '../../dynamics';
import type { galaxy } from '../generated/codec.js';
import { FINITE } from '../limits';
import { type Fields, flagIn, numberIn, type Reading, refuse, textIn } from './reading';
import type { StateControls } from '../records';
import { optionalQuaternionIn, optionalVectorIn, quaternionFields, vectorFields } from './vectors';

/**
 * The six fields of Controls, which ShipState has too. Absent ones are neutral; values out of range are clamped; an unknown attitude mode
 * is 'unknown' (DYNAMICS, Actuators).
 */
export function readControlFields(r: Reading, from: Fields): Controls {
  return readWithMode(r, from, attitudeModeOf(textIn(r, from, 'attitude_mode') || 'none'));
}

/** As readControlFields, for a state: an unknown mode keeps its name. */
export function readStateControls(r: Reading, from: Fields): StateControls {
  const sent = textIn(r, from, 'attitude_mode');
  const controls = readWithMode(r, from, attitudeModeOf(sent || 'none'));
  return controls.attitudeMode === 'unknown' ? { ...controls, attitudeMode: sent } : controls;
}

function readWithMode(r: Reading, from: Fields, attitudeMode: AttitudeMode): Controls {
  const neutral = NEUTRAL_CONTROLS;
  const sent: Controls = {
    thrustLevel: numberIn(r, from, 'thrust_level', FINITE, 0),
    translationInput: optionalVectorIn(r, from, 'translation_input', FINITE) ?? neutral.translationInput,
    rotationInput: optionalVectorIn(r, from, 'rotation_input', FINITE) ?? neutral.rotationInput,
    attitudeHold: flagIn(r, from, 'attitude_hold'),
    attitudeMode,
    targetAttitude: optionalQuaternionIn(r, from, 'target_attitude') ?? neutral.targetAttitude,
  };
  const loaded = loadControls(sent);
  if (!loaded.ok) {
    refuse(r, '', loaded.reason);
    return neutral;
  }
  // The target is a unit quaternion already. Normalising it again could change the last bit, and client and server would
  // then apply different inputs.
  return { ...loaded.value, targetAttitude: sent.targetAttitude };
}

export function controlFields(controls: StateControls): galaxy.stream.Controls.$Properties {
  return {
    thrust_level: controls.thrustLevel,
    translation_input: vectorFields(controls.translationInput),
    rotation_input: vectorFields(controls.rotationInput),
    attitude_hold: controls.attitudeHold,
    attitude_mode: controls.attitudeMode,
    target_attitude: quaternionFields(controls.targetAttitude),
  };
}
