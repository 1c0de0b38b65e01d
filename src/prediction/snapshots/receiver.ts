import type { BodyState, ServerFrame } from '../../wire';
import type { Policy } from '../simulation/track';
import type { Clock } from '../time/clock';
import type { TickRateMeter } from '../time/tickRateMeter';
import type { GameTimeMeter } from './tempo/gameTimeMeter';
import { createSnapshotContext, type SnapshotContext } from './snapshotContext';

/** State by which one connection's frames are classified. */
export interface Receiver {
  readonly clock: Clock;
  ownShipId: string;
  /** The server sends events; without them, states confirm predicted events. */
  sendsEvents: boolean;
  /** A new connection: the next frame may have any tick. */
  fresh: boolean;
  /** Frames before this tick are of the previous world or connection. */
  firstTick: number;
  /** Possible jumps of the timeline: the number in a row, and the last one's tick and arrival. */
  readonly jump: { tick: number; at: number; count: number };
  /** Ticks of received frames, slot = tick mod length. */
  readonly seen: Float64Array;
  /** Arrival of the newest frame, client wall s. */
  acceptedAt: number;
  /** Ships that are not to be predicted, present or not. */
  readonly policies: Map<string, Policy>;
  /** Ships removed by the caller, with the newest tick then: states up to that tick do not restore them. */
  readonly removed: Map<string, number>;
  /** Before the first frame: the bodies known so far are taken to be of its tick, unless it has its own. */
  startsBodies: boolean;
  /** The bodies sent last, to detect whether they move. */
  lastBodies: { tick: number; bodies: readonly BodyState[] };
  /** Events before this tick have been reported, unless they are as old as the ledgers reach. */
  eventsTick: number;
  /** New ships of the newest frame that are still to be taken, and its arrival, client wall s. */
  rest: { readonly frame: ServerFrame; readonly now: number } | null;
  /** Null until a frame has been measured. */
  gameTime: GameTimeMeter | null;
  /** The last values that frames sent, valid until the next; null before the first. */
  readonly sentTempo: { tickRate: number | null; timeScale: number | null };
  /** Assumed while nothing is sent or measured: 1 Hz and 1, or the hello's. */
  defaultTempo: { readonly tickRate: number; readonly timeScale: number };
  /** Null until a frame lacks the rate. */
  tickRate: TickRateMeter | null;
  /** Of the frame being received. */
  readonly context: SnapshotContext;
}

export function createReceiver(clock: Clock, ownShipId: string): Receiver {
  return {
    clock,
    ownShipId,
    sendsEvents: false,
    fresh: true,
    firstTick: 0,
    jump: { tick: -1, at: 0, count: 0 },
    seen: new Float64Array(1024).fill(Number.NEGATIVE_INFINITY),
    acceptedAt: Number.NEGATIVE_INFINITY,
    policies: new Map(),
    removed: new Map(),
    startsBodies: true,
    lastBodies: { tick: -1, bodies: [] },
    gameTime: null,
    sentTempo: { tickRate: null, timeScale: null },
    defaultTempo: { tickRate: 1, timeScale: 1 },
    tickRate: null,
    eventsTick: 0,
    rest: null,
    context: createSnapshotContext(),
  };
}

/** Whether the tick rate of the frame being received is sent or measured, not assumed. */
export function isTimed({ tickRate }: Receiver): boolean {
  return tickRate?.isKnown ?? true;
}

/** Starts over: earlier frames do not relate to later ones. */
export function forgetPast(receiver: Receiver): void {
  receiver.jump.count = 0;
  receiver.fresh = true;
  receiver.firstTick = 0;
  receiver.seen.fill(Number.NEGATIVE_INFINITY);
  receiver.acceptedAt = Number.NEGATIVE_INFINITY;
  receiver.rest = null;
  receiver.eventsTick = 0;
  receiver.removed.clear();
  receiver.startsBodies = true;
  receiver.lastBodies = { tick: -1, bodies: [] };
  receiver.gameTime = null;
  receiver.sentTempo.tickRate = null;
  receiver.sentTempo.timeScale = null;
  receiver.tickRate = null;
}
