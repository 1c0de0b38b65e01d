import type { Result } from '../../../src/dynamics';

/** Invalid values for a number. */
export const NO_NUMBERS = [NaN, Infinity, -Infinity, '1', null, undefined, {}, [1]] as const;

/** The reason for a refusal, or 'accepted'. */
export function reasonOf(checked: Result<unknown>): string {
  return checked.ok ? 'accepted' : checked.reason;
}
