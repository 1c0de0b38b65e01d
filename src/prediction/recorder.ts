import type { Controls } from '../dynamics';
import type { ClientMessage, PartialFrame, PendingMessage, ServerMessage, WorldEvent } from '../wire';
import { lastControls } from './inputs/sending';
import type { Defaults } from './options';
import type { Removal } from './ownership';
import type { Predictor } from './calls/api';
import type { Policy } from './simulation/track';
import { MAX_KEPT_EVENTS } from './snapshots/pendingFrames';

/**
 * One input of a predictor, in order; `at` is client wall s. The recordings of `scenarios` hold one JSON line for each
 * entry.
 */
export type PredictorEntry =
  | { readonly kind: 'received'; readonly at: number; readonly message: ServerMessage | PartialFrame }
  | { readonly kind: 'sent'; readonly at: number; readonly message: ClientMessage }
  | { readonly kind: 'advanced'; readonly at: number; readonly controls: Controls | null }
  | { readonly kind: 'called'; readonly at: number; readonly call: PredictorCall };

/** A call that changes a predictor's behaviour, other than a message or a display frame. */
export type PredictorCall =
  | { readonly name: 'setOwnShip'; readonly shipId: string | null }
  | { readonly name: 'removeShip'; readonly shipId: string; readonly reason: Removal }
  | { readonly name: 'teleported'; readonly shipId: string }
  | { readonly name: 'setPolicy'; readonly shipId: string; readonly policy: Policy }
  | { readonly name: 'configure'; readonly changes: unknown }
  | { readonly name: 'restore'; readonly snapshot: unknown }
  | { readonly name: 'reset' };

export type Write = (entry: PredictorEntry) => void;

/**
 * Wraps a predictor and passes every message, call, input and time to `write` (PREDICTION, Diagnosis). A predictor has
 * no other input, so a new one that is fed the entries gives the same bits. Undecoded messages are written when, and only if, they
 * are decoded.
 *
 * @example
 * ```ts
 * const entries: PredictorEntry[] = [];
 * const recorded = recordPredictor(createPredictor(), (entry) => entries.push(entry));
 * recorded.advance(NEUTRAL_CONTROLS, now);
 * ```
 */
export function recordPredictor(predictor: Predictor, write: Write): Predictor {
  const last = { at: 0 };
  const written: Write = (entry) => {
    last.at = entry.at;
    write(entry);
  };
  const taken = (): ClientMessage[] => {
    const messages = predictor.takeOutgoing();
    for (const message of messages) write({ kind: 'sent', at: last.at, message });
    return messages;
  };
  const pending = createPendingRecorder(written);
  return {
    ...predictor,
    ...recordCalls(predictor, write, last),
    receive(message, at) {
      written({ kind: 'received', at, message });
      predictor.receive(message, at);
    },
    receivePending(message, at) {
      predictor.receivePending(pending.wrap(message, at), at);
    },
    advance(controls, at) {
      // Written after the call: it decodes waiting messages, which precede the frame.
      predictor.advance(controls, at);
      written({ kind: 'advanced', at, controls });
    },
    reset() {
      pending.forget();
      write({ kind: 'called', at: last.at, call: { name: 'reset' } });
      predictor.reset();
    },
    takeOutgoing: taken,
    takeControls: () => lastControls(taken()),
  };
}

type Calls = Pick<Predictor, Exclude<PredictorCall['name'], 'reset'>>;

function recordCalls(predictor: Predictor, write: Write, last: { readonly at: number }): Calls {
  const wrote = (call: PredictorCall) => write({ kind: 'called', at: last.at, call });
  return {
    setOwnShip(shipId) {
      wrote({ name: 'setOwnShip', shipId });
      predictor.setOwnShip(shipId);
    },
    removeShip(shipId, reason) {
      wrote({ name: 'removeShip', shipId, reason });
      predictor.removeShip(shipId, reason);
    },
    teleported(shipId) {
      wrote({ name: 'teleported', shipId });
      predictor.teleported(shipId);
    },
    setPolicy(shipId, policy) {
      wrote({ name: 'setPolicy', shipId, policy });
      predictor.setPolicy(shipId, policy);
    },
    configure(changes) {
      wrote({ name: 'configure', changes });
      return predictor.configure(changes);
    },
    restore(snapshot, now) {
      write({ kind: 'called', at: now, call: { name: 'restore', snapshot } });
      return predictor.restore(snapshot, now);
    },
  };
}

/** Wraps undecoded messages: decoded ones are written, with the events of the frames they supersede. */
interface PendingRecorder {
  readonly wrap: (message: PendingMessage, at: number) => PendingMessage;
  /** Drops waiting messages. */
  readonly forget: () => void;
}

function createPendingRecorder(write: Write): PendingRecorder {
  let superseded: WorldEvent[] = [];
  const wrap = (message: PendingMessage, at: number): PendingMessage => ({
    isFrame: message.isFrame,
    events() {
      const events = message.events();
      superseded = [...superseded, ...events].slice(-MAX_KEPT_EVENTS);
      return events;
    },
    decode() {
      const decoded = message.decode();
      if (!decoded.ok) return decoded;
      const { value } = decoded;
      if (value.kind === 'frame' && superseded.length > 0) {
        write({ kind: 'received', at, message: { ...value, events: [...superseded, ...value.events] } });
        superseded = [];
      } else write({ kind: 'received', at, message: value });
      return decoded;
    },
  });
  return {
    wrap,
    forget() {
      superseded = [];
    },
  };
}

/**
 * Feeds recorded entries to a predictor; `advanced` is called after each display frame.
 *
 * @example
 * ```ts
 * const again = createPredictor();
 * replayEntries(again, entries, (at) => console.log(at, again.view(at).own?.feetHeight));
 * ```
 */
export function replayEntries(
  predictor: Predictor,
  entries: Iterable<PredictorEntry>,
  advanced: (at: number) => void,
): void {
  for (const entry of entries) {
    if (entry.kind === 'received') predictor.receive(entry.message, entry.at);
    if (entry.kind === 'called') callAgain(predictor, entry.call, entry.at);
    if (entry.kind !== 'advanced') continue;
    predictor.advance(entry.controls, entry.at);
    predictor.takeOutgoing();
    advanced(entry.at);
  }
}

function callAgain(predictor: Predictor, call: PredictorCall, at: number): void {
  switch (call.name) {
    case 'setOwnShip':
      predictor.setOwnShip(call.shipId);
      break;
    case 'removeShip':
      predictor.removeShip(call.shipId, call.reason);
      break;
    case 'teleported':
      predictor.teleported(call.shipId);
      break;
    case 'setPolicy':
      predictor.setPolicy(call.shipId, call.policy);
      break;
    case 'configure':
      // The predictor checks it as for any caller.
      predictor.configure(call.changes as Partial<Defaults>);
      break;
    case 'restore':
      predictor.restore(call.snapshot, at);
      break;
    case 'reset':
      predictor.reset();
  }
}
