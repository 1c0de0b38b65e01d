import { createAuthority } from '../../src/authority';
import type { Settings } from '../../src/dynamics';
import {
  createLoopbackLink,
  type LoopbackLink,
  NETWORK_PRESETS,
  type NetworkPreset,
  type Recording,
  type RecordingEntry,
} from '../../src/scenarios';
import { type ClientMessage, decodeServerMessage, encodeClientMessage } from '../../src/wire';
import { MOON, shipOf, valueOf } from '../authority/moon';

/** A loopback link over the Moon that starts at wall second 100, with 'ann' flying 'own' from a scenario's start. */
export function moonExchange(
  scenario: string,
  preset: NetworkPreset,
  seed = 1,
  legacy = false,
  settings: Partial<Settings> = {},
): LoopbackLink {
  const authority = valueOf(createAuthority({ ...MOON, legacy, settings }));
  const order = { shipId: 'own', playerId: 'ann', name: 'Own', ship: shipOf(scenario) };
  const exchange = createLoopbackLink(authority, NETWORK_PRESETS[preset], seed, 100);
  const reason = authority.spawn(order) ?? exchange.connect('ann', 'own', 100);
  if (reason !== null) throw new Error(reason);
  return exchange;
}

export interface Client {
  readonly entries: RecordingEntry[];
  readonly say: (message: ClientMessage, now: number) => void;
  /** Runs the link to `now`, and takes what has arrived. */
  readonly runTo: (now: number) => void;
}

/** A client that records what it receives and sends. */
export function listen(exchange: LoopbackLink): Client {
  const entries: RecordingEntry[] = [];
  const client: Client = {
    entries,
    say(message, now) {
      client.runTo(now);
      entries.push({ kind: 'sent', at: now, message });
      exchange.send('ann', encodeClientMessage(message), now);
    },
    runTo(now) {
      exchange.run(now);
      for (const { bytes, at } of exchange.deliver('ann', now))
        entries.push({ kind: 'received', at, message: valueOf(decodeServerMessage(bytes)) });
    },
  };
  return client;
}

export function recordingOf(client: Client): Recording {
  return { header: { note: 'a test', shipId: 'own' }, entries: client.entries };
}
