import { cosineOfDegrees } from '../arithmetic/angles';
import { ok, type Result, notFinite, err } from '../result';
import { outside, SPEED, SPIN_SPEED } from './limits';

/** The server's contact settings under the design's names (DYNAMICS, Settings). SI units, degrees where the name says so. */
export interface Settings {
  /** Impact speed above which a ship crashes, m/s. */
  readonly contactCrashSpeed: number;
  /** Impact speed up to which a ship settles without a bounce, m/s. */
  readonly contactBounceSpeed: number;
  /** Tilt up to which a ship counts as landed, degrees. */
  readonly contactSettleTiltDeg: number;
  /** rad/s */
  readonly contactSettleAngularVel: number;
  /** m/s */
  readonly contactSettleLinearVel: number;
  /** Tilt from which a ship counts as tipped, degrees. */
  readonly contactTippedAngleDeg: number;
  /** ζ of a bouncing impact. */
  readonly contactDampingRatio: number;
  /** Coefficient up to which feet hold. */
  readonly contactFrictionStatic: number;
  /** Coefficient of sliding feet. */
  readonly contactFrictionKinetic: number;
  /** Effect of a touch on attitude and spin: aligned with the surface normal and zeroed, or kept. */
  readonly touchdownAttitude: 'aligned' | 'kept';
  /** Direction of the normal force: radial, as on a sphere, or normal to the slope under the feet. */
  readonly surfaceNormal: 'radial' | 'terrain';
  /** Game seconds: a tick is divided into equal substeps of at most this length. */
  readonly contactLongestSubstep: number;
}

export const DEFAULT_SETTINGS: Settings = Object.freeze({
  contactCrashSpeed: 50,
  contactBounceSpeed: 10,
  contactSettleTiltDeg: 5,
  contactSettleAngularVel: 0.01,
  contactSettleLinearVel: 0.5,
  contactTippedAngleDeg: 80,
  contactDampingRatio: 0.3,
  contactFrictionStatic: 0.8,
  contactFrictionKinetic: 0.5,
  touchdownAttitude: 'aligned',
  surfaceNormal: 'radial',
  contactLongestSubstep: 0.01,
});

/** Bounds of contactLongestSubstep, game seconds. With longer substeps, ships with very unequal moments of inertia oscillate on their legs. */
const MIN_SUBSTEP = 0.001;
const MAX_SUBSTEP = 0.022;

/** Checked settings with derived constants: angles as cosines. */
export interface LoadedSettings extends Settings {
  /** Cosine of contactSettleTiltDeg. @internal */
  readonly cosSettleTilt: number;
  /** Cosine of contactTippedAngleDeg. @internal */
  readonly cosTippedAngle: number;
  /** Values that a substep reads; columns in constantRows.ts. */
  readonly constants: Float64Array;
}

/** Loads settings; absent ones get their defaults. The error names the first setting out of range, and its range. */
export function loadSettings(given: Partial<Settings>): Result<LoadedSettings> {
  const reason = faultOfSettings(given);
  return reason === null ? ok(deriveSettings(given)) : err(reason);
}

/** The first setting that is unknown or out of range, and its range; null if there is none. */
export function faultOfSettings(given: Partial<Settings>): string | null {
  const s: Settings = { ...DEFAULT_SETTINGS, ...given };
  for (const [name, value] of Object.entries(s)) {
    if (name === 'touchdownAttitude' || name === 'surfaceNormal') continue;
    if (!(name in DEFAULT_SETTINGS)) return `${name}: no such setting`;
    const reason = notFinite(name, value);
    if (reason !== null) return reason;
  }
  return firstOutOfRange(s);
}

/** Settings known to be in range, with derived constants; absent ones get their defaults. */
export function deriveSettings(given: Partial<Settings>): LoadedSettings {
  const s: Settings = { ...DEFAULT_SETTINGS, ...given };
  const loaded = {
    ...s,
    cosSettleTilt: cosineOfDegrees(s.contactSettleTiltDeg),
    cosTippedAngle: cosineOfDegrees(s.contactTippedAngleDeg),
  };
  return Object.freeze({ ...loaded, constants: constantsOf(loaded) });
}

/** Row of the settings, in the order of constantRows.ts. */
function constantsOf(s: Omit<LoadedSettings, 'constants'>): Float64Array {
  return Float64Array.of(
    ...[s.contactCrashSpeed, s.contactBounceSpeed, s.contactSettleAngularVel, s.contactSettleLinearVel],
    ...[s.contactDampingRatio, s.contactFrictionStatic, s.contactFrictionKinetic],
    ...[s.cosSettleTilt, s.cosTippedAngle],
    ...[s.touchdownAttitude === 'aligned' ? 1 : 0, s.surfaceNormal === 'terrain' ? 1 : 0],
  );
}

function firstOutOfRange(s: Settings): string | null {
  const attitude: string = s.touchdownAttitude;
  const normal: string = s.surfaceNormal;
  const ranges: readonly (readonly [keyof Settings, boolean, string])[] = [
    ['contactCrashSpeed', s.contactCrashSpeed > 0, '> 0 m/s'],
    ['contactBounceSpeed', s.contactBounceSpeed > 0, '> 0 m/s'],
    [
      'contactBounceSpeed',
      s.contactBounceSpeed < s.contactCrashSpeed,
      `< contactCrashSpeed (${String(s.contactCrashSpeed)} m/s)`,
    ],
    ['contactSettleAngularVel', s.contactSettleAngularVel > 0, '> 0 rad/s'],
    ['contactSettleLinearVel', s.contactSettleLinearVel > 0, '> 0 m/s'],
    ['contactTippedAngleDeg', s.contactTippedAngleDeg > 0, '> 0°'],
    ['contactTippedAngleDeg', s.contactTippedAngleDeg < 90, '< 90°'],
    ['contactSettleTiltDeg', s.contactSettleTiltDeg > 0, '> 0°'],
    [
      'contactSettleTiltDeg',
      s.contactSettleTiltDeg < s.contactTippedAngleDeg,
      `< contactTippedAngleDeg (${String(s.contactTippedAngleDeg)}°)`,
    ],
    ['contactDampingRatio', s.contactDampingRatio > 0 && s.contactDampingRatio <= 1, '> 0 and ≤ 1'],
    ['contactFrictionStatic', s.contactFrictionStatic >= 0 && s.contactFrictionStatic <= 2, '≥ 0 and ≤ 2'],
    [
      'contactFrictionKinetic',
      s.contactFrictionKinetic >= 0 && s.contactFrictionKinetic <= s.contactFrictionStatic,
      `≥ 0 and ≤ contactFrictionStatic (${String(s.contactFrictionStatic)})`,
    ],
    ['touchdownAttitude', attitude === 'aligned' || attitude === 'kept', "'aligned' or 'kept'"],
    ['surfaceNormal', normal === 'radial' || normal === 'terrain', "'radial' or 'terrain'"],
    [
      'contactLongestSubstep',
      s.contactLongestSubstep >= MIN_SUBSTEP && s.contactLongestSubstep <= MAX_SUBSTEP,
      `${MIN_SUBSTEP} … ${MAX_SUBSTEP} s`,
    ],
  ];
  for (const [name, inRange, range] of ranges) {
    if (!inRange) return `${name}: expected ${range}, got ${String(s[name])}`;
  }
  return (
    outside('contactCrashSpeed', s.contactCrashSpeed, SPEED) ??
    outside('contactSettleAngularVel', s.contactSettleAngularVel, SPIN_SPEED) ??
    outside('contactSettleLinearVel', s.contactSettleLinearVel, SPEED)
  );
}
