import type { Controls, Result } from '../../dynamics';
import { controlFields, readControlFields } from '../fields/controls';
import { beginReading, endReading, fieldsOf } from '../fields/reading';

/**
 * Controls for JSON.stringify, under the game's names: thrust_level, translation_input and rotation_input {x, y, z},
 * attitude_hold, attitude_mode, target_attitude {w, x, y, z}.
 */
export function encodeControlsJson(controls: Controls): Readonly<Record<string, unknown>> {
  return { ...controlFields(controls) };
}

/**
 * Controls that a client says in JSON, clamped into range; what it leaves out is neutral. Refused with the path of the
 * first bad field, below `path`. Never throws on a parsed JSON value.
 */
export function decodeControlsJson(value: unknown, path = 'controls'): Result<Controls> {
  const r = beginReading('json', path);
  return endReading(r, readControlFields(r, fieldsOf(r, value)));
}
