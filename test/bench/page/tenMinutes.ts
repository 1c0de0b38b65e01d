import { createSession } from '../../../src/playground/server/session';
import { createPredictor } from '../../../src/prediction';
import { NETWORK_PRESETS, type Recording, type RecordingEntry } from '../../../src/scenarios';
import { decodeServerMessage, encodeClientMessage } from '../../../src/wire';

/** A recording of the page: `seconds` of a fleet at 60 frames a second, over broadband, one state a second. */
export function recordFleet(ships: number, seconds: number): Recording {
  const session = createSession();
  const predictor = createPredictor({ ownShipId: 'own' });
  const entries: RecordingEntry[] = [];
  session.operate(
    {
      kind: 'load',
      ...{ scenario: 'bounce', body: '', shipClass: '', terrain: '', legacy: false, tickRate: 1 },
      ...{ timeScale: 1, network: NETWORK_PRESETS.broadband, seed: 3, others: ships - 1 },
    },
    0,
  );
  for (let n = 0; n < seconds * 60; n++) {
    const at = n / 60;
    for (const { bytes } of session.run(at)) {
      const decoded = decodeServerMessage(bytes);
      if (!decoded.ok) throw new Error(decoded.reason);
      predictor.receive(decoded.value, at);
      entries.push({ kind: 'received', at, message: decoded.value });
    }
    predictor.advance(null, at);
    entries.push({ kind: 'advanced', at, controls: null });
    for (const message of predictor.takeOutgoing()) {
      session.send(encodeClientMessage(message), at);
      entries.push({ kind: 'sent', at, message });
    }
  }
  return { header: { note: '', shipId: 'own' }, entries };
}
