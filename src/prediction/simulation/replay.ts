import {
  CRASHED,
  EVENT_CONTACT,
  NO_EVENT,
  REFERENCE_BODY,
  SHIP_STRIDE,
  substep,
  VELOCITY,
} from '../../dynamics';
import { applyDue, seek } from '../inputs/scheduledInput';
import { rowsAt } from '../snapshots/bodyTrack';
import { snap } from '../drawn/ease';
import { keep } from './history';
import { addToOffset, type Pose, pose, writeBodyAttitude, writePredicted, writeSeen } from '../drawn/pose';
import { angleOf, lengthOf, quaternion, turnBetween, vector } from '../drawn/rotation';
import { beginTick, happened, isReleased, release, type Simulation } from './simulation';
import { indexOf, spanOf } from '../time/timeline';
import { createLoggedSubstep, logSubstep } from '../touchdown/touchdownLog';
import { rewindLog } from '../touchdown/touchdownRewind';
import { keepLog, type TouchdownRing } from '../touchdown/touchdownRing';
import { copyRow, type Track } from './track';

/**
 * Adopt and replay (PREDICTION, Reconciliation): a ship goes back to a state of a tick and through all stored inputs since. What a
 * frame's budget does not allow goes on in the next one, while the old prediction is drawn and kept in step.
 */

/** Beyond these a correction is not eased: m, and rad. */
const SNAP_DISTANCE = 25;
const SNAP_ANGLE = Math.PI / 3;

/** The ship goes back to the row at `from` in `rows`, which is its state at tick boundary `tick`. */
export function startReplay(
  track: Track,
  sim: Simulation,
  tick: number,
  rows: Float64Array,
  from: number,
): void {
  const { replayed } = sim.fleet;
  rewindLog(track, sim, { tick, rows, from });
  copyRow(replayed, track.at, rows, from);
  keep(track.history, tick, rows, from);
  if (track.mode === 'held') track.mode = 'waiting';
  track.replaying = true;
  track.replayTick = tick;
  track.replaySubstep = 0;
  track.adoptedTick = tick;
  track.replayPass = ++track.passes;
}

/** Forgets a replay under way: a newer state of the server agrees with what is drawn. */
export function abandonReplay(track: Track): void {
  track.replaying = false;
  track.replaySnaps = false;
}

/** Runs replays, the own ship's first, for at most `budget` substeps. Returns how many it took. */
export function runReplays(sim: Simulation, budget: number): number {
  let used = 0;
  for (const track of sim.fleet.tracks)
    if (track.own && track.replaying) used += replay(sim, track, budget - used);
  for (const track of sim.fleet.tracks) if (track.replaying) used += replay(sim, track, budget - used);
  sim.counters.replayedSubsteps += used;
  return used;
}

/** Runs one replay for at most `budget` substeps; where it reaches the front, the ship goes on from there. */
function replay(sim: Simulation, track: Track, budget: number): number {
  const { fleet, front, timeline } = sim;
  const left =
    indexOf(timeline, front.tick, front.substep) - indexOf(timeline, track.replayTick, track.replaySubstep);
  if (left < 0) return 0;
  const steps = Math.min(left, budget);
  if (left === 0) copyRow(beforeLast, 0, fleet.replayed, track.at);
  let cursor = seek(sim.inputs, track.replayTick, track.replaySubstep);
  let uprights = false;
  for (let i = 0; i < steps; i++) {
    if (left - i === 1 || track.log !== null) copyRow(beforeLast, 0, fleet.replayed, track.at);
    at.tick = track.replayTick;
    at.substep = track.replaySubstep;
    cursor = prepare(sim, track, cursor);
    const { step, timing } = spanOf(timeline, at.tick);
    const bodies = rowsAt(sim.bodies, timeline, at.tick, at.substep);
    const event = substep(fleet.replayed, track.at, bodies, sim.world, step[0]);
    if (event !== NO_EVENT) happened(sim, track, event, at, track.replayPass);
    if (track.log !== null) logReplayed(sim, track, track.log, bodies, step[0]);
    uprights = event === EVENT_CONTACT && sim.world.settings.touchdownAttitude === 'aligned';
    track.replaySubstep += 1;
    if (track.replaySubstep < timing.substeps) continue;
    track.replayTick += 1;
    track.replaySubstep = 0;
    keep(track.history, track.replayTick, fleet.replayed, track.at);
    if (track.log !== null) keepLog(track.log, track.replayTick, track.log.replayed);
  }
  if (steps === left) arrive(sim, track, uprights);
  return steps;
}

function logReplayed(
  sim: Simulation,
  track: Track,
  log: TouchdownRing,
  bodies: Float64Array,
  dt: number,
): void {
  logged.before = beforeLast;
  logged.after = sim.fleet.replayed;
  logged.at = track.at;
  logged.bodies = bodies;
  logged.dt = dt;
  logSubstep(log.replayed, sim.world, logged);
}

const logged = createLoggedSubstep();
const at = { tick: 0, substep: 0 };
const beforeLast = new Float64Array(SHIP_STRIDE);

/** What happens to a row before its substep: its reference body at a tick's start, and the controls that act from here on. */
function prepare(sim: Simulation, track: Track, cursor: number): number {
  const { replayed } = sim.fleet;
  if (at.substep === 0) beginTick(sim, replayed, track.at, at.tick);
  if (isReleased(track, at.tick, at.substep)) release(replayed, track.at);
  return track.own ? applyDue(sim.inputs, cursor, at, replayed, track.at) : cursor;
}

/** The replay has reached the front: it is the prediction now, and what was drawn fades into it. */
function arrive(sim: Simulation, track: Track, uprights: boolean): void {
  const { fleet } = sim;
  const wasDrawn = track.mode === 'stepping' || track.hasHeld;
  const oldBody = fleet.front[track.at + REFERENCE_BODY]!;
  const newBody = fleet.replayed[track.at + REFERENCE_BODY]!;
  if (track.hasHeld) {
    old.position.set(track.heldPlace);
    old.attitude.set(track.heldAttitude);
  } else if (wasDrawn) {
    writeSeenPresent(old, sim, track);
  }
  const crashedBefore = fleet.front[track.at + CRASHED]!;
  copyRow(fleet.previous, track.at, beforeLast, 0);
  copyRow(fleet.front, track.at, fleet.replayed, track.at);
  track.log?.front.set(track.log.replayed);
  track.uprighted = uprights;
  track.replaying = false;
  track.pass = track.replayPass;
  track.mode = 'stepping';
  track.hasHeld = false;
  const snaps = track.replaySnaps || oldBody !== newBody || crashedBefore > fleet.front[track.at + CRASHED]!;
  track.replaySnaps = false;
  if (wasDrawn) settleOffset(sim, track, snaps);
  else snap(track.ease);
}

function settleOffset(sim: Simulation, track: Track, snaps: boolean): void {
  const { fleet } = sim;
  writeSeenPresent(now, sim, track);
  if (!snaps && isEasable(fleet.front, track)) {
    addToOffset(track, old, now);
    return;
  }
  snap(track.ease);
  sim.counters.snaps += 1;
}

/**
 * Takes a ship out of step, to be replayed from a state of `tick` to a front elsewhere: what is drawn of it now is held, as seen
 * from the body's axes, until then.
 */
export function hold(sim: Simulation, track: Track): void {
  if (track.mode === 'stepping') {
    writeSeenPresent(old, sim, track);
    track.heldPlace.set(old.position);
    track.heldAttitude.set(old.attitude);
    track.hasHeld = true;
  }
  track.mode = 'waiting';
}

function writeSeenPresent(out: Pose, sim: Simulation, track: Track): void {
  writeBodyAttitude(body, sim, sim.fleet.front[track.at + REFERENCE_BODY]!, sim.alpha);
  writePredicted(out, sim, track);
  writeSeen(out, out, body);
}

/** Within 25 m + speed × the time the server was silent, and within 60°. */
function isEasable(rows: Float64Array, track: Track): boolean {
  for (let k = 0; k < 3; k++) jump[k] = old.position[k]! - now.position[k]!;
  turnBetween(turn, old.attitude, now.attitude);
  let speed = 0;
  for (let k = 0; k < 3; k++) speed += rows[track.at + VELOCITY + k]! * rows[track.at + VELOCITY + k]!;
  const far = SNAP_DISTANCE + Math.sqrt(speed) * track.silence;
  return lengthOf(jump) <= far && angleOf(turn) <= SNAP_ANGLE;
}

const old = pose();
const now = pose();
const body = quaternion();
const turn = quaternion();
const jump = vector();
