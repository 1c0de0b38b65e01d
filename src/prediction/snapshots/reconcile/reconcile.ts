import {
  CRASHED,
  FLYING,
  IMPACT_SPEED,
  BODY_ATTITUDE,
  BODY_STRIDE,
  REFERENCE_BODY,
  SHIP_STRIDE,
  SURFACE_STATE,
  WHEEL_MOMENTUM,
} from '../../../dynamics';
import type { ShipState } from '../../../wire';
import { learnFrom, nothingToLearn } from '../learnFrom';
import type { SnapshotContext } from '../snapshotContext';
import { holdLaw } from './lawErrors';
import { adopt, drawableState, isExact, unknownNameOf } from './adopt';
import {
  describeDifference,
  EXACT,
  type Field,
  firstDifference,
  type Place,
  sameCommand,
  type Tolerance,
  writeError,
  writeInexact,
} from './compare';
import { has, offsetOf } from '../../simulation/history';
import { holdSleeping, isAtRest, sleepIfAtRest, sleepAt, writeSleepingAt } from '../../simulation/sleep';
import { createServerStates, keepServerState } from '../../simulation/serverStates';
import { abandonReplay, startReplay } from '../../simulation/replay';
import { commandsAnything } from '../../simulation/heldControls';
import type { Simulation } from '../../simulation/simulation';
import { keepEvidence } from '../../ground/learn';
import { take } from '../../drawn/rotation';
import { isBefore, spanOf, writeLater } from '../../time/timeline';
import { logLanded } from '../../touchdown/touchdownRing';
import { copyRow, type Track } from '../../simulation/track';

/** Sends without news for which other pilots' controls are held. */
const HELD_SENDS = 1.5;
/** Ships are moved along with bodies that turned by more than this, rad. */
const SAME_BODIES = 1e-12;

/**
 * Compares one ship's state in one frame with the prediction for the same tick. If they agree, the local state is kept and nothing is
 * replayed; otherwise the server's is adopted and every stored input since is replayed (PREDICTION, Reconciliation).
 * @returns null, or the reason why the state cannot be used
 */
export function reconcile(
  sim: Simulation,
  track: Track,
  state: ShipState,
  word: SnapshotContext,
): string | null {
  if (word.tick < track.serverTick) return null;
  const reason = adopt(told, state, word.bodies, sim.world);
  if (reason !== null) return reason;
  const known = track.serverTick >= 0;
  if (known && track.serverRow[CRASHED]! > told[CRASHED]!) track.replaySnaps = true;
  const predicted = findPredicted(sim, track, word);
  server.bodies = word.bodies;
  if (track.own) writeError(sim.counters, server, predicted);
  const toldImpact = !Number.isNaN(told[IMPACT_SPEED]);
  if (!toldImpact) told[IMPACT_SPEED] = recalledImpact(predicted);
  track.unpredictable = false;
  if (Number.isNaN(told[WHEEL_MOMENTUM])) recallWheels(predicted);
  track.exact = isExact(state);
  const field = predicted === null ? null : differenceFrom(track, predicted);
  const agrees = field === 'none';
  const goesOver =
    agrees && nothingToLearn(track)
      ? holdLaw(track.fit)
      : learnFrom(sim, track, { row: told, context: word, predicted, agrees, toldImpact });
  remember(track, state, word, known);
  settle(sim, track, word, predicted, field);
  if (goesOver && !track.off) startReplay(track, sim, word.tick, told, 0);
  keepEvidence(track, told, word.tick);
  if (!track.own) holdControls(sim, track);
  return null;
}

/**
 * A ship of an unknown class or surface state, or one that is not to be predicted: it is drawn at its server state and not simulated.
 * @returns null, or the reason why the state cannot be used
 */
export function showAsTold(
  sim: Simulation,
  track: Track,
  state: ShipState,
  word: SnapshotContext,
): string | null {
  if (word.tick < track.serverTick) return null;
  const reason = adopt(told, drawableState(state, sim.world), word.bodies, sim.world);
  if (reason !== null) return reason;
  if (Number.isNaN(told[WHEEL_MOMENTUM])) recallWheels(null);
  if (Number.isNaN(told[IMPACT_SPEED])) told[IMPACT_SPEED] = 0;
  remember(track, state, word, track.serverTick >= 0);
  abandonReplay(track);
  track.unpredictable = unknownNameOf(state, sim.world) !== null;
  track.mode = 'held';
  if (track.policy === 'predict') track.picture.hasHeld = false;
  if (track.policy !== 'interpolate') track.states = null;
  else keepServerState((track.states ??= createServerStates()), word.tick, told, word.bodies);
  return null;
}

function differenceFrom(track: Track, predicted: Place): Field {
  if (!track.exact) writeInexact(inexact, server);
  return firstDifference(server, predicted, track.exact ? EXACT : inexact);
}

/**
 * Confirms or adopts the state.
 * @param predicted the prediction for its tick, and `field`, the first in which the state differs; null for none
 */
function settle(
  sim: Simulation,
  track: Track,
  word: SnapshotContext,
  predicted: Place | null,
  field: Field | null,
): void {
  if (track.off) {
    if (isAtRest(told, 0)) sleepAtFirst(sim, track, word);
    return;
  }
  if (predicted === null || field === null) {
    startReplay(track, sim, word.tick, told, 0);
    sleepAtFirst(sim, track, word);
    return;
  }
  const commanded = sameCommand(told, 0, predicted.rows, predicted.at);
  if (field !== 'none' || !(commanded || sleepsThrough(track))) {
    correct(sim, track, field, predicted, word);
    return;
  }
  if (track.own && word.inputs !== 'asPredicted' && track.mode !== 'sleeping') {
    correct(sim, track, field, predicted, word);
    return;
  }
  track.agreedTick = word.tick;
  agree(sim, track, word);
}

/** Equal: the local state is kept. */
function agree(sim: Simulation, track: Track, word: SnapshotContext): void {
  const { front } = sim;
  if (track.mode === 'sleeping') {
    sleepAt(track, word.bodies);
    if (!track.own) copyRow(sim.fleet.front, track.at, told, 0);
    return;
  }
  // The replay is not done: what agreed is the prediction that it would replace.
  if (track.replaying && isBefore(track.replayTick, track.replaySubstep, word.tick, 0)) abandonReplay(track);
  if (track.replaying) return;
  if (sleepIfAtRest(sim, track, word.bodies)) return;
  const letGo = isBefore(track.releaseTick, track.releaseSubstep, front.tick, front.substep);
  const wasReleased = !track.own && track.releaseTick >= 0 && letGo && commandsAnything(told, 0);
  if (wasReleased || word.turned > SAME_BODIES) startReplay(track, sim, word.tick, told, 0);
}

/** Not equal: counted by its cause, adopted, replayed. */
function correct(sim: Simulation, track: Track, field: Field, predicted: Place, word: SnapshotContext): void {
  const { counters } = sim;
  if (track.own && word.inputs === 'late') counters.correctionsLateInput += 1;
  else if (track.own && word.inputs === 'lost') counters.correctionsLostInput += 1;
  else if (!sameCommand(told, 0, predicted.rows, predicted.at)) counters.correctionsOtherPilot += 1;
  else {
    counters.correctionsMismatch += 1;
    counters.lastMismatch = `${track.shipId} at tick ${word.tick}: ${describeDifference(field, server, predicted)}`;
  }
  if (track.mode === 'sleeping') holdSleeping(track);
  startReplay(track, sim, word.tick, told, 0);
}

/** A ship first seen landed: it sleeps at once, drawn at its server state. */
function sleepAtFirst(sim: Simulation, track: Track, word: SnapshotContext): void {
  if (!sim.sleeps || track.mode === 'stepping' || track.picture.hasHeld || !isAtRest(told, 0)) return;
  track.off = false;
  copyRow(sim.fleet.front, track.at, told, 0);
  copyRow(sim.fleet.previous, track.at, told, 0);
  abandonReplay(track);
  if (track.log !== null) logLanded(track.log);
  sleepIfAtRest(sim, track, word.bodies);
}

/** Commands that do not wake a sleeping ship: they neither burn nor lift. */
function sleepsThrough(track: Track): boolean {
  return track.mode === 'sleeping' && isAtRest(told, 0);
}

function findPredicted(sim: Simulation, track: Track, word: SnapshotContext): Place | null {
  if (track.mode === 'sleeping') {
    copyRow(asleep, 0, sim.fleet.front, track.at);
    writeSleepingAt(asleep, 0, track, word.bodies);
    posed.bodies = word.bodies;
    return posed;
  }
  if (track.mode === 'held' || !has(track.history, word.tick)) return null;
  kept.rows = track.history.rows;
  kept.at = offsetOf(track.history, word.tick);
  kept.bodies = word.predictedBodies;
  return kept;
}

/** The impact speed of this contact from the ship's own history; otherwise 0, settling. */
function recalledImpact(predicted: Place | null): number {
  if (predicted === null) return 0;
  const { rows, at } = predicted;
  const sameContact =
    rows[at + SURFACE_STATE] !== FLYING && rows[at + REFERENCE_BODY] === told[REFERENCE_BODY];
  return sameContact ? rows[at + IMPACT_SPEED]! : 0;
}

/** The wheels' momentum from the ship's own history; otherwise none. */
function recallWheels(predicted: Place | null): void {
  for (let k = WHEEL_MOMENTUM; k < WHEEL_MOMENTUM + 3; k++)
    told[k] = predicted === null ? 0 : predicted.rows[predicted.at + k]!;
}

function remember(track: Track, state: ShipState, word: SnapshotContext, known: boolean): void {
  track.name = state.name;
  track.playerId = state.playerId;
  track.silence = known ? Math.max(0, word.now - track.seenAt) : 0;
  track.seenAt = word.now;
  track.serverTick = word.tick;
  copyRow(track.serverRow, 0, told, 0);
  take(track.serverBodyAttitude, word.bodies, told[REFERENCE_BODY]! * BODY_STRIDE + BODY_ATTITUDE);
}

/** Another pilot's last known controls apply for 1.5 send intervals from the present on; then they are released. */
function holdControls(sim: Simulation, track: Track): void {
  const { timeline, front } = sim;
  const substeps = Math.ceil(
    HELD_SENDS * Math.max(1, sim.cadence.ticks) * spanOf(timeline, front.tick).timing.substeps,
  );
  writeLater(later, timeline, front.tick, front.substep, substeps);
  track.releaseTick = later.tick;
  track.releaseSubstep = later.substep;
}

const later = { tick: 0, substep: 0 };
const told = new Float64Array(SHIP_STRIDE);
const server: Place = { rows: told, at: 0, bodies: told };
const inexact: Tolerance = new Float64Array(3);
const asleep = new Float64Array(SHIP_STRIDE);
const posed: Place = { rows: asleep, at: 0, bodies: asleep };
const kept: Place = { rows: told, at: 0, bodies: told };
