import { BODY_STRIDE, type BodyMotion, type World, setBodyMotion } from '../../dynamics';
import type { Diagnosis } from '../drawn/view';
import { createInputs, type ScheduledInput } from '../inputs/inputs';
import { createBodyTrack } from '../snapshots/bodies/bodyTrack';
import { createCadence } from '../time/cadence';
import { createPosition, createTimeline } from '../time/timeline';
import type { Warn } from '../warnings';
import { ringLength } from './rings/history';
import { createRowStep } from './rowStep';
import type { Features, Simulation } from './simulation';
import { createFleet } from './track';

/** Options of a simulation, in addition to its world. */
export interface SimulationOptions {
  readonly features: Features;
  readonly counters: Diagnosis;
  readonly warn: Warn;
  /** Scheduled inputs of the player's ship. */
  readonly plan: readonly ScheduledInput[];
}

/** Creates a simulation of `world` without ships or time. `bodies` are their motions, in the world's order. */
export function createSimulation(
  world: World,
  bodies: readonly BodyMotion[],
  { features, counters, warn, plan }: SimulationOptions,
): Simulation {
  const start = new Float64Array(bodies.length * BODY_STRIDE);
  const write = features.records?.writeBodyMotion ?? setBodyMotion;
  for (const [i, motion] of bodies.entries()) write(start, i * BODY_STRIDE, motion);
  return {
    world,
    groundless: features.unknownGround?.withoutGround(world) ?? world,
    timeline: createTimeline(world.settings.contactLongestSubstep),
    bodies: createBodyTrack(start, ringLength(1), 100),
    bodiesKnown: true,
    spins: features.spin ? world.bodies.map(features.spin.createBodySpin) : [],
    fleet: createFleet(),
    steps: { front: createRowStep(), replay: createRowStep() },
    inputs: createInputs(plan),
    front: createPosition(),
    frontIsStale: true,
    alpha: 1,
    ringLength: ringLength(1),
    historyRows: ringLength(1),
    cadence: createCadence(),
    newestTick: -1,
    notices: [],
    learning: { tick: -1, spent: 0 },
    features,
    counters,
    warn,
    sleep: features.sleep ?? null,
  };
}
