import { DEFAULT_SETTINGS, faultOfConstants, loadControls } from '../../dynamics';
import { DEFAULT_SMOOTHING, SMOOTHING_BOUNDS } from '../drawn/ease';
import type { ScheduledInput } from '../inputs/inputs';
import type { BodyState } from '../../wire';
import { defaultWorld, type Defaults, GAME_CATALOGUE, type PredictorOptions } from '../options';
import { checkBodies } from './records/bodies';
import { checkClasses } from './records/shipClasses';
import type { Warn } from '../warnings';
import { describe, kindOf } from './describe';
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

const isRecord: Check = (value) => typeof value === 'object' && value !== null && kindOf(value) === 'Object';
const isFunction: Check = (value) => typeof value === 'function';
const isText: Check = (value) => typeof value === 'string';
const isCount: Check = (value) => Number.isSafeInteger(value) && (value as number) >= 0;
const isPlan: Check = (value) =>
  Array.isArray(value) &&
  value.every((entry: unknown, i) => {
    const { tick, substep, controls } = (entry ?? {}) as ScheduledInput;
    if (!isCount(tick) || !isCount(substep) || !isRecord(controls) || !loadControls(controls).ok)
      return false;
    const before = (value as readonly ScheduledInput[])[i - 1];
    return before === undefined || tick > before.tick || (tick === before.tick && substep >= before.substep);
  });

const areFeatures: Check = (value) =>
  Array.isArray(value) && value.every((entry: unknown) => isRecord(entry) && 'feature' in (entry as object));

type Expected = Readonly<Record<string, readonly [Check, string]>>;

/** The check of each option, and what it expects. */
const EXPECTED: Expected = {
  terrains: [
    (value) => isRecord(value) && Object.values(value as object).every(isFunction),
    'functions (bodyName, nx, ny, nz) → metres above the radius, by name',
  ],
  defaults: [isRecord, 'an object with settings, shipClasses, bodies, terrain'],
  maxSubstepsPerFrame: [(value) => isCount(value) && value !== 0, 'a whole number > 0'],
  smoothing: [isRecord, 'an object with alongGround, alongNormal, angle'],
  ownShipId: [isText, 'a string'],
  plan: [isPlan, 'a list of { tick, substep, controls }, ascending in time, with all controls'],
  onWarning: [isFunction, 'a function (code, message, details)'],
  forcedRollback: [isCount, 'a whole number ≥ 0'],
  features: [areFeatures, 'a list of features, as [learnedGround]'],
};

const isVector = (value: unknown, count: number): boolean =>
  value === undefined || (Array.isArray(value) && value.length === count && value.every(Number.isFinite));

/** Absent members are refused when the world is loaded. */
const areBodies: Check = (value) =>
  Array.isArray(value) &&
  value.every((body: unknown) => {
    const { position, velocity, attitude, angularVelocity } = (body ?? {}) as Partial<BodyState>;
    return (
      isVector(attitude, 4) && [position, velocity, angularVelocity].every((vector) => isVector(vector, 3))
    );
  });

/** The check of each member of `defaults`, and what it expects; the contents are checked when the world is loaded. */
const EXPECTED_DEFAULTS: Expected = {
  settings: [isRecord, 'an object of settings by name'],
  shipClasses: [Array.isArray, 'a list of ship classes'],
  bodies: [areBodies, 'a list of bodies with vectors of finite numbers'],
  terrain: [isText, 'the name of a terrain'],
};

/** @throws RangeError that names the invalid option */
export function requireOptions(given: PredictorOptions): void {
  if (!isRecord(given)) throw new RangeError(`options: expected an object, got ${describe(given)}`);
  requireMembers('options', EXPECTED, given);
  requireMembers('options.defaults', EXPECTED_DEFAULTS, given.defaults ?? {});
  requireSmoothing(given.smoothing ?? {});
  const fault = faultOfConstants(defaultWorld(given.defaults, GAME_CATALOGUE));
  if (fault !== null) throw new RangeError(`defaults: ${fault}`);
}

/** @throws RangeError that names the invalid option of a lean predictor */
export function requireLeanOptions(given: PredictorOptions): void {
  requireOptions(given);
  if ('forcedRollback' in given)
    throw new RangeError('options.forcedRollback: only createPredictor has this test mode');
}

function requireMembers(path: string, members: Expected, given: object): void {
  const fault = faultIn(members, given);
  if (fault !== null) throw new RangeError(`${path}.${fault}`);
}

function faultIn(members: Expected, given: object): string | null {
  for (const [name, [check, expected]] of Object.entries(members)) {
    const value = (given as Readonly<Record<string, unknown>>)[name];
    if (value !== undefined && !check(value)) return `${name}: expected ${expected}, got ${describe(value)}`;
  }
  return null;
}

/** The first member of the defaults with the wrong type, and what it expects; null if there is none. */
export function faultOfDefaults(given: object): string | null {
  return faultIn(EXPECTED_DEFAULTS, given);
}

function requireSmoothing(given: NonNullable<PredictorOptions['smoothing']>): void {
  for (const [name, [low, high]] of Object.entries(SMOOTHING_BOUNDS)) {
    if (!Object.hasOwn(given, name)) continue;
    const value: unknown = given[name as keyof typeof given];
    if (typeof value === 'number' && value >= low && value <= high) continue;
    throw new RangeError(`options.smoothing.${name}: expected ${low} to ${high} s, got ${describe(value)}`);
  }
}

/** Warns of unknown options, defaults and settings. */
export function checkOptions(warn: Warn, given: PredictorOptions): void {
  warnOfUnknown(warn, { code: 'unknown-option', path: 'options', known: OPTIONS }, given);
  const { defaults, smoothing } = given;
  const known = Object.keys(DEFAULT_SMOOTHING);
  if (smoothing !== undefined)
    warnOfUnknown(warn, { code: 'unknown-option', path: 'options.smoothing', known }, smoothing);
  if (defaults !== undefined) checkDefaults(warn, 'options.defaults', defaults);
}

/** Warns of unknown members of the defaults, and of unknown settings. */
export function checkDefaults(warn: Warn, path: string, given: object): void {
  warnOfUnknown(warn, { code: 'unknown-default', path, known: DEFAULTS }, given);
  const { settings, shipClasses, bodies } = given as Partial<Defaults>;
  checkSettings(warn, `${path}.settings`, settings);
  if (Array.isArray(shipClasses)) checkClasses(warn, `${path}.shipClasses`, shipClasses);
  if (Array.isArray(bodies)) checkBodies(warn, bodies as readonly BodyState[]);
}

/** Settings of which less than `least` is another unit. */
const IMPLAUSIBLE = [
  { field: 'contactTippedAngleDeg', least: 3.2, code: 'setting-in-radians', expected: 'degrees are' },
  { field: 'contactSettleTiltDeg', least: 0.35, code: 'setting-in-radians', expected: 'degrees are' },
  { field: 'contactCrashSpeed', least: 0.1, code: 'setting-in-kilometres', expected: 'm/s is' },
] as const;

/** Warns of unknown settings, and of values that look like radians or km/s. */
export function checkSettings(warn: Warn, path: string, settings: unknown): void {
  if (!isRecord(settings)) return;
  const known = Object.keys(DEFAULT_SETTINGS);
  // A loaded record includes its derived constants.
  const naming = {
    code: 'unknown-setting',
    path,
    known: [...known, 'cosSettleTilt', 'cosTippedAngle', 'constants'],
  };
  warnOfUnknown(warn, naming, settings as object);
  for (const { field, least, code, expected } of IMPLAUSIBLE) {
    const value = (settings as Readonly<Record<string, unknown>>)[field];
    if (typeof value === 'number' && value > 0 && value < least)
      warn(code, `${path}.${field} is ${value}: ${expected} expected.`, { field, value });
  }
}
