/**
 * Limits of a message, far above the game's values: they refuse only what would overflow a computation, fill the memory or freeze a
 * page.
 */

/** Bytes of a server message; 10,000 ships take 4 MB. */
export const MAX_SERVER_BYTES = 16 * 1024 * 1024;
/** Bytes of a client message; 1000 inputs take 0.12 MB. */
export const MAX_CLIENT_BYTES = 1024 * 1024;

export const MAX_SHIPS = 10_000;
export const MAX_BODIES = 256;
export const MAX_SHIP_CLASSES = 256;
/** Ticks: 1.4 million years at 100 Hz; sums of two are exact. */
export const MAX_TICK = 2 ** 52;
export const MAX_EVENTS = 100_000;
export const MAX_INPUTS = 1000;
/** Characters (UTF-16 units) of a name or an id. */
export const MAX_TEXT = 128;
/** Time scale 100 at 0.1 Hz: a tick of 1000 s in substeps of at least 1 ms (DYNAMICS, Time). */
export const MAX_SUBSTEPS = 1_000_000;

/** A range, both ends included, and its unit for the reason. */
export interface Bound {
  readonly low: number;
  readonly high: number;
  readonly unit: string;
}

export const FINITE: Bound = { low: -Number.MAX_VALUE, high: Number.MAX_VALUE, unit: '' };
/** 100 light years: squares and cubes of it are far from overflow, at either end of a subtraction. */
export const METRES: Bound = { low: -1e18, high: 1e18, unit: 'm' };
export const METRES_PER_SECOND: Bound = { low: -1e9, high: 1e9, unit: 'm/s' };
export const IMPACT_SPEED: Bound = { low: 0, high: 1e9, unit: 'm/s' };
export const RADIANS_PER_SECOND: Bound = { low: -1e6, high: 1e6, unit: 'rad/s' };
/** The heaviest class with the fullest tanks: 1e15 kg each. */
export const SHIP_MASS: Bound = { low: 0, high: 2e15, unit: 'kg' };
/** Height of a ship's centre of mass above its feet. */
export const SHIP_HEIGHT: Bound = { low: 0, high: 1e6, unit: 'm' };
/** Momentum of reaction wheels. */
export const NEWTON_METRE_SECONDS: Bound = { low: -1e25, high: 1e25, unit: 'N m s' };
/** A billion suns. */
export const BODY_MASS: Bound = { low: 0, high: 1e40, unit: 'kg' };
/** Any number of a ship class, in its own unit. */
export const CLASS_FIGURE: Bound = { low: -1e15, high: 1e15, unit: '' };
export const WALL_SECONDS: Bound = { low: -1e9, high: 1e9, unit: 's' };
/** Game time, s since 1970: far beyond the range of ISO 8601. */
export const GAME_SECONDS: Bound = { low: -1e13, high: 1e13, unit: 's' };
