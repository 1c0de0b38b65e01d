import {
  type Body,
  BODIES,
  type BodyMotion,
  type Settings,
  SHIP_CLASSES,
  type ShipClass,
  type TerrainHeight,
} from '../dynamics';
import type { Smoothing } from './drawn/ease';
import type { ScheduledInput } from './inputs/inputs';
import type { WorldConfig } from './lifecycle/worldConfig';
import type { Warn } from './warnings';

/** A terrain that may be loaded only in part: elsewhere it returns null, and ships are extrapolated from their states. */
export type ClientTerrain = (...place: Parameters<TerrainHeight>) => number | null;

/** Options of a predictor; all are optional. */
export interface PredictorOptions {
  /** Terrains by the name in the hello, in addition to TERRAINS of dynamics. */
  readonly terrains?: Readonly<Record<string, ClientTerrain>>;
  /** The world of a server that sends no hello; by default the game's catalogue and settings. */
  readonly defaults?: Partial<Defaults>;
  /** Ship substeps per frame; 20,000 by default. */
  readonly maxSubstepsPerFrame?: number;
  /** Settle times of the drawn pose after a correction, s; absent ones have their defaults. The prediction is not affected. */
  readonly smoothing?: Partial<Smoothing>;
  /** The player's ship, for a client whose server sends no hello. */
  readonly ownShipId?: string;
  /**
   * Scheduled inputs of the player's ship until its pilot's first input acts, equal to the server's; ascending in time. Until then pass null
   * to `advance`.
   */
  readonly plan?: readonly ScheduledInput[];
  /** Called for each kind of mistake in options, messages or calls, once per code, with the value and what to do. If it throws, it is ignored. */
  readonly onWarning?: Warn;
  /** Test mode: at every tick boundary goes back this many ticks, replays, and compares bits. Counted in the diagnosis. */
  readonly forcedRollback?: number;
}

/** The world of a server that sends no hello. */
export interface Defaults {
  /** Contact settings; absent ones have the game’s defaults. */
  readonly settings: Partial<Settings>;
  /** All classes that ships may have. */
  readonly shipClasses: readonly ShipClass[];
  /** All bodies with their motion at the first frame’s tick. */
  readonly bodies: readonly (Body & BodyMotion)[];
  /** Name of one of the terrains. */
  readonly terrain: string;
}

/** Default of maxSubstepsPerFrame. */
export const BUDGET = 20_000;

/** Ship classes and bodies in place of those that the options do not have. */
export type Catalogue = Pick<Defaults, 'shipClasses' | 'bodies'>;

/** The game's own. */
export const GAME_CATALOGUE: Catalogue = { shipClasses: SHIP_CLASSES, bodies: BODIES };

/** The default world of the options. */
export function defaultWorld(given: Partial<Defaults> | undefined, catalogue?: Catalogue): WorldConfig {
  return {
    settings: given?.settings ?? {},
    shipClasses: given?.shipClasses ?? catalogue?.shipClasses ?? [],
    bodies: given?.bodies ?? catalogue?.bodies ?? [],
    terrain: given?.terrain ?? 'flat',
  };
}
