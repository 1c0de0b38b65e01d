import { DEFAULT_SETTINGS } from '../../dynamics';
import { DEFAULT_SMOOTHING, SMOOTHING_BOUNDS } from '../drawn/ease';
import type { PredictorOptions } from '../options';
import type { Warn } from '../warnings';
import { warnOfUnknown } from './names';

const OPTIONS = [
  'terrains',
  'defaults',
  'maxSubstepsPerFrame',
  'ownShipId',
  'smoothing',
  'plan',
  'onWarning',
  'forcedRollback',
] satisfies readonly (keyof PredictorOptions)[];
const DEFAULTS = ['settings', 'shipClasses', 'bodies', 'terrain'];

type Check = (value: unknown) => boolean;

const isRecord: Check = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);
const isFunction: Check = (value) => typeof value === 'function';
const isCount: Check = (value) => Number.isSafeInteger(value) && (value as number) >= 0;

/** What each option has to be. */
const EXPECTED: Readonly<Record<string, readonly [Check, string]>> = {
  terrains: [
    (value) => isRecord(value) && Object.values(value as object).every(isFunction),
    'functions (bodyName, nx, ny, nz) → metres, by name',
  ],
  defaults: [isRecord, 'an object with settings, shipClasses, bodies, terrain'],
  maxSubstepsPerFrame: [(value) => isCount(value) && value !== 0, 'a whole number > 0'],
  smoothing: [isRecord, 'an object with alongGround, alongNormal, angle'],
  ownShipId: [(value) => typeof value === 'string', 'a text'],
  plan: [Array.isArray, 'a list of inputs'],
  onWarning: [isFunction, 'a function (code, message, details)'],
  forcedRollback: [isCount, 'a whole number ≥ 0'],
};

/** Throws RangeError, naming the option, where one cannot be used. */
export function requireOptions(given: PredictorOptions): void {
  if (!isRecord(given)) throw new RangeError(`options: expected an object, got ${typeof given}`);
  for (const [name, [check, expected]] of Object.entries(EXPECTED)) {
    const value: unknown = given[name as keyof PredictorOptions];
    if (value !== undefined && !check(value))
      throw new RangeError(
        `options.${name}: expected ${expected}, got ${typeof value === 'object' ? 'an object' : JSON.stringify(value)}`,
      );
  }
  requireSmoothing(given.smoothing ?? {});
}

function requireSmoothing(given: NonNullable<PredictorOptions['smoothing']>): void {
  for (const [name, [low, high]] of Object.entries(SMOOTHING_BOUNDS)) {
    if (!Object.hasOwn(given, name)) continue;
    const value: unknown = given[name as keyof typeof given];
    if (typeof value === 'number' && value >= low && value <= high) continue;
    throw new RangeError(`options.smoothing.${name}: expected ${low} to ${high} s, got ${String(value)}`);
  }
}

/** Warns of options, defaults and settings that nobody reads. */
export function checkOptions(warn: Warn, given: PredictorOptions): void {
  warnOfUnknown(warn, { code: 'unknown-option', path: 'options', known: OPTIONS }, given);
  const { defaults, smoothing } = given;
  const known = Object.keys(DEFAULT_SMOOTHING);
  if (smoothing !== undefined)
    warnOfUnknown(warn, { code: 'unknown-option', path: 'options.smoothing', known }, smoothing);
  if (defaults === undefined) return;
  warnOfUnknown(warn, { code: 'unknown-default', path: 'options.defaults', known: DEFAULTS }, defaults);
  checkSettings(warn, 'options.defaults.settings', defaults.settings);
}

/** Warns of settings that nobody reads, and of angles that look like radians. */
export function checkSettings(warn: Warn, path: string, settings: unknown): void {
  if (!isRecord(settings)) return;
  const known = Object.keys(DEFAULT_SETTINGS);
  // A loaded record brings its constants along.
  const naming = { code: 'unknown-setting', path, known: [...known, 'cosSettleTilt', 'cosTippedAngle'] };
  warnOfUnknown(warn, naming, settings as object);
  const tipped = (settings as { contactTippedAngleDeg?: unknown }).contactTippedAngleDeg;
  if (typeof tipped === 'number' && tipped > 0 && tipped < 3.2) {
    const details = { field: 'contactTippedAngleDeg', value: tipped };
    warn('setting-in-radians', `${path}.contactTippedAngleDeg is ${tipped}: degrees are expected.`, details);
  }
}
