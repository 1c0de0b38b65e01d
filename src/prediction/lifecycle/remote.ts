import type { Controls, Result } from '../../dynamics';
import type { ClientMessage, PartialFrame, ServerMessage } from '../../wire';
import type { EventNotice, WorldView } from '../drawn/view';
import type { Defaults, PredictorOptions } from '../options';
import type { Removal } from '../ownership';
import type { Predictor } from '../calls/api';
import { createPredictor } from '../predictor';
import type { Policy } from '../simulation/track';
import type { PredictorSnapshot } from './snapshot';

/** A predictor in a worker: the messages in both directions. All are plain data and are copied. */

/** To the worker. */
export type ToWorker =
  | { readonly kind: 'receive'; readonly message: ServerMessage | PartialFrame; readonly now: number }
  | { readonly kind: 'refused'; readonly reason: string }
  | { readonly kind: 'advance'; readonly controls: Controls | null; readonly now: number }
  | { readonly kind: 'setOwnShip'; readonly shipId: string | null }
  | { readonly kind: 'removeShip'; readonly shipId: string; readonly reason: Removal }
  | { readonly kind: 'teleported'; readonly shipId: string }
  | { readonly kind: 'setPolicy'; readonly shipId: string; readonly policy: Policy }
  | { readonly kind: 'configure'; readonly changes: Partial<Defaults> }
  | { readonly kind: 'snapshot'; readonly now: number }
  | { readonly kind: 'restore'; readonly snapshot: unknown; readonly now: number }
  | { readonly kind: 'reset' }
  | { readonly kind: 'dispose' };

/** From the worker: the answer to each advance and to each request for a snapshot, in their order. */
export type FromWorker =
  | {
      readonly kind: 'advanced';
      readonly view: WorldView;
      readonly outgoing: readonly ClientMessage[];
      readonly notices: readonly EventNotice[];
    }
  | { readonly kind: 'snapshot'; readonly snapshot: PredictorSnapshot };

/** The members that a Worker, a MessagePort and a worker's global scope share. */
export interface Channel {
  /** Sends a copy of plain data. */
  postMessage: (message: unknown) => void;
  /** Called with each message's event: `never`, so that workers, ports and scopes of any type library fit. */
  onmessage: ((event: never) => void) | null;
}

/**
 * In the worker: creates a predictor with `options` and lets the page drive it through `channel` (`self`). Terrains are functions, which
 * cannot be sent, so they are created here. Throws as createPredictor does. After `dispose` the channel is released.
 *
 * @example
 * ```ts
 * servePredictor(self, { ownShipId: 'ship-1', terrains: { luna: () => 0 }, defaults: { terrain: 'luna' } });
 * ```
 */
export function servePredictor(channel: Channel, options: PredictorOptions = {}): Predictor {
  const predictor = createPredictor(options);
  let notices: EventNotice[] = [];
  predictor.onEvent((notice) => notices.push(notice));
  const answer = (message: FromWorker): void => channel.postMessage(message);
  channel.onmessage = ({ data }: { readonly data: unknown }) => {
    const message = data as ToWorker;
    (CALLS[message.kind] as (predictor: Predictor, message: ToWorker) => void)(predictor, message);
    if (message.kind === 'dispose') channel.onmessage = null;
    if (message.kind === 'snapshot') answer({ kind: 'snapshot', snapshot: predictor.snapshot(message.now) });
    if (message.kind !== 'advance') return;
    const outgoing = predictor.takeOutgoing();
    answer({ kind: 'advanced', view: predictor.view(message.now), outgoing, notices });
    notices = [];
  };
  return predictor;
}

/** The call for each kind of message. Invalid ones are counted in the diagnosis, with the reason. */
const CALLS: {
  readonly [K in ToWorker['kind']]: (predictor: Predictor, message: Extract<ToWorker, { kind: K }>) => void;
} = {
  receive: (predictor, { message, now }) => predictor.receive(message, now),
  refused: (predictor, { reason }) => predictor.refused(reason),
  advance: (predictor, { controls, now }) => predictor.advance(controls, now),
  setOwnShip: (predictor, { shipId }) => predictor.setOwnShip(shipId),
  removeShip: (predictor, { shipId, reason }) => predictor.removeShip(shipId, reason),
  teleported: (predictor, { shipId }) => predictor.teleported(shipId),
  setPolicy: (predictor, { shipId, policy }) => predictor.setPolicy(shipId, policy),
  configure: (predictor, { changes }) => noteRefusal(predictor, predictor.configure(changes)),
  snapshot: () => undefined,
  restore: (predictor, { snapshot, now }) => noteRefusal(predictor, predictor.restore(snapshot, now)),
  reset: (predictor) => predictor.reset(),
  dispose: (predictor) => predictor.dispose(),
};

function noteRefusal(predictor: Predictor, outcome: Result<null>): void {
  if (!outcome.ok) predictor.refused(outcome.reason);
}

/** The page's side of a predictor in a worker: the same calls, with a view that is one answer old. */
export interface RemotePredictor
  extends
    Pick<Predictor, 'receive' | 'refused' | 'advance' | 'takeOutgoing' | 'onEvent'>,
    Pick<Predictor, 'setOwnShip' | 'removeShip' | 'teleported' | 'setPolicy' | 'reset' | 'dispose'> {
  /** The newest view received; null before the first. The caller may keep it. */
  readonly view: () => WorldView | null;
  /** As Predictor.configure; the reason of a refusal is in the next view's `diagnosis.lastRefusal`. */
  readonly configure: (changes: Partial<Defaults>) => void;
  /** As Predictor.snapshot, resolved when the worker has answered; never after `dispose`. */
  readonly snapshot: (now: number) => Promise<PredictorSnapshot>;
  /** As Predictor.restore; the reason of a refusal is in the next view's `diagnosis.lastRefusal`. */
  readonly restore: (snapshot: unknown, now: number) => void;
}

/** The pending messages of one end. */
interface Link {
  readonly listeners: Set<(notice: EventNotice) => void>;
  readonly requests: ((snapshot: PredictorSnapshot) => void)[];
  outgoing: ClientMessage[];
  newest: WorldView | null;
  /** Whether an advance was sent and not answered yet. */
  underway: boolean;
  /** The newest advance, waiting for that answer. */
  waiting: ToWorker | null;
}

/**
 * In the page: drives the predictor that servePredictor created at the other end of `channel` (a Worker). At most one advance is
 * pending: until the worker answers, later ones are merged into one with the newest controls. `dispose` releases the channel and leaves
 * the worker itself to the caller (`worker.terminate()`).
 *
 * @example
 * ```ts
 * const worker = new Worker(new URL('./predictor.js', import.meta.url), { type: 'module' });
 * const predictor = connectPredictor(worker);
 * predictor.advance(NEUTRAL_CONTROLS, performance.now() / 1000);
 * const view = predictor.view(); // null until the worker has answered once
 * ```
 */
export function connectPredictor(channel: Channel): RemotePredictor {
  const link: Link = {
    listeners: new Set(),
    requests: [],
    outgoing: [],
    newest: null,
    underway: false,
    waiting: null,
  };
  const post = (message: ToWorker): void => channel.postMessage(message);
  channel.onmessage = ({ data }: { readonly data: unknown }) => receive(link, data as FromWorker, post);
  return { ...callsThrough(post), ...ownCalls(link, post, channel) };
}

/** Calls that are sent to the worker unchanged. */
function callsThrough(post: (message: ToWorker) => void) {
  return {
    receive: (message, now) => post({ kind: 'receive', message, now }),
    refused: (reason) => post({ kind: 'refused', reason }),
    setOwnShip: (shipId) => post({ kind: 'setOwnShip', shipId }),
    removeShip: (shipId, reason) => post({ kind: 'removeShip', shipId, reason }),
    teleported: (shipId) => post({ kind: 'teleported', shipId }),
    setPolicy: (shipId, policy) => post({ kind: 'setPolicy', shipId, policy }),
    configure: (changes) => post({ kind: 'configure', changes }),
    restore: (snapshot, now) => post({ kind: 'restore', snapshot, now }),
    reset: () => post({ kind: 'reset' }),
  } satisfies Partial<RemotePredictor>;
}

/** Calls that also act on this side. */
function ownCalls(link: Link, post: (message: ToWorker) => void, channel: Channel) {
  return {
    advance(controls, now) {
      const message: ToWorker = { kind: 'advance', controls, now };
      if (link.underway) link.waiting = message;
      else post(message);
      link.underway = true;
    },
    view: () => link.newest,
    takeOutgoing() {
      const taken = link.outgoing;
      link.outgoing = [];
      return taken;
    },
    onEvent(listener) {
      link.listeners.add(listener);
      return () => link.listeners.delete(listener);
    },
    snapshot(now) {
      post({ kind: 'snapshot', now });
      return new Promise((resolve) => link.requests.push(resolve));
    },
    dispose() {
      link.listeners.clear();
      post({ kind: 'dispose' });
      channel.onmessage = null;
    },
  } satisfies Partial<RemotePredictor>;
}

function receive(link: Link, answer: FromWorker, post: (message: ToWorker) => void): void {
  if (answer.kind === 'snapshot') {
    link.requests.shift()?.(answer.snapshot);
    return;
  }
  link.newest = answer.view;
  link.outgoing.push(...answer.outgoing);
  link.underway = link.waiting !== null;
  if (link.waiting !== null) post(link.waiting);
  link.waiting = null;
  for (const notice of answer.notices) for (const listener of link.listeners) listener(notice);
}
