import type { Controls } from '../dynamics';
import type { ClientMessage, PartialFrame, ServerMessage } from '../wire';
import { lastControls } from './inputs/sending';
import type { Predictor } from './predictor';

/** What went through a predictor, in its order; `at`: client wall s. A JSON line each, as rehearsal writes them. */
export type PredictorEntry =
  | { readonly kind: 'received'; readonly at: number; readonly message: ServerMessage | PartialFrame }
  | { readonly kind: 'sent'; readonly at: number; readonly message: ClientMessage }
  | { readonly kind: 'advanced'; readonly at: number; readonly controls: Controls | null };

/**
 * The same predictor, every message, input and time of which is handed to `write` (PREDICTION, Diagnosis). Nothing else goes into
 * a predictor but the calls that say whose ship is whose, so feeding the entries to a new one does the same again, to the bit.
 */
export function recordPredictor(predictor: Predictor, write: (entry: PredictorEntry) => void): Predictor {
  let now = 0;
  const taken = (): ClientMessage[] => {
    const messages = predictor.takeOutgoing();
    for (const message of messages) write({ kind: 'sent', at: now, message });
    return messages;
  };
  return {
    ...predictor,
    receive(message, at) {
      write({ kind: 'received', at, message });
      predictor.receive(message, at);
    },
    advance(controls, at) {
      now = at;
      write({ kind: 'advanced', at, controls });
      predictor.advance(controls, at);
    },
    takeOutgoing: taken,
    takeControls: () => lastControls(taken()),
  };
}

/** Feeds recorded entries to a predictor; `advanced` is called after each display frame. */
export function replayEntries(
  predictor: Predictor,
  entries: Iterable<PredictorEntry>,
  advanced: (at: number) => void,
): void {
  for (const entry of entries) {
    if (entry.kind === 'received') predictor.receive(entry.message, entry.at);
    if (entry.kind !== 'advanced') continue;
    predictor.advance(entry.controls, entry.at);
    predictor.takeOutgoing();
    advanced(entry.at);
  }
}
