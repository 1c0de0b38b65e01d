import {
  ok,
  beginTick,
  type Result,
  DEFAULT_SETTINGS,
  endTick,
  EVENT_NAMES,
  NO_EVENT,
  err,
  readControls,
  SHIP_STRIDE,
  type ShipInit,
  stepWorld,
  type Vec3,
} from '../dynamics';
import { PROTOCOL_VERSION } from '../protocol';
import type { ClientMessage, Hello, Pong, ServerFrame, WorldEvent } from '../wire';
import { type AuthorityOptions, loadOptions } from './options';
import {
  answerPing,
  applyDue,
  type Counters,
  createCounters,
  createPilot,
  type Pilot,
  type Present,
  queueInputs,
} from './pilots';
import { flyPlans, loadPlan, type Plan } from './plans';
import { createRoster, despawn, kick, respawn, rowOf, spawn, type SpawnOrder } from './roster';
import { createTempo, type Tempo } from './tempo';
import { toBodyStates, toShipState } from './shipState';

/**
 * The world loop that plays the server (PREDICTION, What the server says; DYNAMICS, Time). No clock, no dice, no transport: wall
 * seconds are handed in, messages come and go as plain records. Orders return null, or the reason why nothing was changed.
 */
export interface Authority {
  /** The present tick boundary. */
  readonly tickNumber: () => number;
  /** Of the interval that begins at the present boundary. */
  readonly tempo: Tempo;
  readonly counters: Readonly<Counters>;

  /**
   * A client comes, or comes again. It flies `shipId`, which need not have been spawned yet; '' is a spectator.
   * @returns what to tell it once; null where the server tells nothing (`legacy`)
   */
  join: (playerId: string, shipId: string) => Result<Hello | null>;
  leave: (playerId: string) => string | null;
  /** A message of a client: a ping's answer, null for inputs, or the reason for refusing (part of) it; counted. */
  receive: (playerId: string, message: ClientMessage, now: number) => Result<Pong | null>;

  /**
   * Simulates the interval that begins at the present boundary, all at once, with the inputs that have come; while paused, nothing
   * moves and the boundary stays. Then what setTickRate, setTimeScale and setPaused asked for holds.
   * @param at wall seconds at which the boundary that ends the interval is due
   */
  tick: (at: number) => void;
  /** The present boundary is at wall second `now`: at the start (0 unless said), and again when a freeze ends. */
  startAt: (now: number) => void;
  /** The world at the present boundary for one client, null for one that has not joined. While paused the same tick comes again. */
  frameFor: (playerId: string) => ServerFrame | null;

  spawn: (order: SpawnOrder) => string | null;
  despawn: (shipId: string) => string | null;
  /** As it was spawned, over the same ground; or as `ship` says. */
  respawn: (shipId: string, ship?: ShipInit) => string | null;
  kick: (shipId: string, dv: Vec3, spin: Vec3) => string | null;

  /** These three hold from the next boundary on. */
  setTickRate: (tickRate: number) => string | null;
  setTimeScale: (timeScale: number) => string | null;
  setPaused: (paused: boolean) => void;
  /**
   * Only while paused: the next `tick` simulates one interval, then pauses again. A 'substep' is an interval of one substep at
   * 100 Hz, so that a client needs to know nothing but frames. Send the frame before it too: it tells the tempo.
   */
  armStep: (unit: 'substep' | 'tick') => string | null;
}

/** The authority of a world, or a reason that names the first option that cannot be used. */
export function createAuthority(options: AuthorityOptions): Result<Authority> {
  const loaded = loadOptions(options);
  if (!loaded.ok) return loaded;
  const { world, bodies } = loaded.value;
  const legacy = options.legacy ?? false;
  const granularity = legacy ? 'tick' : (options.inputGranularity ?? 'substep');
  const tempo = createTempo(
    options.tickRate,
    options.timeScale,
    loaded.value.timing,
    loaded.value.world.settings,
  );
  const roster = createRoster();
  const pilots = new Map<string, Pilot>();
  /** By ship. */
  const plans = new Map<string, Plan>();
  const counters = createCounters();
  let tick = options.tick ?? 0;
  let happened: WorldEvent[] = [];
  let shared: Omit<ServerFrame, 'lastInput'> | null = null;
  const boundaries = new Float64Array(BOUNDARIES_KEPT).fill(Number.NaN);
  /** The newest boundary that has been due, and when. */
  let latest = tick;
  let latestAt = 0;

  /** Wall seconds at which the interval of `t` was simulated, or will be; for long ago and for the future by the present rate. */
  function simulatedAt(t: number): number {
    const boundary = t + 1;
    const known = boundary <= latest && boundary > latest - BOUNDARIES_KEPT;
    const at = known ? boundaries[boundary % BOUNDARIES_KEPT]! : Number.NaN;
    return Number.isNaN(at) ? latestAt + (boundary - latest) / tempo.tickRate() : at;
  }

  function present(): Present {
    return { tick, tickRate: tempo.tickRate(), granularity, simulatedAt };
  }

  function simulate(): void {
    const { substeps, dt } = tempo.timing();
    beginTick(roster.rows, bodies, world);
    for (let s = 0; s < substeps; s++) {
      applyInputs(s);
      stepWorld(roster.rows, bodies, roster.events, world, dt);
      collectEvents(s);
    }
    endTick(bodies, world, tempo.timing());
  }

  function applyInputs(s: number): void {
    if (plans.size > 0) flyPlans(plans, roster, tick, s);
    for (const pilot of pilots.values()) {
      if (pilot.queue.length === 0) continue;
      const at = rowOf(roster, pilot.shipId);
      if (at < 0) continue;
      const flown = applyDue(pilot, counters, { rows: roster.rows, at }, { ...present(), substep: s });
      if (!flown) continue;
      plans.delete(pilot.shipId);
      options.onInput?.(pilot.shipId, { tick, substep: s, controls: readControls(roster.rows, at) });
    }
  }

  function collectEvents(s: number): void {
    for (const [i, event] of roster.events.entries()) {
      if (event === NO_EVENT) continue;
      const type = EVENT_NAMES[event] as WorldEvent['type'];
      happened.push({ type, shipId: roster.berths[i]!.identity.shipId, tick, substep: s });
    }
  }

  function snapshot(): Omit<ServerFrame, 'lastInput'> {
    const ships = roster.berths.map(({ identity }, i) =>
      toShipState({ ships: roster.rows, at: i * SHIP_STRIDE, bodies, world }, identity, legacy),
    );
    return {
      kind: 'frame',
      tick,
      tickRate: tempo.tickRate(),
      timeScale: tempo.timeScale(),
      paused: tempo.paused(),
      bodies: toBodyStates(bodies, world),
      ships,
      events: happened,
    };
  }

  function hello(pilot: Pilot): Hello {
    return {
      kind: 'hello',
      protocolVersion: PROTOCOL_VERSION,
      playerId: pilot.playerId,
      shipId: pilot.shipId,
      settings: { ...DEFAULT_SETTINGS, ...options.settings },
      shipClasses: options.shipClasses,
      bodies: toBodyStates(bodies, world),
      terrain: options.terrain,
      tick,
      tickRate: tempo.tickRate(),
      timeScale: tempo.timeScale(),
      inputGranularity: granularity,
    };
  }

  function spawnPlanned(order: SpawnOrder): string | null {
    const plan = loadPlan(order.plan ?? []);
    if (!plan.ok) return plan.reason;
    const reason = spawn(roster, order, bodies, world);
    if (reason === null && plan.value.inputs.length > 0) plans.set(order.shipId, plan.value);
    return reason;
  }

  /** An order may change the world between two frames: the next frame is made anew. */
  function ordered<T>(result: T): T {
    shared = null;
    return result;
  }

  return ok({
    tickNumber: () => tick,
    tempo,
    counters,

    join(playerId, shipId) {
      if (playerId === '') return err('playerId: expected a text');
      const known = pilots.get(playerId);
      if (known === undefined && pilots.size >= MAX_PILOTS)
        return err(`players: ${MAX_PILOTS} are there already`);
      if (shipId !== '' && [...pilots.values()].some((p) => p.shipId === shipId && p.playerId !== playerId))
        return err(`shipId: ${shipId} is flown by another player`);
      const pilot = known ?? createPilot(playerId, shipId);
      pilot.shipId = shipId;
      pilot.fresh = true;
      pilots.set(playerId, pilot);
      return ok(legacy ? null : hello(pilot));
    },
    leave: (playerId) => (pilots.delete(playerId) ? null : `playerId: no player named ${playerId}`),
    receive(playerId, message, now) {
      const pilot = pilots.get(playerId);
      if (pilot === undefined || (message.kind === 'inputs' && pilot.shipId === '')) {
        counters.inputsOfStrangers++;
        return err(`playerId: ${playerId} ${pilot === undefined ? 'has not joined' : 'flies no ship'}`);
      }
      if (message.kind === 'ping')
        return ok(
          answerPing(pilot, counters, message, { tick, since: tempo.paused() ? 0 : now - latestAt }, now),
        );
      const reason = queueInputs(pilot, counters, message.inputs, present(), now);
      return reason === null ? ok(null) : err(reason);
    },

    startAt(now) {
      latestAt = now;
    },
    tick(at) {
      latestAt = at;
      happened = [];
      if (!tempo.paused()) {
        latest = tick + 1;
        boundaries[latest % BOUNDARIES_KEPT] = at;
        simulate();
        tick += 1;
      }
      tempo.settle();
      shared = null;
    },
    frameFor(playerId) {
      const pilot = pilots.get(playerId);
      if (pilot === undefined) return null;
      shared ??= snapshot();
      return { ...shared, lastInput: legacy ? null : pilot.lastInput };
    },

    spawn: (order) => ordered(spawnPlanned(order)),
    despawn(shipId) {
      plans.delete(shipId);
      return ordered(despawn(roster, shipId));
    },
    respawn: (shipId, ship) => ordered(respawn(roster, shipId, bodies, world, ship)),
    kick: (shipId, dv, spin) => ordered(kick(roster, shipId, dv, spin)),

    setTickRate: tempo.setTickRate,
    setTimeScale: tempo.setTimeScale,
    setPaused: tempo.setPaused,
    armStep: (unit) => ordered(tempo.armStep(unit)),
  });
}

/** Boundaries whose wall time is kept, for the margins of late inputs. */
const BOUNDARIES_KEPT = 128;
const MAX_PILOTS = 10_000;
