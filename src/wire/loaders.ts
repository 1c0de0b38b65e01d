import type { Result } from '../dynamics';
import { type Reading, refuse } from './fields/reading';

/**
 * Refuses the message if a loader of dynamics refused its contents. The loader's reason is
 * "`prefix`field: what was expected"; the field gets its name on the wire.
 */
export function refuseLoaded(r: Reading, loaded: Result<unknown>, prefix: string): void {
  if (loaded.ok) return;
  const reason = loaded.reason.startsWith(prefix) ? loaded.reason.slice(prefix.length) : loaded.reason;
  const colon = reason.indexOf(': ');
  if (colon < 0) refuse(r, '', onTheWire(reason));
  else refuse(r, onTheWire(reason.slice(0, colon)), onTheWire(reason.slice(colon + 2)));
}

/** camelCase names in a sentence -> snake_case. */
function onTheWire(sentence: string): string {
  return sentence.replace(/\b[a-z]+(?:[A-Z][a-z]*)+\b/g, (name) =>
    name.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`),
  );
}
