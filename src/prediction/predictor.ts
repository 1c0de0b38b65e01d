import {
  type Body,
  BODIES,
  type BodyMotion,
  type Controls,
  type Settings,
  SHIP_CLASSES,
  type ShipClass,
  type TerrainHeight,
  TERRAINS,
  type World,
} from '../dynamics';
import type { ClientMessage, Hello, PartialFrame, Pong, ServerFrame, ServerMessage } from '../wire';
import { advanceClock, createClock, forgetSchedule, jitterOf, samplePong, serverTime } from './time/clock';
import { createDiagnosis } from './diagnosis';
import { createReceiver, refuse, receiveSnapshot } from './snapshots/receiver';
import { type ScheduledInput, resend, takeUnsent } from './inputs/inputs';
import { createPace, keepPace } from './time/pace';
import { createPilot, sampleControls } from './inputs/pilot';
import { answeredPing, createPings, pingIfDue } from './time/pings';
import { isFarBehind, realign } from './snapshots/realign';
import { runReplays } from './simulation/replay';
import { checkRollback } from './simulation/rollbackCheck';
import { createSimulation, type Simulation, stepFront } from './simulation/simulation';
import {
  indexOf,
  type Moment,
  type Position,
  spanOf,
  wallOfTick,
  writeLater,
  writeMoment,
} from './time/timeline';
import { loadWorld, sameWorld, type WorldConfig } from './snapshots/worldConfig';
import type { EventNotice, WorldView } from './drawn/view';
import { createShown, fillView, placePresent } from './drawn/worldView';

/** What a predictor is made with; everything may be left out. */
export interface PredictorOptions {
  /** Terrains by the name the hello tells, beside TERRAINS of dynamics. */
  readonly terrains?: Readonly<Record<string, TerrainHeight>>;
  /** What holds for a server that sends no hello; the game's catalogue and defaults unless given. */
  readonly defaults?: Partial<Defaults>;
  /** Ship substeps a frame may take; 20,000 unless given. */
  readonly maxSubstepsPerFrame?: number;
  /** The own ship of a client whose server sends no hello. */
  readonly ownShipId?: string;
  /**
   * What the own ship does by itself until its pilot's first input acts, as the server was told to let it: in the order of time.
   * Until then `advance` is given null.
   */
  readonly plan?: readonly ScheduledInput[];
  /** Test mode: at every tick boundary go back this many ticks, replay, and compare bits. Counted in the diagnosis. */
  readonly forcedRollback?: number;
}

export interface Defaults {
  readonly settings: Partial<Settings>;
  readonly shipClasses: readonly ShipClass[];
  readonly bodies: readonly (Body & BodyMotion)[];
  readonly terrain: string;
}

/**
 * Server truth + own controls → a pose for now (PREDICTION). Wall seconds `now` are monotonic and handed in; nothing here reads a
 * clock, nothing throws at what a server or a pilot gives.
 */
export interface Predictor {
  /** A checked message of the server has arrived; of a frame, tick and ships are enough. */
  receive: (message: ServerMessage | PartialFrame, now: number) => void;
  /** A frame of the server that the wire refused; counted, its reason kept for the diagnosis. */
  refused: (reason: string) => void;
  /** Once a display frame: samples own controls (null: a spectator's, or the hand is off the stick) and simulates up to the present. Controls that are not finite are ignored. */
  advance: (controls: Controls | null, now: number) => void;
  /** The world at the present; one record, valid until the next call. */
  view: (now: number) => WorldView;
  /** What is to be sent since the last call. */
  takeOutgoing: () => ClientMessage[];
  /** Predicted, confirmed and retracted events, in order, during `receive` and `advance`. Returns how to stop listening. */
  onEvent: (listener: (notice: EventNotice) => void) => () => void;
}

const BUDGET = 20_000;
/** Without an advance for longer than this the page was hidden or stalled, s: one resync, nothing replayed. */
const LONG_GAP = 1;
/** Own controls act from at most this many substeps before the present on: what a 60 Hz frame spans. */
const BACKDATED = 2;

/** A predictor that has heard of nothing yet. Throws RangeError if the given defaults are refused: they are the page's own. */
export function createPredictor(options: PredictorOptions = {}): Predictor {
  const terrains = { ...TERRAINS, ...options.terrains };
  const defaults: WorldConfig = {
    settings: options.defaults?.settings ?? {},
    shipClasses: options.defaults?.shipClasses ?? SHIP_CLASSES,
    bodies: options.defaults?.bodies ?? BODIES,
    terrain: options.defaults?.terrain ?? 'flat',
  };
  const world = loadWorld(defaults, terrains);
  if (!world.ok) throw new RangeError(`defaults: ${world.reason}`);

  const clock = createClock();
  const receiver = createReceiver(clock, options.ownShipId ?? '');
  const pilot = createPilot();
  const pings = createPings();
  const pace = createPace(options.maxSubstepsPerFrame ?? BUDGET);
  const listeners = new Set<(notice: EventNotice) => void>();
  const rollback = options.forcedRollback ?? 0;
  const counters = createDiagnosis();
  const plan = options.plan ?? [];
  let sim = createSimulation(world.value, defaults.bodies, counters, rollback === 0, plan);
  let shown = createShown(sim);
  let told = defaults;
  let granularity: Hello['inputGranularity'] = 'tick';
  let advancedAt = Number.NaN;

  /** All ships and all time of the world before are forgotten. */
  function beginWorld(next: World, bodies: readonly BodyMotion[]): void {
    sim = createSimulation(next, bodies, counters, rollback === 0, plan);
    shown = createShown(sim);
    forgetSchedule(clock);
  }

  function takeHello(hello: Hello): void {
    const loaded = loadWorld(hello, terrains);
    if (!loaded.ok) {
      refuse(sim, `hello.${loaded.reason}`);
      return;
    }
    // Told again, it is a new connection to the same world: what was predicted goes on.
    if (!counters.helloReceived || !sameWorld(told, hello)) beginWorld(loaded.value, hello.bodies);
    told = hello;
    counters.helloReceived = true;
    granularity = hello.inputGranularity;
    receiver.ownShipId = hello.shipId;
    receiver.fresh = true;
    receiver.tellsEvents = true;
    resend(sim.inputs);
  }

  function receiveFrame(frame: ServerFrame, now: number): void {
    if (sim.newestTick < 0 && !counters.helloReceived && frame.bodies.length > 0) {
      // A server without a hello may have other bodies than the defaults: its frames say which.
      const loaded = loadWorld({ ...defaults, bodies: frame.bodies }, terrains);
      if (loaded.ok) beginWorld(loaded.value, frame.bodies);
    }
    receiveSnapshot(sim, receiver, frame, now);
    announce();
  }

  function takePong(pong: Pong, now: number): void {
    const sent = answeredPing(pings, pong.id);
    if (Number.isNaN(sent) || sim.newestTick < 0) return;
    const near = Math.abs(pong.tick - sim.newestTick) < sim.ringLength;
    const paused = near && spanOf(sim.timeline, pong.tick).paused;
    samplePong(
      clock,
      sent,
      near && !paused ? wallOfTick(sim.timeline, pong.tick) + pong.sinceTick : null,
      now,
    );
  }

  function announce(): void {
    for (const notice of sim.notices.splice(0)) for (const listener of listeners) listener(notice);
  }

  function advance(controls: Controls | null, now: number): void {
    const { timing, timeScale } = spanOf(sim.timeline, sim.newestTick);
    const jumped = advanceClock(clock, now, timing.dt / timeScale);
    const absent = now - advancedAt > LONG_GAP || now < advancedAt;
    advancedAt = now;
    locate(target, sim, clock.present);
    if (absent) pilot.released = pilot.last;
    if (absent || (jumped && !sim.frontIsStale)) counters.resyncs += 1;
    if (jumped || absent || sim.frontIsStale || isFarBehind(sim, target))
      realign(sim, target, { resync: jumped || absent });

    const due = substepsTo(sim, target);
    keepPace(sim, pace, due);
    const replayed = runReplays(sim, pace.budget);
    if (due > BACKDATED) stepFront(sim, later(sim, due - BACKDATED), checkBoundary);
    if (controls !== null) sampleControls(sim, pilot, controls, { now, steer: clock.steer, granularity });
    if (due > 0) stepFront(sim, target, checkBoundary);
    if (replayed < pace.budget) runReplays(sim, pace.budget - replayed);
    place(clock.present);
    announce();
  }

  function place(present: number): void {
    writeMoment(moment, sim.timeline, present);
    placePresent(sim, moment);
  }

  function checkBoundary(tick: number): void {
    if (rollback > 0) checkRollback(sim, tick, rollback);
  }

  function fillGauges(now: number): void {
    counters.clockOffset = clock.offset;
    counters.clockRate = clock.rate;
    counters.roundTrip = clock.roundTrip;
    counters.jitter = jitterOf(clock, now);
    counters.lead = clock.present - serverTime(clock, clock.updatedAt);
  }

  return {
    receive(message, now) {
      if (message.kind === 'hello') takeHello(message);
      else if (message.kind === 'frame') receiveFrame(completed(message, sim), now);
      else takePong(message, now);
    },
    refused: (reason) => refuse(sim, reason),
    advance(controls, now) {
      pingIfDue(pings, now);
      if (sim.newestTick >= 0) advance(controls, now);
    },
    view(now) {
      if (Number.isNaN(advancedAt) || sim.newestTick < 0 || sim.frontIsStale) return shown.view;
      const present = clock.present + Math.max(0, now - clock.updatedAt) * clock.rate;
      place(present);
      fillView(shown, sim, now, present);
      fillGauges(now);
      return shown.view;
    },
    takeOutgoing() {
      const messages: ClientMessage[] = pings.queued.splice(0);
      const inputs = takeUnsent(sim.inputs);
      if (inputs.length > 0) messages.push({ kind: 'inputs', inputs });
      return messages;
    },
    onEvent(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}

/** A frame with what it does not tell filled in: the tempo as it was, no events, bodies moved by the law. */
function completed(frame: PartialFrame, sim: Simulation): ServerFrame {
  const untimed = { tickRate: 1, timeScale: 1 };
  const { tickRate, timeScale } = sim.newestTick < 0 ? untimed : spanOf(sim.timeline, sim.newestTick);
  const untold = { tickRate, timeScale, paused: false, bodies: [], events: [], lastInput: null };
  return { ...untold, ...frame };
}

const moment: Moment = { tick: 0, substeps: 0 };
const target: Position = { tick: 0, substep: 0 };
const sampling: Position = { tick: 0, substep: 0 };

/** Where the present lies, never before the newest state nor farther from it than the ring reaches. */
function locate(out: Position, sim: Simulation, present: number): void {
  writeMoment(moment, sim.timeline, present);
  const last = sim.newestTick + sim.ringLength - 2;
  if (moment.tick < sim.newestTick || moment.tick >= last) {
    moment.tick = moment.tick < sim.newestTick ? sim.newestTick : last;
    moment.substeps = 0;
  }
  writeLater(out, sim.timeline, moment.tick, 0, Math.ceil(moment.substeps));
}

function substepsTo(sim: Simulation, to: Position): number {
  const { front, timeline } = sim;
  return Math.max(0, indexOf(timeline, to.tick, to.substep) - indexOf(timeline, front.tick, front.substep));
}

function later(sim: Simulation, substeps: number): Position {
  writeLater(sampling, sim.timeline, sim.front.tick, sim.front.substep, substeps);
  return sampling;
}
