import { type BodyMotion, EVENT_NAMES, loadTiming } from '../../dynamics';
import type { ServerFrame, ShipState, WorldEvent } from '../../wire';
import { boundaryAt, forgetAfter as forgetBodiesAfter, knowsBoundary, tell } from './bodyTrack';
import { type Clock, forgetSchedule, sampleDown, sentAt, steerByMargin } from '../time/clock';
import { confirm, confirmByState, knownEvent, pruneLedger, retract } from '../events';
import { forgetAfter, has, offsetOf } from '../simulation/history';
import { acknowledge, forgetRecords, type InputFate, prune } from '../inputs/inputs';
import { reconcile, type SnapshotContext } from './reconcile';
import { hold, startReplay } from '../simulation/replay';
import { fitRings, type Simulation } from '../simulation/simulation';
import { WITHDRAWN_SHOWN } from '../drawn/status';
import { setTempo, spanOf, wallOfTick } from '../time/timeline';
import { forgetLogsAfter } from '../touchdown/touchdownRing';
import { addTrack, removeTrack, type Track } from '../simulation/track';

/** What one connection's frames are judged by, beside the simulation. */
export interface Receiver {
  readonly clock: Clock;
  ownShipId: string;
  /** The server tells of events; one that never did is believed by its states. */
  tellsEvents: boolean;
  /** Set aside: a tick that would be a jump, believed when the next frame bears it out. */
  jumpTick: number;
  /** A new connection: the next frame may be of any tick. */
  fresh: boolean;
  /** Ticks of frames taken in, slot = tick mod length. */
  readonly seen: Float64Array;
  acceptedAt: number;
  /** Ships that were taken out by name, with the newest tick then: states of such ticks do not bring them back. */
  readonly removed: Map<string, number>;
}

/** Ships that a frame may bring; more are refused by the wire already. */
const FADE_TICKS = 3;
/** A frame this far ahead of the server's clock is of another time, s. */
const FUTURE = 2;
/** Frames too old are believed, as a server that began anew, when nothing else has come for this long, s. */
const SILENCE = 2;

export function createReceiver(clock: Clock, ownShipId: string): Receiver {
  return {
    clock,
    ownShipId,
    tellsEvents: false,
    jumpTick: -1,
    fresh: true,
    seen: new Float64Array(1024).fill(-1),
    acceptedAt: Number.NEGATIVE_INFINITY,
    removed: new Map(),
  };
}

/** Nothing that was received before says anything of what comes. */
export function forgetPast(receiver: Receiver): void {
  receiver.jumpTick = -1;
  receiver.fresh = true;
  receiver.seen.fill(-1);
  receiver.acceptedAt = Number.NEGATIVE_INFINITY;
  receiver.removed.clear();
}

type Fate = 'newest' | 'again' | 'older' | 'duplicate' | 'tooOld' | 'future' | 'jump';

/** A frame of the world that is simulated: judged, counted, and where it can be used compared with what was predicted. */
export function receiveSnapshot(sim: Simulation, intake: Receiver, frame: ServerFrame, now: number): void {
  const { counters } = sim;
  const timing = loadTiming(frame.tickRate, frame.timeScale, sim.world.settings);
  if (!Number.isSafeInteger(frame.tick) || frame.tick < 0 || !timing.ok) {
    refuse(sim, `frame.${timing.ok ? 'tick: expected a whole number ≥ 0' : timing.reason}`);
    return;
  }
  const fate = fateOf(sim, intake, frame, now);
  if (fate === 'duplicate') counters.framesDuplicate += 1;
  else if (fate === 'tooOld') counters.framesTooOld += 1;
  else if (fate === 'future') counters.framesFromFuture += 1;
  if (fate === 'duplicate' || fate === 'tooOld' || fate === 'future') return;
  counters.framesAccepted += 1;
  intake.seen[frame.tick % intake.seen.length] = frame.tick;
  intake.acceptedAt = now;
  if (fate === 'older') {
    counters.framesOutOfOrder += 1;
    takeOlder(sim, intake, frame, now);
    return;
  }
  if (fate === 'jump') startAnew(sim, intake);
  followTempo(sim, intake, frame, now);
  fitRings(sim, frame.tickRate, spanOf(sim.timeline, frame.tick).timing.substeps);
  takeStates(sim, intake, frame, now);
  settleEvents(sim, intake, frame, now);
  fade(sim);
}

export function refuse(sim: Simulation, reason: string): void {
  sim.counters.framesRefused += 1;
  sim.counters.lastRefusal = reason;
}

function fateOf(sim: Simulation, intake: Receiver, frame: ServerFrame, now: number): Fate {
  const { newestTick } = sim;
  const { tick } = frame;
  if (newestTick < 0) return 'newest';
  if (tick > newestTick) {
    const ahead = (tick - newestTick) / frame.tickRate - (now - intake.acceptedAt);
    if (ahead <= FUTURE) return 'newest';
    return isBorneOut(intake, tick) ? 'jump' : 'future';
  }
  if (tick === newestTick) return isNews(sim, frame) ? 'again' : 'duplicate';
  if (tick <= newestTick - sim.ringLength) {
    const silent = intake.fresh || now - intake.acceptedAt > SILENCE;
    return silent && isBorneOut(intake, tick) ? 'jump' : 'tooOld';
  }
  return intake.seen[tick % intake.seen.length] === tick ? 'duplicate' : 'older';
}

/** A jump in time is believed at once on a new connection, else when a second frame goes on from the first. */
function isBorneOut(intake: Receiver, tick: number): boolean {
  const borneOut =
    intake.fresh || (tick > intake.jumpTick && tick - intake.jumpTick <= 3 && intake.jumpTick >= 0);
  intake.jumpTick = borneOut ? -1 : tick;
  return borneOut;
}

/** The same tick again says something new while time stands still, or when it stops or goes on. */
function isNews(sim: Simulation, frame: ServerFrame): boolean {
  return frame.paused || differs(sim, frame);
}

/** Whether a frame's tempo is another than the one held for its tick. */
function differs(sim: Simulation, { tick, tickRate, timeScale, paused }: ServerFrame): boolean {
  const held = spanOf(sim.timeline, tick);
  return held.paused !== paused || held.tickRate !== tickRate || held.timeScale !== timeScale;
}

/** Another time altogether: nothing that was predicted can be compared with what comes. */
function startAnew(sim: Simulation, intake: Receiver): void {
  sim.counters.resyncs += 1;
  sim.timeline.spans.length = 0;
  forgetRecords(sim.inputs);
  forgetSchedule(intake.clock);
  forgetBodiesAfter(sim.bodies, -1);
  for (const track of sim.fleet.tracks) {
    forgetAfter(track.history, -1);
    if (track.log !== null) forgetLogsAfter(track.log, -1);
    track.ledger.entries.length = 0;
    track.serverTick = -1;
    track.mode = 'waiting';
    track.picture.hasHeld = false;
    track.replaying = false;
    track.replaySnaps = true;
  }
  sim.newestTick = -1;
  sim.frontIsStale = true;
}

/** Clock sample and tempo; where the tempo changed, everything after this tick is to be simulated anew. */
function followTempo(sim: Simulation, intake: Receiver, frame: ServerFrame, now: number): void {
  const { timeline } = sim;
  const first = timeline.spans.length === 0;
  const stood = !first && spanOf(timeline, frame.tick).paused;
  const wall = stood ? wallAfterPause(sim, intake, now) : null;
  if (!stood && !first) sampleDown(intake.clock, wallOfTick(timeline, frame.tick), now);
  const goesOn = stood && !frame.paused;
  const changes = !first && differs(sim, frame);
  // What is drawn now is of the tempo so far.
  if (changes) for (const track of sim.fleet.tracks) if (track.mode === 'stepping') hold(sim, track);
  setTempo(timeline, frame.tick, frame, goesOn || frame.tick > sim.newestTick ? wall : null);
  if (first) sampleDown(intake.clock, 0, now);
  if (changes) retime(sim, frame.tick);
  sim.newestTick = frame.tick;
  intake.fresh = false;
}

/** A paused server's boundaries keep their beat: the one that ended the pause was a whole number of ticks after the one that began it. */
function wallAfterPause(sim: Simulation, intake: Receiver, now: number): number {
  const span = sim.timeline.spans.at(-1)!;
  const beats = Math.round((sentAt(intake.clock, now) - span.fromWall) * span.tickRate);
  return span.fromWall + Math.max(0, beats) / span.tickRate;
}

function retime(sim: Simulation, tick: number): void {
  forgetBodiesAfter(sim.bodies, tick);
  for (const track of sim.fleet.tracks) {
    forgetAfter(track.history, tick);
    if (track.log !== null) forgetLogsAfter(track.log, tick);
    track.replaying = false;
  }
  sim.frontIsStale = true;
}

function takeStates(sim: Simulation, intake: Receiver, frame: ServerFrame, now: number): void {
  const motions = motionsOf(sim, frame);
  word.turned = motions === null ? 0 : tell(sim.bodies, frame.tick, motions);
  word.bodies = boundaryAt(sim.bodies, sim.timeline, frame.tick);
  word.predictedBodies = motions === null ? word.bodies : sim.bodies.replaced;
  word.tick = frame.tick;
  word.now = now;
  word.inputs = 'asPredicted';
  for (const state of frame.ships) takeShip(sim, intake, frame, state);
  for (const track of sim.fleet.tracks) {
    if (track.mode !== 'waiting' || track.replaying || track.off) continue;
    if (has(track.history, frame.tick))
      startReplay(track, sim, frame.tick, track.history.rows, offsetOf(track.history, frame.tick));
    else startReplay(track, sim, track.serverTick, track.serverRow, 0);
  }
}

const word: SnapshotContext = {
  tick: 0,
  now: 0,
  bodies: new Float64Array(0),
  predictedBodies: new Float64Array(0),
  turned: 0,
  inputs: 'asPredicted',
};

function takeShip(sim: Simulation, intake: Receiver, frame: ServerFrame, state: ShipState): void {
  const removedAt = intake.removed.get(state.shipId);
  if (removedAt !== undefined) {
    if (frame.tick <= removedAt) return;
    intake.removed.delete(state.shipId);
  }
  const track = sim.fleet.byId.get(state.shipId) ?? addTrack(sim.fleet, state.shipId, sim.ringLength);
  track.own = state.shipId === intake.ownShipId;
  if (track.own) sim.fleet.own = track;
  word.inputs = track.own ? answered(sim, intake, frame, state) : 'asPredicted';
  const reason = reconcile(sim, track, state, word);
  if (reason === null) return;
  sim.counters.shipsRefused += 1;
  sim.counters.lastRefusal = `frame.ships (${state.shipId}): ${reason}`;
  if (track.serverTick < 0) removeTrack(sim.fleet, track);
}

/** What the frame says of own inputs, also to the steering of the lead. */
function answered(sim: Simulation, intake: Receiver, frame: ServerFrame, state: ShipState): InputFate {
  const { inputs } = sim;
  const told = frame.lastInput;
  const before = inputs.applied;
  const fate = acknowledge(inputs, frame.tick, told, state, word.now);
  if (told !== null && told.seq > before) {
    const stored = inputs.records.find((candidate) => candidate.record.seq === told.seq);
    if (stored !== undefined) steerByMargin(intake.clock, told.margin, stored.steer);
    sim.counters.margin = told.margin;
  }
  prune(inputs, frame.tick - sim.ringLength);
  return fate;
}

/** The frame's bodies in the world's order, or null where one is missing: then the law moves them all. */
function motionsOf(sim: Simulation, frame: ServerFrame): readonly BodyMotion[] | null {
  const { bodies } = sim.world;
  if (frame.bodies.length === bodies.length && frame.bodies.every((body, i) => body.name === bodies[i]!.name))
    return frame.bodies;
  const found = bodies.map(({ name }) => frame.bodies.find((body) => body.name === name));
  return found.every((motion) => motion !== undefined) ? found : null;
}

/** A frame overtaken by newer ones: its events count, and its ships that no newer frame told of. */
function takeOlder(sim: Simulation, intake: Receiver, frame: ServerFrame, now: number): void {
  tellEvents(sim, intake, frame.events);
  if (!knowsBoundary(sim.bodies, frame.tick)) return;
  word.turned = 0;
  word.bodies = boundaryAt(sim.bodies, sim.timeline, frame.tick);
  word.predictedBodies = word.bodies;
  word.tick = frame.tick;
  word.now = now;
  for (const state of frame.ships) {
    const track = sim.fleet.byId.get(state.shipId);
    if (track === undefined || track.serverTick < frame.tick) takeShip(sim, intake, frame, state);
  }
}

function settleEvents(sim: Simulation, intake: Receiver, frame: ServerFrame, now: number): void {
  tellEvents(sim, intake, frame.events);
  for (const track of sim.fleet.tracks) {
    const { ledger } = track;
    if (ledger.entries.length === 0 || track.serverTick !== frame.tick) continue;
    if (!intake.tellsEvents) confirmStates(sim, track, frame);
    for (;;) {
      const notice = retract(ledger, frame.tick, sim.timeline);
      if (notice === null) break;
      sim.notices.push(notice);
      track.picture.status.withdrawn = EVENT_NAMES.indexOf(notice.type);
      track.picture.status.withdrawnUntil = now + WITHDRAWN_SHOWN;
    }
    pruneLedger(ledger, frame.tick - sim.ringLength);
  }
}

function tellEvents(sim: Simulation, intake: Receiver, events: readonly WorldEvent[]): void {
  for (const event of events) {
    const known = knownEvent(event);
    if (known === null) continue;
    intake.tellsEvents = true;
    const track = sim.fleet.byId.get(event.shipId);
    if (track === undefined || event.tick < sim.newestTick - sim.ringLength || event.tick >= sim.newestTick)
      continue;
    const notice = confirm(track.ledger, known.event, known, sim.timeline);
    if (notice !== null) sim.notices.push(notice);
  }
}

function confirmStates(sim: Simulation, track: Track, frame: ServerFrame): void {
  const state = frame.ships.find((candidate) => candidate.shipId === track.shipId)!;
  const shown =
    state.surfaceContactState === '' && state.landedBodyName !== '' ? 'landed' : state.surfaceContactState;
  for (;;) {
    const notice = confirmByState(track.ledger, frame.tick, shown, state.crashed);
    if (notice === null) return;
    sim.notices.push(notice);
  }
}

/** Ships that stop being sent leave the list after 3 ticks. */
function fade(sim: Simulation): void {
  const { tracks } = sim.fleet;
  for (let i = tracks.length - 1; i >= 0; i--) {
    if (sim.newestTick - tracks[i]!.serverTick >= FADE_TICKS) removeTrack(sim.fleet, tracks[i]!);
  }
}
