import { createSession, type Session } from '../../../src/playground/server/session';
import { createPredictor, type WorldView } from '../../../src/prediction';
import { NETWORK_PRESETS, type Recording, type RecordingEntry } from '../../../src/scenarios';
import { decodeServerMessage, encodeClientMessage } from '../../../src/wire';

/** A scenario to play: `others` ships beside the own one, for some wall seconds. */
export interface Play {
  readonly scenario: string;
  readonly others: number;
  readonly seconds: number;
  /** Called before each display frame. */
  readonly before?: (session: Session, now: number) => void;
  /** Called with the view of each display frame. */
  readonly onView?: (view: WorldView) => void;
}

/**
 * Plays a scenario through the worker's session and a predictor, as the page does, and records it: 60 frames a second, over broadband,
 * one state a second.
 */
export function recordPlay({ scenario, others, seconds, before, onView }: Play): Recording {
  const session = createSession();
  const predictor = createPredictor({ ownShipId: 'own' });
  const entries: RecordingEntry[] = [];
  const load = { kind: 'load', scenario, body: '', shipClass: '', terrain: '', legacy: false } as const;
  const options = { tickRate: 1, timeScale: 1, network: NETWORK_PRESETS.broadband, seed: 3, others };
  const reason = session.operate({ ...load, ...options }, 0);
  if (reason !== null) throw new Error(reason);
  for (let n = 0; n < seconds * 60; n++) {
    const at = n / 60;
    before?.(session, at);
    for (const { bytes } of session.run(at)) {
      const decoded = decodeServerMessage(bytes);
      if (!decoded.ok) throw new Error(decoded.reason);
      predictor.receive(decoded.value, at);
      entries.push({ kind: 'received', at, message: decoded.value });
    }
    predictor.advance(null, at);
    entries.push({ kind: 'advanced', at, controls: null });
    onView?.(predictor.view(at));
    for (const message of predictor.takeOutgoing()) {
      session.send(encodeClientMessage(message), at);
      entries.push({ kind: 'sent', at, message });
    }
  }
  return { header: { note: '', shipId: 'own' }, entries };
}
