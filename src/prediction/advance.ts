import type { Controls } from '../dynamics';
import { placePresent } from './drawn/worldView';
import { sampleControls } from './inputs/pilot';
import type { Session } from './session';
import { runReplays } from './simulation/replay';
import { stepFront } from './simulation/front';
import type { Simulation } from './simulation/simulation';
import { isFarBehind, realign } from './snapshots/reconcile/realign';
import { horizonOf } from './time/cadence';
import { answersPings, leadOf } from './time/clock';
import { advanceClock } from './time/present';
import {
  createPosition,
  indexOf,
  type Moment,
  type Position,
  spanOf,
  wallOfTick,
  addSubsteps,
  writeMoment,
} from './time/timeline';

/** s: after a longer gap the page was hidden or stalled; it resynchronises once and replays nothing. */
const LONG_GAP = 1;
/** s: keys held before a longer absence count as released. A slow page keeps them. */
const KEYS_HELD = 2;
/** A gap of up to this many usual gaps does not count as an absence. */
const USUAL = 3;
/** Own controls act from at most this many substeps before the present: the span of a 60 Hz frame. */
const BACKDATED = 2;

/** One display frame: own controls are sampled, and everything is simulated up to the present (PREDICTION, Inputs, Clock). */
export function advanceFrame(session: Session, controls: Controls | null, now: number): void {
  const { sim, clock, pilot, budget } = session;
  const target = alignFront(session, now);
  const due = substepsTo(sim, target);
  if (due > 0) session.features.keepWithinBudget?.(sim, budget, due);
  const replayed = runReplays(sim, budget.shipSubsteps);
  if (due > BACKDATED) stepFront(sim, later(sim, due - BACKDATED));
  if (controls !== null && areControls(session, controls))
    sampleControls(sim, pilot, controls, { now, steer: clock.steer, granularity: session.granularity });
  stepFront(sim, target);
  runReplays(sim, budget.shipSubsteps - replayed);
  place(sim, clock.present);
  session.features.announce?.(session);
}

/** Whether the controls of a JavaScript caller have all members; the values are checked when sampled. */
function areControls({ warn }: Session, given: unknown): boolean {
  const controls = given as Partial<Controls> | undefined;
  const lists = [controls?.rotationInput, controls?.translationInput, controls?.targetAttitude];
  if (typeof given === 'object' && lists.every(Array.isArray)) return true;
  warn('controls-ignored', 'Controls lack members: pass all of Controls, or null.', { controls });
  return false;
}

/** Advances the clock. If the front cannot follow continuously, it is moved to the present. Returns the front's target. */
function alignFront(session: Session, now: number): Position {
  const { sim, clock, pilot, counters, advancedAt: advancedBefore } = session;
  const { timing, timeScale, tickRate, paused } = spanOf(sim.timeline, sim.newestTick);
  const answers = answersPings(clock);
  const horizon = paused ? Number.POSITIVE_INFINITY : horizonOf(sim.cadence, tickRate, answers);
  const latest = wallOfTick(sim.timeline, sim.newestTick) + horizon + (answers ? 0 : leadOf(clock));
  const jumped = advanceClock(clock, now, { deadZone: timing.dt / timeScale / 2, latest });
  const absent = wasAbsent(session, now);
  const target = locate(sim, clock.present);
  if (absent && now - advancedBefore > KEYS_HELD) pilot.released = pilot.last;
  if (absent || (jumped && !sim.frontIsStale)) counters.resyncs += 1;
  if (jumped || absent || sim.frontIsStale || isFarBehind(sim, target))
    realign(sim, target, { resync: jumped || absent, stepped: jumped && !absent });
  return target;
}

/** Whether the page was away: for longer than a second, and longer than its usual frames take. */
function wasAbsent(session: Session, now: number): boolean {
  const gap = now - session.advancedAt;
  session.advancedAt = now;
  if (!(gap >= 0)) return !Number.isNaN(gap);
  const isUsual = gap <= USUAL * session.usualGap;
  if (gap > 0) session.usualGap = Number.isNaN(session.usualGap) ? gap : session.usualGap * 0.8 + gap * 0.2;
  return gap > LONG_GAP && !isUsual;
}

/** The position of the present, server wall s, between the two substep boundaries around it. */
export function place(sim: Simulation, present: number): void {
  writeMoment(moment, sim.timeline, present);
  placePresent(sim, moment);
}

const moment: Moment = { tick: 0, substeps: 0 };
const located = createPosition();
const sampling = createPosition();

/** The first substep boundary at or after the present, never before the newest state nor farther from it than the ring reaches. */
function locate(sim: Simulation, present: number): Position {
  writeMoment(moment, sim.timeline, present);
  const last = sim.newestTick + sim.ringLength - 2;
  if (moment.tick < sim.newestTick || moment.tick >= last) {
    moment.tick = moment.tick < sim.newestTick ? sim.newestTick : last;
    moment.substeps = 0;
  }
  addSubsteps(located, sim.timeline, moment.tick, 0, Math.ceil(moment.substeps));
  return located;
}

function substepsTo({ front, timeline }: Simulation, to: Position): number {
  return Math.max(0, indexOf(timeline, to.tick, to.substep) - indexOf(timeline, front.tick, front.substep));
}

function later({ front, timeline }: Simulation, substeps: number): Position {
  addSubsteps(sampling, timeline, front.tick, front.substep, substeps);
  return sampling;
}
