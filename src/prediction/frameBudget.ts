import { POSITION, REFERENCE_BODY } from '../dynamics';
import { MAX_SUBSTEPS_PER_TICK } from './snapshots/bodies/bodyTrack';
import { spanOf } from './time/timeline';
import { abandonReplay, hold, startReplay } from './simulation/replay';
import type { Simulation } from './simulation/simulation';
import { copyRow, type Track } from './simulation/track';

/**
 * Budget of substeps per display frame (PREDICTION, Other ships): when the due substeps exceed it, prediction is switched off for distant
 * ships first, then for all, so that no frame stalls.
 */
export interface FrameBudget {
  /** Substeps of single ships, stepped and replayed, per frame. */
  readonly shipSubsteps: number;
  /** Smoothed number of substeps due per ship and frame, NaN at first: a single long frame switches no ship off. */
  due: number;
}

/** Share of the budget for ships in step; the rest keeps replays going. */
const STEPPING_SHARE = 0.75;
/** A ship is switched on again only below this share of it, so that none flickers. */
const RETURN_SHARE = 0.8;
/** Weight of a new frame in the smoothed due. */
const SMOOTHING = 0.1;
/** A frame with this many times the usual substeps is a hitch. */
const HITCH = 3;

/**
 * Decides, before the front moves by `due` substeps, which ships can follow. The others are switched off or, if only this frame is too
 * long, taken out of step to catch up by replay.
 */
export function keepWithinBudget(sim: Simulation, budget: FrameBudget, due: number): void {
  const hitch = due > HITCH * budget.due;
  budget.due =
    Number.isNaN(budget.due) || hitch
      ? Math.max(1, Math.min(due, budget.due * HITCH || due))
      : budget.due + (due - budget.due) * SMOOTHING;
  const room = Math.floor((budget.shipSubsteps * STEPPING_SHARE) / Math.max(due, 1));
  const usual = Math.floor((budget.shipSubsteps * STEPPING_SHARE) / Math.max(budget.due, 1));
  const tooFine = spanOf(sim.timeline, sim.front.tick).timing.substeps > MAX_SUBSTEPS_PER_TICK;
  if (tooFine || moving(sim) > room) {
    sim.counters.budgetOverruns += 1;
    thinOut(sim, tooFine ? 0 : room, tooFine ? 0 : usual);
  } else switchOn(sim, Math.floor(usual * RETURN_SHARE));
}

function moving(sim: Simulation): number {
  let count = 0;
  for (const track of sim.fleet.tracks) if (track.mode === 'stepping') count += 1;
  return count;
}

/** Takes ships beyond `room` out of step, the farthest first; those beyond `usual` are switched off. */
function thinOut(sim: Simulation, room: number, usual: number): void {
  const stepping = sim.fleet.tracks.filter((track) => track.mode === 'stepping');
  byDistance(sim, stepping);
  for (const [i, track] of stepping.entries()) {
    if (i >= usual) switchOff(track);
    else if (i >= room) catchUpLater(sim, track);
  }
}

function switchOff(track: Track): void {
  abandonReplay(track);
  track.mode = 'held';
  track.picture.hasHeld = false;
  track.off = true;
}

/** Lets the ship continue from its present state by replay as the budget allows; drawn in place until then. */
function catchUpLater(sim: Simulation, track: Track): void {
  if (track.replaying) return;
  const { front, fleet } = sim;
  copyRow(fleet.replayed, track.at, fleet.front, track.at);
  track.log?.replayed.set(track.log.front);
  hold(sim, track);
  track.replaying = true;
  track.replayTick = front.tick;
  track.replaySubstep = front.substep;
  track.replayPass = track.pass;
}

/** Switches the nearest ships on again, from the server's newest state, while fewer than `room` are in step. */
function switchOn(sim: Simulation, room: number): void {
  let free = room;
  let anyOff = false;
  for (const track of sim.fleet.tracks) {
    if (track.off) anyOff = true;
    else if (track.mode !== 'sleeping' && track.policy === 'predict') free -= 1;
  }
  if (!anyOff || free <= 0) return;
  const off = sim.fleet.tracks.filter((track) => track.off);
  byDistance(sim, off);
  for (const track of off.slice(0, free)) {
    track.off = false;
    startReplay(track, sim, track.serverTick, track.serverRow, 0);
  }
}

/** Sorts the player's ship first, then by distance from it; ships of other bodies last. */
function byDistance(sim: Simulation, tracks: Track[]): void {
  const { own } = sim.fleet;
  const distances = new Map(tracks.map((track) => [track, own === null ? 0 : distance(own, track)]));
  tracks.sort((a, b) => distances.get(a)! - distances.get(b)!);
}

function distance(own: Track, other: Track): number {
  if (own === other) return -1;
  const a = own.serverRow;
  const b = other.serverRow;
  if (a[REFERENCE_BODY] !== b[REFERENCE_BODY]) return Number.POSITIVE_INFINITY;
  let sum = 0;
  for (let k = 0; k < 3; k++) sum += (a[POSITION + k]! - b[POSITION + k]!) ** 2;
  return sum;
}
