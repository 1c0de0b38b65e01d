import {
  type BodyMotion,
  type faultOfConstants,
  flatTerrain,
  type TerrainHeight,
  type TerrainNormals,
  type World,
} from '../dynamics';
import type { Hello, PartialFrame, Pong } from '../wire';
import { guardTerrain } from './ground/guardTerrain';
import { createDiagnosis } from './diagnosis';
import { springsOf } from './drawn/ease';
import type { Diagnosis, EventNotice } from './drawn/view';
import type { ViewFeatures } from './drawn/viewContext';
import { createViewBuilder, type ViewBuilder } from './drawn/worldView';
import { createPilot, type Pilot } from './inputs/pilot';
import { createSending, type Sending } from './inputs/sending';
import { BUDGET, type Catalogue, defaultWorld, type PredictorOptions } from './options';
import type { Features, Simulation } from './simulation/simulation';
import { createSimulation } from './simulation/createSimulation';
import type { PendingFrames } from './snapshots/pendingFrames';
import { createReceiver, forgetPast, type Receiver } from './snapshots/receiver';
import { loadConfig, type WorldConfig } from './lifecycle/worldConfig';
import { type Clock, createClock, forgetSchedule } from './time/clock';
import type { FrameBudget, keepWithinBudget } from './frameBudget';
import { createPings, type Pings } from './time/pings';
import { createWarn, type Warn } from './warnings';

/** The optional parts of a predictor, as the session calls them. */
export interface SessionFeatures extends Features, ViewFeatures {
  /** Takes the hello of a server that sends one. */
  readonly receiveHello?: (session: Session, hello: Hello, now: number) => void;
  readonly receivePong?: (session: Session, pong: Pong, now: number) => void;
  readonly catalogue?: Catalogue;
  readonly terrainNormals?: TerrainNormals;
  /** Warns of data that needs a feature which the predictor does not have. */
  readonly checkFeatures?: (session: Session, frame: PartialFrame) => void;
  /** Calls the listeners with the events. */
  readonly announce?: (session: Session) => void;
  /** Checks the settings and classes of a world. */
  readonly faultOfConstants?: typeof faultOfConstants;
  /** Keeps frames within the budget of substeps. */
  readonly keepWithinBudget?: typeof keepWithinBudget;
  readonly pingIfDue?: (pings: Pings, now: number) => void;
}

/** Everything one predictor owns. The functions of this folder work on it; nothing is shared between two predictors. */
export interface Session {
  readonly terrains: Readonly<Record<string, TerrainHeight>>;
  readonly defaults: WorldConfig;
  readonly options: PredictorOptions;
  readonly features: SessionFeatures;
  readonly warn: Warn;
  readonly counters: Diagnosis;
  readonly clock: Clock;
  readonly receiver: Receiver;
  readonly pilot: Pilot;
  readonly pings: Pings;
  readonly sending: Sending;
  /** Null until a message waits undecoded. */
  pending: PendingFrames | null;
  readonly budget: FrameBudget;
  readonly listeners: Set<(notice: EventNotice) => void>;
  sim: Simulation;
  viewBuilder: ViewBuilder;
  /** The world in force: the defaults until a hello has another. */
  config: WorldConfig;
  granularity: Hello['inputGranularity'];
  /** s by which the caller's clock has been set back so far; client wall s are its reading plus this. */
  setBack: number;
  /** Client wall s of the last `advance`; NaN before the first. */
  advancedAt: number;
  /** Usual client wall s between two calls of `advance`. */
  usualGap: number;
}

/** A predictor's state before anything was received. Throws RangeError that names the invalid part of the default world. */
export function createSession(options: PredictorOptions, features: SessionFeatures): Session {
  const warn = createWarn(options.onWarning);
  const terrains = terrainsOf(options, features, warn);
  const defaults = defaultWorld(options.defaults, features.catalogue);
  for (const name of ['shipClasses', 'bodies'] as const)
    if (defaults[name].length === 0)
      throw new RangeError(
        `defaults.${name}: expected at least one; a lean predictor has the game's with the feature gameCatalogue`,
      );
  const world = loadConfig(defaults, { terrains, features });
  if (!world.ok) throw new RangeError(`defaults: ${world.reason}`);
  const counters = createDiagnosis();
  const clock = createClock();
  const sim = newSimulation(world.value, defaults.bodies, { options, features, counters, warn });
  return {
    terrains,
    defaults,
    options,
    features,
    warn,
    counters,
    clock,
    receiver: createReceiver(clock, options.ownShipId ?? ''),
    pilot: createPilot(),
    pings: createPings(),
    sending: createSending(),
    pending: null,
    budget: { shipSubsteps: options.maxSubstepsPerFrame ?? BUDGET, due: Number.NaN },
    listeners: new Set(),
    sim,
    viewBuilder: createViewBuilder(sim, springsOf(options.smoothing), features),
    config: defaults,
    granularity: 'tick',
    setBack: 0,
    advancedAt: Number.NaN,
    usualGap: Number.NaN,
  };
}

/** The terrains that a hello or the defaults may name. Unknown ground (null) counts as 0 in sums; no ship is predicted on it (knowsGround). */
function terrainsOf(
  { terrains = {} }: PredictorOptions,
  { terrains: known = { flat: flatTerrain } }: Features,
  warn: Warn,
): Readonly<Record<string, TerrainHeight>> {
  const guarded = Object.entries(terrains).map(([name, terrain]) => [
    name,
    guardTerrain(terrain, name, warn),
  ]);
  return { ...known, ...(Object.fromEntries(guarded) as Record<string, TerrainHeight>) };
}

function newSimulation(
  world: World,
  bodies: readonly BodyMotion[],
  { options, features, counters, warn }: Pick<Session, 'options' | 'features' | 'counters' | 'warn'>,
): Simulation {
  return createSimulation(world, bodies, { features, counters, warn, plan: options.plan ?? [] });
}

/** Clears all ships and the timeline of the previous world; listeners stay. */
export function beginWorld(session: Session, world: World, bodies: readonly BodyMotion[]): void {
  session.sim = newSimulation(world, bodies, session);
  session.viewBuilder = createViewBuilder(
    session.sim,
    springsOf(session.options.smoothing),
    session.features,
  );
  forgetSchedule(session.clock);
  forgetPast(session.receiver);
}

/** Calls each listener; one that throws does not affect the others. */
export function announce({ sim, listeners, warn }: Session): void {
  if (sim.notices.length === 0) return;
  for (const notice of sim.notices.splice(0)) {
    for (const listener of listeners) {
      try {
        listener(notice);
      } catch (error) {
        const details = { notice, error: String(error) };
        warn('listener-threw', 'An event listener threw: fix it. The other listeners were called.', details);
      }
    }
  }
}
