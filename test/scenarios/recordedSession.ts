import { type Authority, createAuthority } from '../../src/authority';
import type { Settings, ShipInit } from '../../src/dynamics';
import {
  createLoopbackLink,
  type LoopbackLink,
  NETWORK_PRESETS,
  type NetworkPreset,
  type Recording,
  type RecordingEntry,
} from '../../src/scenarios';
import { type ClientMessage, decodeServerMessage, encodeClientMessage } from '../../src/wire';
import { input, MOON, shipOf, valueOf } from '../authority/moon';

/** A loopback link over the Moon that starts at wall second 100, with 'ann' flying 'own' from a scenario's start. */
export function moonExchange(
  scenario: string,
  preset: NetworkPreset,
  seed = 1,
  legacy = false,
  settings: Partial<Settings> = {},
): LoopbackLink {
  const authority = valueOf(createAuthority({ ...MOON, legacy, settings }));
  return flownBy(authority, shipOf(scenario), preset, seed);
}

/** A loopback link as of moonExchange, over this world and with this ship. */
export function flownBy(
  authority: Authority,
  ship: ShipInit,
  preset: NetworkPreset,
  seed: number,
): LoopbackLink {
  const order = { shipId: 'own', playerId: 'ann', name: 'Own', ship };
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

/** Ten seconds of the opening, flown with three inputs. */
export function flown(
  disturb: (second: number, exchange: ReturnType<typeof moonExchange>) => void = () => undefined,
): Recording {
  const exchange = moonExchange('opening', 'broadband');
  const client = listen(exchange);
  client.say({ kind: 'ping', id: 1 }, 100);
  client.say(
    {
      kind: 'inputs',
      inputs: [
        input(1, 2, 30, { thrustLevel: 0.2, attitudeHold: true }),
        input(2, 3, 75, { rotationInput: [0.1, 0, 0.4] }),
        input(3, 4, 0, {}),
      ],
    },
    100.1,
  );
  for (let second = 1; second <= 12; second++) {
    client.runTo(100.5 + second);
    disturb(second, exchange);
  }
  return recordingOf(client);
}
