import { ok, type Result, type World } from '../dynamics';
import type { ServerFrame, WorldEvent } from '../wire';
import { type Counters, createCounters } from './pilots/counters';
import { type Present } from './pilots/inputQueue';
import { type AuthorityOptions, loadOptions } from './options';
import type { Pilot } from './pilots/pilots';
import type { Plan } from './ships/plans';
import { createSchedule, endOfTick, type Schedule } from './time/schedule';
import { createShipTable, type ShipTable } from './ships/shipTable';
import { createTempo, type Tempo } from './time/tempo';

/** Everything an authority holds between two calls. */
export interface ServerState {
  readonly options: AuthorityOptions;
  readonly world: World;
  /** One row per body of `world`. */
  readonly bodies: Float64Array;
  readonly tempo: Tempo;
  readonly ships: ShipTable;
  /** By player id. */
  readonly pilots: Map<string, Pilot>;
  /** By ship id. */
  readonly plans: Map<string, Plan>;
  readonly counters: Counters;
  readonly schedule: Schedule;
  /** The present tick boundary. */
  tick: number;
  /** Events of the interval that ended at the present boundary. */
  events: WorldEvent[];
  /** The present frame without its acknowledgement, shared by all pilots; null until first requested. */
  frame: Omit<ServerFrame, 'lastInput'> | null;
}

/** The state before the first tick, or a reason that names the first invalid option. */
export function createServerState(options: AuthorityOptions): Result<ServerState> {
  const loaded = loadOptions(options);
  if (!loaded.ok) return loaded;
  const { world, bodies, timing } = loaded.value;
  const tick = options.tick ?? 0;
  return ok({
    options,
    world,
    bodies,
    tempo: createTempo(options.tickRate, options.timeScale, timing, world.settings),
    ships: createShipTable(),
    pilots: new Map(),
    plans: new Map(),
    counters: createCounters(),
    schedule: createSchedule(tick),
    tick,
    events: [],
    frame: null,
  });
}

/** When inputs act: 'tick' for a server like the game's own, which has no substeps. */
export function granularityOf({ legacy, inputGranularity }: AuthorityOptions): 'substep' | 'tick' {
  return legacy ? 'tick' : (inputGranularity ?? 'substep');
}

/** The server's present, for queueing and applying inputs. */
export function presentOf({ options, tempo, schedule, tick }: ServerState): Present {
  const tickRate = tempo.tickRate();
  return {
    tick,
    tickRate,
    granularity: granularityOf(options),
    simulatedAt: (t) => endOfTick(schedule, t, tickRate),
  };
}
