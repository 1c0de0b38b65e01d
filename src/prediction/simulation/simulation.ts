import {
  BODY_STRIDE,
  type BodyMotion,
  chooseReferenceBody,
  EVENT_CONTACT,
  NO_EVENT,
  ROTATION_INPUT,
  SHIP_STRIDE,
  substep,
  THRUST_LEVEL,
  TRANSLATION_INPUT,
  type World,
  writeBodyMotion,
} from '../../dynamics';
import { applyDue, seek } from '../inputs/scheduledInput';
import {
  type BodyTrack,
  boundaryAt,
  createBodyTrack,
  cutsOf,
  resizedBodies,
  rowsAt,
} from '../snapshots/bodyTrack';
import { predict } from '../events';
import { keep, resized, ringLength } from './history';
import { createInputs, type Inputs, type ScheduledInput } from '../inputs/inputs';
import { wake, wakesOn } from './sleep';
import { easeUprighting } from '../drawn/pose';
import { createTimeline, type Position, spanOf, type Timeline } from '../time/timeline';
import { createLoggedSubstep, logSubstep } from '../touchdown/touchdownLog';
import { keepLog, resizeLogs, type TouchdownRing } from '../touchdown/touchdownRing';
import { copyRow, createFleet, type Fleet, type Track } from './track';
import type { Diagnosis, EventNotice } from '../drawn/view';
import type { Warn } from '../warnings';

/**
 * What is simulated: all ships to one front, the first substep boundary at or after the present that is drawn. Plain data; the
 * predictor owns one and the functions of this folder work on it.
 */
export interface Simulation {
  world: World;
  readonly timeline: Timeline;
  bodies: BodyTrack;
  readonly fleet: Fleet;
  readonly inputs: Inputs;
  readonly front: Position;
  /** Time was cut anew, or jumped: the front is to be put where the present is, and every ship replayed to it. */
  frontIsStale: boolean;
  /** 0 … 1: where the present lies between the substep boundary before the front and the front. */
  alpha: number;
  ringLength: number;
  /** Newest tick a frame was accepted of, -1 before the first. */
  newestTick: number;
  /** Not yet told to listeners. */
  readonly notices: EventNotice[];
  readonly counters: Diagnosis;
  /** Faults of the caller's or the server's that nothing has to stop for. */
  readonly warn: Warn;
  /** Landed ships that agree cost no substep; off while rollbacks are forced, which compare bits. */
  readonly locks: boolean;
}

/** What a simulation is made with, beside its world. */
export interface SimulationOptions {
  readonly counters: Diagnosis;
  readonly warn: Warn;
  readonly locks: boolean;
  /** What the own ship does by itself. */
  readonly plan: readonly ScheduledInput[];
}

/** A simulation of `world` without any ship or time yet. `bodies`: where they are, in the world's order. */
export function createSimulation(
  world: World,
  bodies: readonly BodyMotion[],
  { counters, warn, locks, plan }: SimulationOptions,
): Simulation {
  const start = new Float64Array(bodies.length * BODY_STRIDE);
  for (const [i, motion] of bodies.entries()) writeBodyMotion(start, i * BODY_STRIDE, motion);
  return {
    world,
    timeline: createTimeline(),
    bodies: createBodyTrack(start, ringLength(1), 100),
    fleet: createFleet(),
    inputs: createInputs(plan),
    front: { tick: 0, substep: 0 },
    frontIsStale: true,
    alpha: 1,
    ringLength: ringLength(1),
    newestTick: -1,
    notices: [],
    counters,
    warn,
    locks,
  };
}

/** Makes the rings fit another tick rate; what they hold stays. */
export function fitRings(sim: Simulation, tickRate: number, substeps: number): void {
  const length = ringLength(tickRate);
  if (length !== sim.ringLength) {
    sim.ringLength = length;
    for (const track of sim.fleet.tracks) {
      track.history = resized(track.history, length);
      if (track.log !== null) resizeLogs(track.log, length);
    }
  }
  if (length !== sim.bodies.length || sim.bodies.cuts.length !== cutsOf(substeps))
    sim.bodies = resizedBodies(sim.bodies, length, substeps);
}

/** Steps every ship in step to `target`, which is not before the front. Calls `boundary` at each tick boundary passed. */
export function stepFront(sim: Simulation, target: Position, boundary: (tick: number) => void): void {
  const { front } = sim;
  let cursor = seek(sim.inputs, front.tick, front.substep);
  while (front.tick < target.tick || (front.tick === target.tick && front.substep < target.substep)) {
    cursor = stepOnce(sim, cursor);
    front.substep += 1;
    if (front.substep < spanOf(sim.timeline, front.tick).timing.substeps) continue;
    front.tick += 1;
    front.substep = 0;
    keepBoundary(sim);
    boundary(front.tick);
  }
}

function stepOnce(sim: Simulation, cursor: number): number {
  const { front, timeline } = sim;
  const next = applyOwn(sim, cursor);
  const [dt] = spanOf(timeline, front.tick).step;
  stepShips(sim, rowsAt(sim.bodies, timeline, front.tick, front.substep), dt);
  return next;
}

/** One substep of every ship in step. */
function stepShips(sim: Simulation, bodies: Float64Array, dt: number): void {
  const { fleet, front, world, counters } = sim;
  const { tracks, front: rows } = fleet;
  let stepped = 0;
  for (let i = 0; i < tracks.length; i++) {
    const track = tracks[i]!;
    if (track.mode !== 'stepping') continue;
    track.uprighted = false;
    if (front.substep === 0) beginTick(sim, rows, track.at, front.tick);
    if (isReleased(track, front.tick, front.substep)) release(rows, track.at);
    stepped += 1;
    const event = substep(rows, track.at, bodies, world, dt);
    if (event !== NO_EVENT) {
      happened(sim, track, event, front, track.pass);
      if (event === EVENT_CONTACT) easeUprighting(sim, track, bodies, dt);
    }
    if (track.log !== null) logFront(sim, track.log, track.at, bodies, dt);
  }
  counters.steppedSubsteps += stepped;
}

function logFront(
  { fleet, world }: Simulation,
  log: TouchdownRing,
  at: number,
  bodies: Float64Array,
  dt: number,
): void {
  logged.before = fleet.previous;
  logged.beforeAt = at;
  logged.after = fleet.front;
  logged.at = at;
  logged.bodies = bodies;
  logged.dt = dt;
  logSubstep(log.front, world, logged);
}

const logged = createLoggedSubstep();

/** Own controls that act from the front on; what a landed ship's lock cannot hold wakes it. Returns the cursor behind them. */
function applyOwn(sim: Simulation, cursor: number): number {
  const { fleet, front, inputs } = sim;
  const track = fleet.own;
  if (track?.mode === 'locked') {
    copyRow(probe, 0, fleet.front, track.at);
    if (applyDue(inputs, cursor, front, probe, 0) > cursor && wakesOn(probe, 0)) wake(sim, track);
  }
  fleet.previous.set(fleet.front);
  return track === null ? cursor : applyDue(inputs, cursor, front, fleet.front, track.at);
}

const probe = new Float64Array(SHIP_STRIDE);

function keepBoundary(sim: Simulation): void {
  const { fleet, front } = sim;
  for (const track of fleet.tracks) {
    if (track.mode !== 'stepping') continue;
    keep(track.history, front.tick, fleet.front, track.at);
    if (track.log !== null) keepLog(track.log, front.tick, track.log.front);
  }
}

/** A flying ship re-chooses its reference body at a tick's start, before the tick's own inputs (DYNAMICS, Frame). */
export function beginTick(sim: Simulation, rows: Float64Array, at: number, tick: number): void {
  chooseReferenceBody(rows, at, boundaryAt(sim.bodies, sim.timeline, tick), sim.world);
}

/** Whether another pilot's controls are let go at (tick, substep). */
export function isReleased(track: Track, tick: number, substep: number): boolean {
  return track.releaseTick === tick && track.releaseSubstep === substep;
}

/** Sticks centred and engine off, the attitude mode as it was. */
export function release(rows: Float64Array, at: number): void {
  rows[at + THRUST_LEVEL] = 0;
  for (let k = 0; k < 3; k++) {
    rows[at + TRANSLATION_INPUT + k] = 0;
    rows[at + ROTATION_INPUT + k] = 0;
  }
}

/** Whether a row commands anything that `release` would end. */
export function commandsAnything(rows: Float64Array, at: number): boolean {
  if (rows[at + THRUST_LEVEL] !== 0) return true;
  for (let k = 0; k < 3; k++) {
    if (rows[at + TRANSLATION_INPUT + k] !== 0 || rows[at + ROTATION_INPUT + k] !== 0) return true;
  }
  return false;
}

/** The law reported `event` in the substep that begins at `at`, in pass `pass` over this ship's time. */
export function happened(sim: Simulation, track: Track, event: number, at: Position, pass: number): void {
  const notice = predict(track.ledger, event, at, sim.timeline, pass);
  if (notice !== null) sim.notices.push(notice);
}
