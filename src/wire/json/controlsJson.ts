import { type Controls, loadControls, type Result } from '../../dynamics';
import { controlFields, readControlFields } from '../fields/controls';
import { beginReading, endReading, fieldsOf } from '../fields/reading';

/**
 * Controls for JSON.stringify, under the game's names: thrust_level, translation_input and rotation_input {x, y, z},
 * attitude_hold, attitude_mode, target_attitude {w, x, y, z}. The controls of `takeControls` can always be encoded.
 * @throws RangeError that names the member, if controls are incomplete or not finite
 *
 * @example
 * ```ts
 * const controls = predictor.takeControls();
 * if (controls !== null) socket.send(JSON.stringify({ type: 'control', ...encodeControlsJson(controls) }));
 * ```
 */
export function encodeControlsJson(controls: Controls): Readonly<Record<string, unknown>> {
  const given: unknown = controls;
  const loaded = loadControls((given ?? {}) as Controls);
  if (!loaded.ok) throw new RangeError(`controls.${loaded.reason}. Start from NEUTRAL_CONTROLS.`);
  return { ...controlFields(controls) };
}

/**
 * Controls of a client in JSON, clamped into range; absent ones are neutral. Refused with the path of the first invalid field, below
 * `path`. Never throws on a parsed JSON value.
 */
export function decodeControlsJson(value: unknown, path = 'controls'): Result<Controls> {
  const r = beginReading('json', path);
  return endReading(r, readControlFields(r, fieldsOf(r, value)));
}
