import { type Controls, err, type Result } from '../dynamics';
import type { ClientMessage, PartialFrame, PendingMessage, ServerMessage } from '../wire';
import { createChecks } from './checks/checks';
import { describe } from './checks/describe';
import { requireOptions } from './checks/options';
import type { EventNotice, WorldView } from './drawn/view';
import { advanceFrame } from './frameLoop';
import { viewAt } from './viewAt';
import { lastControls, takeInputs } from './inputs/sending';
import { configure } from './lifecycle/configure';
import { copyOwned, type Owned } from './lifecycle/fork';
import { changePolicy } from './lifecycle/policy';
import {
  createKept,
  type Kept,
  type PredictorSnapshot,
  receiveAndKeep,
  restoreSnapshot,
  snapshotOf,
} from './lifecycle/snapshot';
import type { Defaults, PredictorOptions } from './options';
import { wallAt } from './callTime';
import { changeOwnShip, dropShip, expectTeleport, type Removal, resetSession } from './ownership';
import { announce, createSession, type Session } from './session';
import type { Policy } from './simulation/track';
import { decodePending, receivePending } from './snapshots/pending';
import { refuse } from './snapshots/receiveSnapshot';
import { pingIfDue } from './time/pings';

/**
 * Server states + own controls → the present pose (PREDICTION). `now` is an argument, in monotonic wall seconds; nothing reads a clock,
 * and nothing that a server or a pilot sends makes it throw.
 */
export interface Predictor {
  /** Receives a checked message of the server; a frame needs only tick and ships. */
  receive: (message: ServerMessage | PartialFrame, now: number) => void;
  /**
   * Receives an undecoded message of the server (pendingServerMessage of wire): the next `advance` decodes it, unless newer frames
   * supersede it. For a page that may be hidden while hundreds of ships are sent.
   */
  receivePending: (message: PendingMessage, now: number) => void;
  /** Reports a frame that the wire refused; it is counted, and the diagnosis keeps its reason. */
  refused: (reason: string) => void;
  /** Called once per display frame: samples own controls (null for a spectator, or without input) and simulates up to the present. Controls that are not finite are ignored. */
  advance: (controls: Controls | null, now: number) => void;
  /** The world at the present; one record, valid until the next call. */
  view: (now: number) => WorldView;
  /** The messages to send since the last call. */
  takeOutgoing: () => ClientMessage[];
  /**
   * For a server of the game's JSON, instead of takeOutgoing: the controls to send since the last call (encodeControlsJson), or null
   * when nothing has changed. Pings are left to the connection.
   */
  takeControls: () => Controls | null;
  /** Predicted, confirmed and retracted events, in order, during `receive` and `advance`. Returns how to stop listening. */
  onEvent: (listener: (notice: EventNotice) => void) => () => void;
  /** Makes `shipId` the player's ship; null for a spectator. Inputs made for the previous ship are dropped, never sent for this one. */
  setOwnShip: (shipId: string | null) => void;
  /** Removes the ship from the view at once. A later frame that has it restores it. */
  removeShip: (shipId: string, reason: Removal) => void;
  /** Announces that the server moves the ship elsewhere: its next state is shown at once and counts as no error. */
  teleported: (shipId: string) => void;
  /**
   * Sets how the ship is drawn, present or not: simulated to the present (`predict`, the default), between its
   * server states about one send ago (`interpolate`), or where its newest server state has it (`hold`). The change is
   * eased. A ship that is not predicted has no predicted events and is `confirmed` or `stale`.
   */
  setPolicy: (shipId: string, policy: Policy) => void;
  /**
   * Changes settings (member by member), ship classes, terrain or bodies while running. Ships, time, inputs and listeners stay, and each
   * ship goes on from its newest server state; only another list of body names begins a new world. A hello with other values does the
   * same. An error names the invalid field, and nothing changes.
   */
  configure: (changes: Partial<Defaults>) => Result<null>;
  /** Clears ships, time, inputs and the clock, as for another server of the same world. The own ship and listeners stay. */
  reset: () => void;
  /** The last messages as plain data for JSON.stringify, to continue from after a reload or in a worker. */
  snapshot: (now: number) => PredictorSnapshot;
  /** Continues from a snapshot, as if its frame had arrived `age` s ago; or returns an error that names the invalid field, and nothing changes. */
  restore: (snapshot: unknown, now: number) => Result<null>;
  /** Releases everything, listeners too; later calls do nothing. */
  dispose: () => void;
}

/**
 * Creates a predictor without server state.
 * @throws RangeError that names the invalid option
 *
 * @example
 * ```ts
 * const predictor = createPredictor({ ownShipId: 'ship-1', onWarning: (code, message) => console.warn(code, message) });
 * const decoded = decodeFrameJson(message); // a parsed message of the game's server
 * if (decoded.ok) predictor.receive(decoded.value, now);
 * predictor.advance({ ...NEUTRAL_CONTROLS, thrustLevel: 0.4 }, now);
 * const { own } = predictor.view(now);
 * ```
 */
export function createPredictor(options: PredictorOptions = {}): Predictor {
  requireOptions(options);
  return predictorOf({ session: createSession(options), kept: createKept() });
}

const owners = new WeakMap<Predictor, Owned>();

/**
 * A second predictor in the same state, independent of the first: with the same input both give the same bits. Listeners stay with the
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
  const life = createLife(session);
  return {
    ...frameCalls(session, kept, life),
    ...shipCalls(session, life),
    refused: (reason) => refuse(session.sim, reason),
    onEvent(listener) {
      if (!life.goesOn('onEvent') || !isListener(session, listener)) return () => undefined;
      session.listeners.add(listener);
      return () => session.listeners.delete(listener);
    },
    configure: (changes) =>
      life.goesOn('configure') ? configure(session, changes) : err('configure: disposed'),
    reset: () => resetSession(session),
    snapshot: (now) => snapshotOf(session, kept, wallAt(session, now)),
    restore: (snapshot, now) =>
      life.goesOn('restore')
        ? restoreSnapshot(session, kept, snapshot, wallAt(session, now))
        : err('snapshot: disposed'),
    dispose() {
      life.end();
      session.listeners.clear();
      resetSession(session);
    },
  };
}

/** Until `dispose`. */
interface Life {
  /** Whether a call is carried out; warns of one after `dispose`. */
  readonly goesOn: (call: string) => boolean;
  readonly end: () => void;
}

function createLife({ warn }: Session): Life {
  let isDisposed = false;
  return {
    goesOn(call) {
      if (!isDisposed) return true;
      warn('disposed', `${call} was called after dispose and does nothing: stop the frame loop first.`, {
        call,
      });
      return false;
    },
    end: () => (isDisposed = true),
  };
}

/** The calls of each message and each display frame. */
function frameCalls(session: Session, kept: Kept, life: Life) {
  const checks = createChecks(session);
  const receiveAt = (message: ServerMessage | PartialFrame, now: number, at: number) => {
    checks?.receive(message, now);
    if (!Number.isNaN(at)) receiveAndKeep(session, kept, message, at);
  };
  return {
    receive(message, now) {
      if (life.goesOn('receive')) receiveAt(message, now, wallAt(session, now));
    },
    receivePending(message, now) {
      if (life.goesOn('receivePending')) receivePending(session, message, now, receiveAt);
    },
    advance(controls, now) {
      if (!life.goesOn('advance')) return;
      checks?.advance(controls, now);
      const at = wallAt(session, now);
      if (Number.isNaN(at)) return;
      decodePending(session, receiveAt);
      pingIfDue(session.pings, at);
      if (session.sim.newestTick >= 0) advanceFrame(session, controls, at);
    },
    view(now) {
      checks?.view(now);
      if (Number.isFinite(now)) return viewAt(session, now + session.setBack);
      wallAt(session, now);
      return session.shown.view;
    },
    takeOutgoing() {
      checks?.taken();
      return takeOutgoing(session);
    },
    takeControls() {
      checks?.taken();
      return lastControls(takeOutgoing(session));
    },
  } satisfies Partial<Predictor>;
}

/** The calls about single ships. A call with something else than an id is ignored, with a warning. */
function shipCalls(session: Session, life: Life) {
  const isOf = (call: string, shipId: unknown): boolean =>
    life.goesOn(call) && isShipId(session, call, shipId);
  return {
    setOwnShip(shipId) {
      if (shipId === null ? life.goesOn('setOwnShip') : isOf('setOwnShip', shipId))
        changeOwnShip(session, shipId ?? '');
    },
    removeShip(shipId, reason) {
      if (!isOf('removeShip', shipId)) return;
      dropShip(session, shipId, reason);
      announce(session);
    },
    teleported(shipId) {
      if (isOf('teleported', shipId)) expectTeleport(session, shipId);
    },
    setPolicy(shipId, policy) {
      if (isOf('setPolicy', shipId)) changePolicy(session, shipId, policy);
    },
  } satisfies Partial<Predictor>;
}

function isShipId({ warn }: Session, call: string, shipId: unknown): boolean {
  if (typeof shipId === 'string') return true;
  const message = `${call}: expected the id of a ship, a text, got ${describe(shipId)}. The call was ignored.`;
  warn('ship-id', message, { field: call, value: shipId });
  return false;
}

function isListener({ warn }: Session, listener: unknown): boolean {
  if (typeof listener === 'function') return true;
  const message = `onEvent: expected one function (notice) for all events, got ${describe(listener)}.`;
  warn('listener-not-function', message, { listener });
  return false;
}

function takeOutgoing({ pings, sim, sending, advancedAt, counters }: Session): ClientMessage[] {
  const messages: ClientMessage[] = pings.queued.splice(0);
  const inputs = takeInputs(sim, sending, advancedAt);
  counters.pingsDropped = pings.dropped;
  counters.inputsDropped = sim.inputs.dropped;
  if (inputs.length > 0) messages.push({ kind: 'inputs', inputs });
  return messages;
}
