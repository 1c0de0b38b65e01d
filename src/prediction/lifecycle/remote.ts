import type { Controls } from '../../dynamics';
import type { ClientMessage, PartialFrame, ServerMessage } from '../../wire';
import type { EventNotice, WorldView } from '../drawn/view';
import type { PredictorOptions } from '../options';
import type { Removal } from '../ownership';
import { createPredictor, type Predictor } from '../predictor';

/** The predictor in a worker: what goes over the channel, either way. Everything is plain data and is copied. */

/** To the worker. */
export type ToWorker =
  | { readonly kind: 'receive'; readonly message: ServerMessage | PartialFrame; readonly now: number }
  | { readonly kind: 'refused'; readonly reason: string }
  | { readonly kind: 'advance'; readonly controls: Controls | null; readonly now: number }
  | { readonly kind: 'setOwnShip'; readonly shipId: string | null }
  | { readonly kind: 'removeShip'; readonly shipId: string; readonly reason: Removal }
  | { readonly kind: 'teleported'; readonly shipId: string }
  | { readonly kind: 'reset' }
  | { readonly kind: 'dispose' };

/** From the worker: the answer to each advance. */
export interface FromWorker {
  readonly kind: 'advanced';
  readonly view: WorldView;
  readonly outgoing: readonly ClientMessage[];
  readonly notices: readonly EventNotice[];
}

/** What of a Worker, a MessagePort or a worker's own global scope is used. */
export interface Channel {
  /** Sends a copy of plain data. */
  postMessage: (message: unknown) => void;
  /** Called with what comes. */
  onmessage: ((event: { readonly data: unknown }) => void) | null;
}

/**
 * In the worker: makes a predictor of `options` and lets the page drive it through `channel` (`self`). Terrains are functions, which
 * cannot be sent: they are made here. Throws as createPredictor does.
 *
 * @example
 * servePredictor(self, { ownShipId: 'my-ship', terrains: { luna }, defaults: { terrain: 'luna' } });
 */
export function servePredictor(channel: Channel, options: PredictorOptions = {}): Predictor {
  const predictor = createPredictor(options);
  let notices: EventNotice[] = [];
  predictor.onEvent((notice) => notices.push(notice));
  channel.onmessage = ({ data }) => {
    const message = data as ToWorker;
    carryOut(predictor, message);
    if (message.kind !== 'advance') return;
    const outgoing = predictor.takeOutgoing();
    const answer: FromWorker = { kind: 'advanced', view: predictor.view(message.now), outgoing, notices };
    channel.postMessage(answer);
    notices = [];
  };
  return predictor;
}

function carryOut(predictor: Predictor, message: ToWorker): void {
  switch (message.kind) {
    case 'receive':
      predictor.receive(message.message, message.now);
      break;
    case 'refused':
      predictor.refused(message.reason);
      break;
    case 'advance':
      predictor.advance(message.controls, message.now);
      break;
    case 'setOwnShip':
      predictor.setOwnShip(message.shipId);
      break;
    case 'removeShip':
      predictor.removeShip(message.shipId, message.reason);
      break;
    case 'teleported':
      predictor.teleported(message.shipId);
      break;
    case 'reset':
      predictor.reset();
      break;
    case 'dispose':
      predictor.dispose();
  }
}

/** A predictor in a worker, as the page sees it: the same calls, a view that is one answer old. */
export interface RemotePredictor
  extends
    Pick<Predictor, 'receive' | 'refused' | 'advance' | 'takeOutgoing' | 'onEvent'>,
    Pick<Predictor, 'setOwnShip' | 'removeShip' | 'teleported' | 'reset' | 'dispose'> {
  /** The newest view that has come back; null before the first. It is the caller's to keep. */
  readonly view: () => WorldView | null;
}

/**
 * In the page: drives the predictor that servePredictor made at the other end of `channel` (a Worker). At most one advance is on its
 * way: while the worker has not answered, later ones wait as one, with the newest controls.
 *
 * @example
 * const predictor = connectPredictor(new Worker(new URL('./predictor.js', import.meta.url), { type: 'module' }));
 */
export function connectPredictor(channel: Channel): RemotePredictor {
  const listeners = new Set<(notice: EventNotice) => void>();
  let outgoing: ClientMessage[] = [];
  let newest: WorldView | null = null;
  let underway = false;
  let waiting: ToWorker | null = null;
  const post = (message: ToWorker): void => channel.postMessage(message);
  channel.onmessage = ({ data }) => {
    const answer = data as FromWorker;
    newest = answer.view;
    outgoing.push(...answer.outgoing);
    underway = waiting !== null;
    if (waiting !== null) post(waiting);
    waiting = null;
    for (const notice of answer.notices) for (const listener of listeners) listener(notice);
  };
  return {
    receive: (message, now) => post({ kind: 'receive', message, now }),
    refused: (reason) => post({ kind: 'refused', reason }),
    advance(controls, now) {
      const message: ToWorker = { kind: 'advance', controls, now };
      if (underway) waiting = message;
      else post(message);
      underway = true;
    },
    view: () => newest,
    takeOutgoing() {
      const taken = outgoing;
      outgoing = [];
      return taken;
    },
    onEvent(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
    setOwnShip: (shipId) => post({ kind: 'setOwnShip', shipId }),
    removeShip: (shipId, reason) => post({ kind: 'removeShip', shipId, reason }),
    teleported: (shipId) => post({ kind: 'teleported', shipId }),
    reset: () => post({ kind: 'reset' }),
    dispose() {
      listeners.clear();
      post({ kind: 'dispose' });
      channel.onmessage = null;
    },
  };
}
