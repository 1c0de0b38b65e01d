import type { Controls, Result } from '../dynamics';
import type { ClientMessage, PartialFrame, PendingMessage, ServerMessage } from '../wire';
import { createChecks } from './checks/checks';
import { requireOptions } from './checks/options';
import type { EventNotice, WorldView } from './drawn/view';
import { fillView } from './drawn/worldView';
import { advanceFrame, place } from './frameLoop';
import { lastControls, takeInputs } from './inputs/sending';
import { configure } from './lifecycle/configure';
import { copyOwned, type Owned } from './lifecycle/fork';
import { changePolicy } from './lifecycle/policy';
import {
  createKept,
  type PredictorSnapshot,
  receiveAndKeep,
  restoreSnapshot,
  snapshotOf,
} from './lifecycle/snapshot';
import type { Defaults, PredictorOptions } from './options';
import { changeOwnShip, dropShip, expectTeleport, type Removal, resetSession } from './ownership';
import { announce, createSession, type Session } from './session';
import type { Policy } from './simulation/track';
import { noteCall } from './snapshots/receiveMessage';
import { decodePending, receivePending } from './snapshots/pending';
import { refuse } from './snapshots/receiver';
import { jitterOf, sentAt, serverTime } from './time/clock';
import { connectionOf } from './time/connection';
import { pingIfDue } from './time/pings';
import { spanOf } from './time/timeline';

/**
 * Server truth + own controls → a pose for now (PREDICTION). Wall seconds `now` are monotonic and handed in; nothing here reads a
 * clock, nothing throws at what a server or a pilot gives.
 */
export interface Predictor {
  /** A checked message of the server has arrived; of a frame, tick and ships are enough. */
  receive: (message: ServerMessage | PartialFrame, now: number) => void;
  /**
   * A message of the server has arrived and is not decoded yet (pendingServerMessage of wire): the next `advance` decodes it, unless
   * newer frames supersede it. For a page that may be hidden while hundreds of ships are sent.
   */
  receivePending: (message: PendingMessage, now: number) => void;
  /** A frame of the server that the wire refused; counted, its reason kept for the diagnosis. */
  refused: (reason: string) => void;
  /** Once a display frame: samples own controls (null: a spectator's, or the hand is off the stick) and simulates up to the present. Controls that are not finite are ignored. */
  advance: (controls: Controls | null, now: number) => void;
  /** The world at the present; one record, valid until the next call. */
  view: (now: number) => WorldView;
  /** What is to be sent since the last call. */
  takeOutgoing: () => ClientMessage[];
  /**
   * For a server of the game's JSON, instead of takeOutgoing: the controls to send since the last call (encodeControlsJson), or null
   * when nothing has changed. Pings are left to the connection.
   */
  takeControls: () => Controls | null;
  /** Predicted, confirmed and retracted events, in order, during `receive` and `advance`. Returns how to stop listening. */
  onEvent: (listener: (notice: EventNotice) => void) => () => void;
  /** From now on the player flies `shipId`; null: none, a spectator. Inputs made for the ship before are dropped, never sent for this one. */
  setOwnShip: (shipId: string | null) => void;
  /** The ship is no longer there: it leaves the view at once. A later frame that has it again brings it back. */
  removeShip: (shipId: string, reason: Removal) => void;
  /** The server is about to put the ship somewhere else: its next state is shown at once and counts as no error. */
  teleported: (shipId: string) => void;
  /**
   * How the ship is drawn from now on, whether it is there yet or not: simulated to the present (`predict`, the default), between its
   * server states about one send ago (`interpolate`), or where its newest server state has it (`hold`). The picture goes over
   * smoothly. A ship that is not predicted has no predicted events and is `confirmed` or `stale`.
   */
  setPolicy: (shipId: string, policy: Policy) => void;
  /**
   * Changes settings (member by member), ship classes, terrain or bodies while running. Ships, time, inputs and listeners stay, and each
   * ship goes on from its newest server state; only another list of body names begins a new world. A hello with other values does the
   * same. An error names the field that cannot be used, and nothing changes.
   */
  configure: (changes: Partial<Defaults>) => Result<null>;
  /** Forgets ships, time, inputs and the clock, as for another server of the same world. The own ship and listeners stay. */
  reset: () => void;
  /** What was told last, as plain data for JSON.stringify, to go on from after a reload or in a worker. */
  snapshot: (now: number) => PredictorSnapshot;
  /** Goes on from a snapshot, as if its frame had come `age` s ago; an error that names the field where it cannot be, and nothing changes. */
  restore: (snapshot: unknown, now: number) => Result<null>;
  /** Forgets everything, listeners too; later calls do nothing. */
  dispose: () => void;
}

/** Creates a predictor without server state. Throws RangeError, naming the option, where one cannot be used. */
export function createPredictor(options: PredictorOptions = {}): Predictor {
  requireOptions(options);
  return predictorOf({ session: createSession(options), kept: createKept() });
}

const owners = new WeakMap<Predictor, Owned>();

/**
 * A second predictor in the same state, which goes on independently: fed the same, both give the same bits. Listeners stay with the
 * first. For keyframes of a replay. Throws TypeError for anything that createPredictor did not make.
 */
export function forkPredictor(predictor: Predictor): Predictor {
  const owned = owners.get(predictor);
  if (owned === undefined) throw new TypeError('forkPredictor: expected a predictor of createPredictor');
  return predictorOf(copyOwned(owned));
}

function predictorOf(owned: Owned): Predictor {
  const predictor = createFace(owned);
  owners.set(predictor, owned);
  return predictor;
}

function createFace({ session, kept }: Owned): Predictor {
  const checks = createChecks(session);
  let isDisposed = false;
  const receive: Predictor['receive'] = (message, now) => {
    if (isDisposed) return;
    checks?.receive(message, now);
    receiveAndKeep(session, kept, message, now);
  };
  return {
    receive,
    receivePending: (message, now) => {
      if (!isDisposed) receivePending(session, message, now, receive);
    },
    refused: (reason) => refuse(session.sim, reason),
    advance(controls, now) {
      checks?.advance(controls, now);
      if (isDisposed || !noteCall(session, now)) return;
      decodePending(session, receive);
      pingIfDue(session.pings, now);
      if (session.sim.newestTick >= 0) advanceFrame(session, controls, now);
    },
    view(now) {
      checks?.view();
      return viewAt(session, now);
    },
    takeOutgoing() {
      checks?.taken();
      return takeOutgoing(session);
    },
    takeControls() {
      checks?.taken();
      return lastControls(takeOutgoing(session));
    },
    onEvent(listener) {
      if (!isListener(session, listener)) return () => undefined;
      session.listeners.add(listener);
      return () => session.listeners.delete(listener);
    },
    setOwnShip: (shipId) => changeOwnShip(session, shipId ?? ''),
    removeShip(shipId, reason) {
      dropShip(session, shipId, reason);
      announce(session);
    },
    teleported: (shipId) => expectTeleport(session, shipId),
    setPolicy: (shipId, policy) => changePolicy(session, shipId, policy),
    configure: (changes) => configure(session, changes),
    reset: () => resetSession(session),
    snapshot: (now) => snapshotOf(session, kept, now),
    restore: (snapshot, now) => restoreSnapshot(session, kept, snapshot, now),
    dispose() {
      isDisposed = true;
      session.listeners.clear();
      resetSession(session);
    },
  };
}

function isListener({ warn }: Session, listener: unknown): boolean {
  if (typeof listener === 'function') return true;
  warn('listener-not-function', `onEvent: expected a function, got ${String(listener)}.`, { listener });
  return false;
}

function viewAt(session: Session, now: number): WorldView {
  const { sim, shown, clock, advancedAt } = session;
  fillConnection(session, now);
  if (Number.isNaN(advancedAt) || sim.newestTick < 0 || sim.frontIsStale) return shown.view;
  const present = clock.present + Math.max(0, now - clock.updatedAt) * clock.rate;
  place(sim, present);
  const lead = clock.present - serverTime(clock, clock.updatedAt);
  fillView(shown, sim, { now, present, lead, heard: sentAt(clock, now) - jitterOf(clock) });
  fillGauges(session);
  return shown.view;
}

function fillConnection({ shown, receiver, pings, sim }: Session, now: number): void {
  const { view } = shown;
  view.silence = Math.max(0, now - receiver.acceptedAt);
  if (sim.timeline.spans.length === 0) {
    view.connection = 'waiting';
    return;
  }
  const heard = { frame: view.silence, pong: Math.max(0, now - pings.answeredAt) };
  view.connection = connectionOf(heard, sim.cadence, spanOf(sim.timeline, sim.newestTick));
}

function fillGauges({ counters, clock }: Session): void {
  counters.clockOffset = clock.offset;
  counters.clockRate = clock.rate;
  counters.roundTrip = clock.roundTrip;
  counters.jitter = jitterOf(clock);
  counters.lead = clock.present - serverTime(clock, clock.updatedAt);
}

function takeOutgoing({ pings, sim, sending, advancedAt, counters }: Session): ClientMessage[] {
  const messages: ClientMessage[] = pings.queued.splice(0);
  const inputs = takeInputs(sim, sending, advancedAt);
  counters.pingsDropped = pings.dropped;
  counters.inputsDropped = sim.inputs.dropped;
  if (inputs.length > 0) messages.push({ kind: 'inputs', inputs });
  return messages;
}
