import fc from 'fast-check';
import { expect, it, onTestFinished, vi } from 'vitest';
import { createAccounts } from '../../src/gateway/accounts';
import { createClient, disconnect } from '../../src/gateway/clients/client';
import { receive } from '../../src/gateway/clients/receive';
import { readText } from '../../src/gateway/clients/messages';
import type { GatewayState } from '../../src/gateway/state';
import { createFakeGateway } from './fakeGateway';

const SECRET = 'a secret that is long enough for a test';

/** A client of a gateway that has no world yet, and all messages sent to its socket. */
async function connectedClient() {
  const secret = { secret: SECRET, lifetime: 3600, now: () => 1_800_000_000 };
  const accounts = await createAccounts([{ username: 'one', playerId: 'p1', password: 'x' }], secret);
  const sent: string[] = [];
  const socket = {
    readyState: 1,
    OPEN: 1,
    send: (text: string) => sent.push(text),
    close: (code: number) => sent.push(`closed ${code}`),
    once: () => undefined,
    terminate: () => undefined,
    pause: () => undefined,
  };
  const clients = new Set();
  const feed = { newest: () => null };
  const clock = { now: 1_800_000_000 };
  const options = { clock: () => clock.now, nonce: () => 'session', log: () => undefined };
  const gateway = { accounts, clients, feed, options, world: null } as unknown as GatewayState;
  const client = createClient(socket as never, 'json', '127.0.0.1', 0);
  return {
    client,
    clock,
    gateway,
    sent,
    send: (message: object) => receive(gateway, client, Buffer.from(JSON.stringify(message)), false),
    token: (await accounts.login('one', 'x'))!.token,
    dispose: () => client.timers.forEach((timer) => clearTimeout(timer)),
  };
}

it('answers messages queued during the sign-in once the token is verified', async () => {
  const { client, sent, send, token, dispose } = await connectedClient();
  send({ type: 'auth', token });
  send({ type: 'ping' });
  send({ type: 'fly' });
  expect(sent).toEqual([]);
  await expect.poll(() => client.player?.playerId).toBe('p1');
  await expect
    .poll(() => sent)
    .toEqual(['{"type":"pong"}', expect.stringContaining('type: expected auth, control or ping')]);
  dispose();
});

it('closes a connection whose first message is not a sign-in, or whose token is wrong, with 4001', async () => {
  const eager = await connectedClient();
  eager.send({ type: 'ping' });
  expect(eager.sent).toEqual(['closed 4001']);
  const forged = await connectedClient();
  forged.send({ type: 'auth', token: `${forged.token}x` });
  forged.send({ type: 'ping' });
  await expect.poll(() => forged.sent).toEqual(['closed 4001']);
});

it.each([
  [{ thrust_level: 0.5 }, { thrustLevel: 0.5 }],
  [
    { attitudeMode: 'radial', attitude_hold: false },
    { attitudeMode: 'radial', attitudeHold: false },
  ],
  [{ controls: { rotation_input: { x: 0, y: 1, z: 0 } } }, { rotationInput: [0, 1, 0] }],
  [{ data: { thrust_level: '0.25' } }, { thrustLevel: 0.25 }],
])('reads only the members that the control message %j contains', (members, controls) => {
  const message = readText(JSON.stringify({ type: 'control', ...members }));
  expect(message).toEqual({ kind: 'control', controls });
});

it('refuses a control message without a known member, and lists the members', () => {
  expect(readText('{"type":"control","thrust":1}')).toEqual({
    kind: 'refused',
    reason:
      'control: expected one of thrust_level, translation_input, rotation_input, attitude_hold, attitude_mode, target_attitude',
  });
});

it('does not throw on any message', async () => {
  const { client, gateway, token, dispose } = await connectedClient();
  client.player = { playerId: 'p1', username: 'one', expires: Infinity };
  const names = [
    'type',
    'token',
    'controls',
    'data',
    'thrust_level',
    'rotation_input',
    'attitude_mode',
    'session',
    'since',
  ];
  const values = fc.oneof(fc.constantFrom('auth', 'ping', 'control', token), fc.jsonValue(), fc.double());
  const json = fc.dictionary(fc.constantFrom(...names), values).map((message) => JSON.stringify(message));
  const text = fc.oneof(json, fc.string(), fc.json()).map((content) => Buffer.from(content));
  const message = fc.oneof(
    text,
    fc.uint8Array({ maxLength: 400 }).map((bytes) => Buffer.from(bytes)),
  );
  fc.assert(
    fc.property(message, fc.boolean(), fc.constantFrom('json', 'stream'), (data, isBinary, protocol) => {
      Object.assign(client, { protocol, isClosing: false });
      client.messages.level = client.inputs.level = client.excess.level = Infinity;
      receive(gateway, client, data, isBinary);
    }),
    { numRuns: 2000 },
  );
  dispose();
});

it('ignores further messages of a client that it has disconnected', async () => {
  const { client, sent, send, dispose } = await connectedClient();
  client.player = { playerId: 'p1', username: 'one', expires: Infinity };
  for (let i = 0; i < 1000; i++) send({ type: 'ping' });
  expect(sent.filter((text) => text === '{"type":"pong"}')).toHaveLength(120);
  expect(sent.filter((text) => text === 'closed 4008')).toHaveLength(1);
  dispose();
});

it('tolerates one unknown message every 2 s, as a game client may send', async () => {
  const { client, clock, sent, send, dispose } = await connectedClient();
  client.player = { playerId: 'p1', username: 'one', expires: Infinity };
  for (let i = 0; i < 1000; i++) {
    clock.now += 2;
    send({ type: 'service', service: 'refuel' });
  }
  expect(sent).toHaveLength(1000);
  expect(sent.some((text) => text.startsWith('closed'))).toBe(false);
  for (let i = 0; i < 300; i++) send({ type: 'service' });
  expect(sent.at(-1)).toBe('closed 4008');
  dispose();
});

it('a connection whose client does not close it within 2 s is cut', () => {
  vi.useFakeTimers();
  onTestFinished(() => void vi.useRealTimers());
  const { connect } = createFakeGateway();
  const cut: string[] = [];
  const [hung, quick] = [connect('json'), connect('json')];
  Object.assign(hung.socket, { once: () => undefined, terminate: () => cut.push('hung') });
  Object.assign(quick.socket, { terminate: () => cut.push('quick') });
  for (const { client } of [hung, quick]) disconnect(client, 4001, 'away');
  vi.advanceTimersByTime(1999);
  expect(cut).toEqual([]);
  vi.advanceTimersByTime(1);
  expect(cut).toEqual(['hung']);
});
