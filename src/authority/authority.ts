import { ok, type Result, type ShipInit, type Vec3 } from '../dynamics';
import type { ClientMessage, Hello, Pong, ServerFrame } from '../wire';
import { frameFor } from './announcements';
import { join, receive } from './pilots/clients';
import type { Counters } from './pilots/counters';
import { simulateInterval } from './interval';
import type { AuthorityOptions } from './options';
import { loadPlan } from './ships/plans';
import { passBoundary } from './time/schedule';
import { createServerState, type ServerState } from './serverState';
import { despawn, kick, respawn, spawn, type SpawnOrder } from './ships/shipTable';
import type { Tempo } from './time/tempo';

/**
 * The world loop that plays the server (PREDICTION, Server messages; DYNAMICS, Time). It has no clock, no random numbers and
 * no transport: wall seconds are arguments, messages are plain records. Commands return null, or the reason why they changed nothing.
 */
export interface Authority {
  /** The present tick boundary. */
  readonly tickNumber: () => number;
  /** Of the interval that begins at the present boundary. */
  readonly tempo: Tempo;
  readonly counters: Readonly<Counters>;

  /**
   * A player joins or rejoins. It flies `shipId`, which may be spawned later; '' is a spectator.
   * @returns the hello to send it; null if the server sends none (`legacy`)
   */
  join: (playerId: string, shipId: string) => Result<Hello | null>;
  leave: (playerId: string) => string | null;
  /** Handles a client's message: returns the pong for a ping, null for inputs, or the reason why (part of) it was refused. */
  receive: (playerId: string, message: ClientMessage, now: number) => Result<Pong | null>;

  /**
   * Simulates the interval that begins at the present boundary in one go, with the inputs that have arrived; while paused nothing
   * moves and the boundary stays. Then the last setTickRate, setTimeScale and setPaused take effect.
   * @param at wall seconds at which the boundary that ends the interval is due
   */
  tick: (at: number) => void;
  /** Sets the wall time of the present boundary: at the start (0 by default), and when a freeze ends. */
  startAt: (now: number) => void;
  /** The world at the present boundary for one player; null if it has not joined. While paused the same tick is repeated. */
  frameFor: (playerId: string) => ServerFrame | null;

  spawn: (order: SpawnOrder) => string | null;
  despawn: (shipId: string) => string | null;
  /** Puts a ship back where it was spawned, over the same ground, or into the state `ship`. */
  respawn: (shipId: string, ship?: ShipInit) => string | null;
  kick: (shipId: string, dv: Vec3, spin: Vec3) => string | null;

  /** These three take effect at the next boundary. */
  setTickRate: (tickRate: number) => string | null;
  setTimeScale: (timeScale: number) => string | null;
  setPaused: (paused: boolean) => void;
  /**
   * Only while paused: the next `tick` simulates one interval, then pauses again. A 'substep' is an interval of one substep at
   * 100 Hz, so that a client needs nothing but frames. Send the frame before it too: it has the tempo.
   */
  armStep: (unit: 'substep' | 'tick') => string | null;
}

/** Creates the authority of a world, or returns a reason that names the first invalid option. */
export function createAuthority(options: AuthorityOptions): Result<Authority> {
  const created = createServerState(options);
  if (!created.ok) return created;
  const server = created.value;
  const { ships, bodies, world, tempo, pilots, schedule } = server;

  /** A command may change the world between two frames: the next frame is built from scratch. */
  function ordered<T>(result: T): T {
    server.frame = null;
    return result;
  }

  return ok({
    tickNumber: () => server.tick,
    tempo,
    counters: server.counters,

    join: (playerId, shipId) => join(server, playerId, shipId),
    leave: (playerId) => (pilots.delete(playerId) ? null : `playerId: no player named ${playerId}`),
    receive: (playerId, message, now) => receive(server, playerId, message, now),

    startAt(now) {
      schedule.at = now;
    },
    tick(at) {
      passTick(server, at);
    },
    frameFor(playerId) {
      const pilot = pilots.get(playerId);
      return pilot === undefined ? null : frameFor(server, pilot);
    },

    spawn: (order) => ordered(spawnPlanned(server, order)),
    despawn(shipId) {
      server.plans.delete(shipId);
      return ordered(despawn(ships, shipId));
    },
    respawn: (shipId, ship) => ordered(respawn(ships, shipId, bodies, world, ship)),
    kick: (shipId, dv, spin) => ordered(kick(ships, shipId, dv, spin)),

    setTickRate: tempo.setTickRate,
    setTimeScale: tempo.setTimeScale,
    setPaused: tempo.setPaused,
    armStep: (unit) => ordered(tempo.armStep(unit)),
  });
}

function passTick(server: ServerState, at: number): void {
  const { tempo, schedule } = server;
  schedule.at = at;
  server.events = [];
  if (!tempo.paused()) {
    passBoundary(schedule, server.tick + 1, at);
    simulateInterval(server);
    server.tick += 1;
  }
  tempo.settle();
  server.frame = null;
}

function spawnPlanned(server: ServerState, order: SpawnOrder): string | null {
  const plan = loadPlan(order.plan ?? []);
  if (!plan.ok) return plan.reason;
  const reason = spawn(server.ships, order, server.bodies, server.world);
  if (reason === null && plan.value.inputs.length > 0) server.plans.set(order.shipId, plan.value);
  return reason;
}
