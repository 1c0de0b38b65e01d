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
import type { WorldConfig } from './snapshots/worldConfig';
import type { Warn } from './warnings';

/** A terrain that may not be loaded where it is asked: null, and ships there are carried on from their states. */
export type ClientTerrain = (...place: Parameters<TerrainHeight>) => number | null;

/** What a predictor is made with; everything may be left out. */
export interface PredictorOptions {
  /** Terrains by the name the hello tells, beside TERRAINS of dynamics. */
  readonly terrains?: Readonly<Record<string, ClientTerrain>>;
  /** What holds for a server that sends no hello; the game's catalogue and defaults unless given. */
  readonly defaults?: Partial<Defaults>;
  /** Ship substeps a frame may take; 20,000 unless given. */
  readonly maxSubstepsPerFrame?: number;
  /** Settle times of what is drawn after a correction, s; what is left out has the default. What is predicted stays as it is. */
  readonly smoothing?: Partial<Smoothing>;
  /** The own ship of a client whose server sends no hello. */
  readonly ownShipId?: string;
  /**
   * What the own ship does by itself until its pilot's first input acts, as the server was told to let it: in the order of time.
   * Until then `advance` is given null.
   */
  readonly plan?: readonly ScheduledInput[];
  /** Told of each kind of fault in options, messages or calls, once per code, with the value and what to do. May throw: it is ignored. */
  readonly onWarning?: Warn;
  /** Test mode: at every tick boundary go back this many ticks, replay, and compare bits. Counted in the diagnosis. */
  readonly forcedRollback?: number;
}

/** The world of a server that sends no hello. */
export interface Defaults {
  /** Contact settings; what is left out has the game’s default. */
  readonly settings: Partial<Settings>;
  /** All classes that ships may have. */
  readonly shipClasses: readonly ShipClass[];
  /** All bodies with their motion at the first frame’s tick. */
  readonly bodies: readonly (Body & BodyMotion)[];
  /** Name of one of the terrains. */
  readonly terrain: string;
}

/** Ship substeps a frame may take, unless the options say otherwise. */
export const BUDGET = 20_000;

/** The defaults of the options, completed by the game's own catalogue. */
export function defaultWorld(given: Partial<Defaults> | undefined): WorldConfig {
  return {
    settings: given?.settings ?? {},
    shipClasses: given?.shipClasses ?? SHIP_CLASSES,
    bodies: given?.bodies ?? BODIES,
    terrain: given?.terrain ?? 'flat',
  };
}
