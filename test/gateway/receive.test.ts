import fc from 'fast-check';
import { expect, it } from 'vitest';
import { createAccounts } from '../../src/gateway/accounts';
import { createClient } from '../../src/gateway/clients/client';
import { receive } from '../../src/gateway/clients/receive';
import { readText } from '../../src/gateway/clients/speech';
import type { Place } from '../../src/gateway/place';

const SECRET = 'a secret that is long enough for a test';

/** A client of a gateway without a world yet, and all messages sent to its socket. */
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
  const place = { accounts, clients, feed, options, world: null } as unknown as Place;
  const client = createClient(socket as never, 'json', '127.0.0.1', 0);
  return {
    client,
    clock,
    place,
    sent,
    say: (message: object) => receive(place, client, Buffer.from(JSON.stringify(message)), false),
    token: (await accounts.login('one', 'x'))!.token,
    dispose: () => client.timers.forEach((timer) => clearTimeout(timer)),
  };
}

it('answers messages that follow the sign-in at once, after the token has been verified', async () => {
  const { client, sent, say, token, dispose } = await connectedClient();
  say({ type: 'auth', token });
  say({ type: 'ping' });
  say({ type: 'fly' });
  expect(sent).toEqual([]);
  await expect.poll(() => client.player?.playerId).toBe('p1');
  await expect
    .poll(() => sent)
    .toEqual(['{"type":"pong"}', expect.stringContaining('type: expected auth, control or ping')]);
  dispose();
});

it('closes a connection whose first message is not a sign-in, or whose token is wrong, with 4001', async () => {
  const eager = await connectedClient();
  eager.say({ type: 'ping' });
  expect(eager.sent).toEqual(['closed 4001']);
  const forged = await connectedClient();
  forged.say({ type: 'auth', token: `${forged.token}x` });
  forged.say({ type: 'ping' });
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
])('takes from the control message %j what it has, and leaves the rest as it is', (members, controls) => {
  const said = readText(JSON.stringify({ type: 'control', ...members }));
  expect(said).toEqual({ kind: 'control', controls });
});

it('refuses a control message without a control, and says what there is', () => {
  expect(readText('{"type":"control","thrust":1}')).toEqual({
    kind: 'refused',
    reason:
      'control: expected one of thrust_level, translation_input, rotation_input, attitude_hold, attitude_mode, target_attitude',
  });
});

it('never throws, whatever a client sends', async () => {
  const { client, place, token, dispose } = await connectedClient();
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
  const text = fc.oneof(json, fc.string(), fc.json()).map((said) => Buffer.from(said));
  const message = fc.oneof(
    text,
    fc.uint8Array({ maxLength: 400 }).map((bytes) => Buffer.from(bytes)),
  );
  fc.assert(
    fc.property(message, fc.boolean(), fc.constantFrom('json', 'stream'), (data, isBinary, protocol) => {
      Object.assign(client, { protocol, isDismissed: false });
      client.messages.level = client.inputs.level = client.excess.level = Infinity;
      receive(place, client, data, isBinary);
    }),
    { numRuns: 2000 },
  );
  dispose();
});

it('hears nothing more of a client that it has sent away', async () => {
  const { client, sent, say, dispose } = await connectedClient();
  client.player = { playerId: 'p1', username: 'one', expires: Infinity };
  for (let i = 0; i < 1000; i++) say({ type: 'ping' });
  expect(sent.filter((text) => text === '{"type":"pong"}')).toHaveLength(120);
  expect(sent.filter((text) => text === 'closed 4008')).toHaveLength(1);
  dispose();
});

it('bears with a client of the game’s that now and then sends what is not known here', async () => {
  const { client, clock, sent, say, dispose } = await connectedClient();
  client.player = { playerId: 'p1', username: 'one', expires: Infinity };
  for (let i = 0; i < 1000; i++) {
    clock.now += 2;
    say({ type: 'service', service: 'refuel' });
  }
  expect(sent).toHaveLength(1000);
  expect(sent.some((text) => text.startsWith('closed'))).toBe(false);
  for (let i = 0; i < 300; i++) say({ type: 'service' });
  expect(sent.at(-1)).toBe('closed 4008');
  dispose();
});
