import {
  CRASHED,
  IMPACT_SPEED,
  BODY_ATTITUDE,
  BODY_STRIDE,
  REFERENCE_BODY,
  WHEEL_MOMENTUM,
} from '../../../dynamics';
import type { ShipState } from '../../../wire';
import type { Compared, SnapshotContext } from '../snapshotContext';
import { adopt, drawableState, isExact, unknownNameOf } from './adopt';
import { EXACT, type Field, firstDifference, type Place, writeError, writeInexact } from './compare';
import { sameCommand } from '../../inputs/command';
import { recalledImpact, recallWheels } from './recall';
import { has, offsetOf } from '../../simulation/rings/history';
import { abandonReplay, startReplay } from '../../simulation/replay';
import { commandsAnything } from '../../simulation/heldControls';
import type { Simulation } from '../../simulation/simulation';
import { keepState } from '../../ground/lastState';
import { take } from '../../drawn/rotation';
import { addSubsteps, createPosition, isBefore, spanOf } from '../../time/timeline';
import { copyRow, type Track } from '../../simulation/track';

/** Sends for which other pilots' controls are held without news. */
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
  context: SnapshotContext,
): string | null {
  if (context.tick < track.serverTick) return null;
  const { server } = context.compared;
  const sent = server.rows;
  const reason = adopt(sent, state, context.bodies, sim.world);
  if (reason !== null) return reason;
  const known = track.serverTick >= 0;
  const respawned = known && track.serverRow[CRASHED]! > sent[CRASHED]!;
  if (respawned) track.replaySnaps = true;
  track.unpredictable = false;
  track.exact = isExact(state);
  const predicted = findPredicted(sim, track, context);
  server.bodies = context.bodies;
  if (track.own) writeError(sim.counters, server, predicted);
  const hasImpact = !Number.isNaN(sent[IMPACT_SPEED]);
  if (!hasImpact)
    sent[IMPACT_SPEED] = recalledImpact(sim, track, { row: sent, tick: context.tick }, predicted);
  if (Number.isNaN(sent[WHEEL_MOMENTUM])) recallWheels(sent, predicted);
  const field = predicted === null ? null : differenceFrom(track, context.compared, predicted);
  const agrees = field === 'none';
  const { learning } = sim.features;
  const lawChanges =
    agrees && nothingToLearn(track)
      ? learning?.holdLaw(track.fit)
      : learning?.learnFrom(sim, track, { row: sent, context, predicted, agrees, hasImpact });
  remember(track, state, context, known);
  confirmOrCorrect(sim, track, context, predicted, field);
  if (lawChanges === true && !track.off) startReplay(track, sim, context.tick, sent, 0);
  keepState(track.evidence, sent, context.tick);
  if (!track.own) holdControls(sim, track);
  return null;
}

/**
 * Shows a ship at its server state without simulating it: its class or surface state is unknown, or it is not to be predicted.
 * @returns null, or the reason why the state cannot be used
 */
export function showServerState(
  sim: Simulation,
  track: Track,
  state: ShipState,
  context: SnapshotContext,
): string | null {
  if (context.tick < track.serverTick) return null;
  const sent = context.compared.server.rows;
  const reason = adopt(sent, drawableState(state, sim.world), context.bodies, sim.world);
  if (reason !== null) return reason;
  if (Number.isNaN(sent[WHEEL_MOMENTUM])) recallWheels(sent, null);
  if (Number.isNaN(sent[IMPACT_SPEED])) sent[IMPACT_SPEED] = 0;
  remember(track, state, context, track.serverTick >= 0);
  abandonReplay(track);
  track.unpredictable = unknownNameOf(state, sim.world) !== null;
  track.mode = 'held';
  if (track.policy === 'predict') track.picture.hasHeld = false;
  if (track.policy !== 'interpolate') track.states = null;
  else sim.features.keepServerState?.(sim, track, sent, context);
  return null;
}

/** Whether there is nothing to learn from a state that was predicted correctly: no learned ground, and the dynamics fit. */
function nothingToLearn({ ground, fit }: Track): boolean {
  return ground.places.length === 0 && fit.extrapolated === '' && !fit.bounces;
}

function differenceFrom(track: Track, { server, inexact }: Compared, predicted: Place): Field {
  if (!track.exact) writeInexact(inexact, server);
  return firstDifference(server, predicted, track.exact ? EXACT : inexact);
}

/**
 * Keeps the prediction if the state confirms it; otherwise adopts the state.
 * @param predicted the prediction for its tick, null for none; `field` is the first in which the state differs
 */
function confirmOrCorrect(
  sim: Simulation,
  track: Track,
  context: SnapshotContext,
  predicted: Place | null,
  field: Field | null,
): void {
  const sent = context.compared.server.rows;
  if (track.off || predicted === null || field === null) {
    if (!track.off) {
      sim.sleep?.holdSleeping(track);
      startReplay(track, sim, context.tick, sent, 0);
    }
    sim.sleep?.sleepAtFirst(sim, track, context.bodies);
    return;
  }
  const agrees =
    field === 'none' &&
    (sameCommand(sent, 0, predicted.rows, predicted.at) || sim.sleep?.sleepsThrough(track, sent));
  const isApplied = !track.own || context.inputs === 'asPredicted' || track.mode === 'sleeping';
  if (!agrees || !isApplied) {
    correct(sim, track, field, predicted, context);
    return;
  }
  track.agreedTick = context.tick;
  keepPrediction(sim, track, context);
}

/** The states are equal: the local one is kept. */
function keepPrediction(sim: Simulation, track: Track, context: SnapshotContext): void {
  const { front } = sim;
  const sent = context.compared.server.rows;
  if (sim.sleep?.sleepsOn(sim, track, context.bodies)) return;
  // The replay is not done: the prediction that it would replace agrees.
  if (track.replaying && isBefore(track.replayTick, track.replaySubstep, context.tick, 0))
    abandonReplay(track);
  if (track.replaying) return;
  if (sim.sleep?.sleepIfAtRest(sim, track, context.bodies)) return;
  const isDue = isBefore(track.releaseTick, track.releaseSubstep, front.tick, front.substep);
  const wasReleased = !track.own && track.releaseTick >= 0 && isDue && commandsAnything(sent, 0);
  if (wasReleased || context.turned > SAME_BODIES) startReplay(track, sim, context.tick, sent, 0);
}

/** The states differ: counts the correction by its cause, adopts the state, replays. */
function correct(
  sim: Simulation,
  track: Track,
  field: Field,
  predicted: Place,
  context: SnapshotContext,
): void {
  const { counters } = sim;
  const { server } = context.compared;
  const sent = server.rows;
  if (track.own && context.inputs === 'late') counters.correctionsLateInput += 1;
  else if (track.own && context.inputs === 'lost') counters.correctionsLostInput += 1;
  else if (!sameCommand(sent, 0, predicted.rows, predicted.at)) counters.correctionsOtherPilot += 1;
  else {
    counters.correctionsMismatch += 1;
    counters.lastMismatch = `${track.shipId} at tick ${context.tick}: ${sim.features.describeDifference?.(field, server, predicted) ?? field}`;
  }
  sim.sleep?.holdSleeping(track);
  startReplay(track, sim, context.tick, sent, 0);
}

function findPredicted(sim: Simulation, track: Track, context: SnapshotContext): Place | null {
  const { asleep, kept } = context.compared;
  if (track.mode === 'sleeping' && sim.sleep !== null)
    return sim.sleep.placeAsleep(asleep, sim, track, context);
  if (track.mode === 'held' || !has(track.history, context.tick)) return null;
  kept.rows = track.history.rows;
  kept.at = offsetOf(track.history, context.tick);
  kept.bodies = context.predictedBodies;
  return kept;
}

function remember(track: Track, state: ShipState, context: SnapshotContext, known: boolean): void {
  const sent = context.compared.server.rows;
  track.name = state.name;
  track.playerId = state.playerId;
  track.silence = known ? Math.max(0, context.now - track.seenAt) : 0;
  track.seenAt = context.now;
  track.serverTick = context.tick;
  copyRow(track.serverRow, 0, sent, 0);
  take(track.serverBodyAttitude, context.bodies, sent[REFERENCE_BODY]! * BODY_STRIDE + BODY_ATTITUDE);
}

/** Another pilot's last known controls apply for 1.5 send intervals from the present on; then they are released. */
function holdControls(sim: Simulation, track: Track): void {
  const { timeline, front } = sim;
  const substeps = Math.ceil(
    HELD_SENDS * Math.max(1, sim.cadence.ticks) * spanOf(timeline, front.tick).timing.substeps,
  );
  addSubsteps(later, timeline, front.tick, front.substep, substeps);
  track.releaseTick = later.tick;
  track.releaseSubstep = later.substep;
}

const later = createPosition();
