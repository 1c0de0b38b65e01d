import { expect, it } from 'vitest';
import { NEUTRAL_CONTROLS } from '../../src/dynamics';
import { MAX_MESSAGE } from '../../src/game';
import {
  address,
  connect,
  heard,
  listen,
  say,
  server,
  sockets,
  STATE,
  stopServer,
  until,
  useGameServer,
  welcomed,
} from './gameServer';

useGameServer();

it('authenticates on open, and reports welcome and states', async () => {
  const { told } = await welcomed();
  expect(heard).toEqual([{ type: 'auth', token: 'jwt-1' }]);
  say(STATE);
  say({ type: 'state', data: { tick: 8, ships: [] } });
  await until(() => told.includes('frame 8'));
  expect(told.filter((text) => !text.startsWith('status'))).toEqual([
    'welcome {"type":"welcome","player_id":"p","ship_id":"a"}',
    'frame 7',
    'frame 8',
  ]);
});

it('sends controls from the welcome on, in the caller’s own envelope', async () => {
  const made = connect({ pack: (controls) => ({ type: 'control', data: { thrust: controls.thrustLevel } }) });
  expect(made.live.sendControls(NEUTRAL_CONTROLS)).toBe(false);
  await until(() => heard.length === 1);
  say({ type: 'welcome' });
  await until(() => made.told.some((text) => text.startsWith('welcome')));
  expect(made.live.sendControls({ ...NEUTRAL_CONTROLS, thrustLevel: 0.5 })).toBe(true);
  await until(() => heard.length === 3);
  expect(heard.slice(1)).toEqual([
    { type: 'control', data: { thrust: 0 } },
    { type: 'control', data: { thrust: 0.5 } },
  ]);
});

it('does not take refused states for a pause', async () => {
  const { clock, told } = await welcomed();
  for (let second = 0; second < 6; second++) {
    say({ ...STATE, tick: -1 });
    await until(() => told.filter((text) => text.startsWith('refused state.tick')).length === second + 1);
    clock.pass(1);
  }
  expect(heard).toHaveLength(1);
  expect(told.filter((text) => /No states|paused/.test(text))).toEqual([]);
});

it('does not take a server of one state in 5 s for silent before three of them are missing', async () => {
  const { clock, told } = await welcomed();
  say({ ...STATE, tick_rate: 0.2 });
  await until(() => told.includes('frame 7'));
  clock.pass(14.9);
  expect(told.filter((text) => text.includes('No states'))).toEqual([]);
  clock.pass(0.2);
  expect(told.at(-1)).toContain('No states');
});

it('pings each 30 s, and reconnects when no pong comes in 10 s', async () => {
  const { clock, told } = await welcomed();
  for (let second = 0; second < 30; second++) {
    say({ ...STATE, tick: second });
    await until(() => told.includes(`frame ${second}`));
    clock.pass(1);
  }
  await until(() => heard.length === 2);
  expect(heard[1]).toEqual({ type: 'ping' });
  say({ type: 'pong' });
  say(STATE);
  await until(() => told.filter((text) => text === 'frame 7').length === 2);
  clock.pass(12);
  await until(() => heard.length === 3);
  clock.pass(2.5);
  expect(told.some((text) => text.includes('did not answer a ping within 10 s'))).toBe(true);
  await until(() => sockets.length === 2);
});

it('reports that nothing answers, keeps trying, and reports that it is back', async () => {
  const port = Number(new URL(address).port);
  await stopServer();
  const { clock, told } = connect();
  await until(() => told.some((text) => text.startsWith('status waiting')));
  expect(told.at(-1)).toBe(
    `status waiting: Nothing answers at ${address} (code 1006). Is the server running? Retrying in 1 s.`,
  );
  await listen(port);
  clock.pass(1);
  await until(() => heard.length === 1);
  say({ type: 'welcome' });
  await until(() => told.at(-1)!.startsWith('welcome'));
  for (const socket of server.clients) socket.terminate();
  await until(() => told.at(-1)!.includes('was lost'));
  clock.pass(2);
  await until(() => heard.length === 2);
  say({ type: 'welcome' });
  await until(() => told.includes(`status live: Connected to ${address} again.`));
});

it.each([
  [4001, 'refused the sign-in'],
  [4003, 'does not accept pages from here'],
])('does not reconnect after close code %i, and reports why', async (code, words) => {
  const { clock, told, live } = connect();
  await until(() => heard.length === 1);
  sockets[0]!.close(code, 'no');
  await until(() => told.some((text) => text.startsWith('status refused')));
  expect(told.at(-1)).toContain(words);
  clock.pass(3600);
  expect(sockets).toHaveLength(1);
  live.retry();
  await until(() => sockets.length === 2);
});

it('has one socket at any time, however often a retry is requested', async () => {
  const { told, live } = await welcomed();
  for (let i = 0; i < 5; i++) live.retry();
  sockets[0]!.terminate();
  await until(() => told.at(-1)!.includes('was lost'));
  for (let i = 0; i < 5; i++) live.retry();
  await until(() => heard.length === 2);
  expect(sockets).toHaveLength(2);
  expect(server.clients.size).toBe(1);
});

it('reports destroyed and removed ships, and keeps a refreshed token for the next connection', async () => {
  const { clock, told } = await welcomed();
  say({ type: 'ship.destroyed', ship_id: 'a', ship_name: 'Kite', body: 'Luna', reason: 'collision' });
  say({ type: 'ship.removed', ship_id: 'b' });
  say({ type: 'token_refresh', token: 'jwt-2' });
  say({ type: 'player_joined', name: 'x' });
  await until(() => told.includes('other player_joined'));
  expect(told).toContain('gone a {"name":"Kite","body":"Luna","reason":"collision"}');
  expect(told).toContain('gone b null');
  expect(told).toContain('token jwt-2');
  sockets[0]!.terminate();
  await until(() => told.at(-1)!.includes('was lost'));
  clock.pass(2);
  await until(() => heard.length === 2);
  expect(heard[1]).toEqual({ type: 'auth', token: 'jwt-2' });
});

it('refuses invalid messages by name, and goes on', async () => {
  const { told, live } = await welcomed();
  const raw = (data: string | Uint8Array) => sockets[0]!.send(data);
  raw('{');
  raw(Uint8Array.of(1, 2));
  raw(JSON.stringify({ type: 'state', tick: 1, ships: [], padding: 'x'.repeat(MAX_MESSAGE) }));
  say({ type: 'state', ships: [] });
  say({ type: 'ship.removed' });
  say({ type: 'token_refresh', token: 5 });
  for (const odd of [null, 5, [], 'text', { type: 7 }]) say(odd);
  say(STATE);
  await until(() => told.includes('frame 7'));
  expect(told.filter((text) => text.startsWith('refused'))).toEqual([
    'refused message: not JSON',
    'refused message: expected text, got bytes',
    expect.stringMatching(/^refused message: expected at most 65536 bytes/),
    'refused state.tick: missing',
    'refused removed.ship_id: expected a string',
    'refused token_refresh.token: expected a string',
  ]);
  expect(live.send({ type: 'service', note: 'x'.repeat(MAX_MESSAGE) })).toBe(false);
  expect(live.state().phase).toBe('live');
});

it('does not send controls that the host packs into more than 64 KB', async () => {
  const { told, live } = await welcomed({ pack: () => ({ padding: 'x'.repeat(MAX_MESSAGE) }) });
  expect(live.sendControls(NEUTRAL_CONTROLS)).toBe(false);
  expect(told.at(-1)).toBe(`refused message: expected at most ${MAX_MESSAGE} bytes`);
});

it('reports controls that cannot be packed, and does not send them', async () => {
  const { told, live } = await welcomed();
  expect(live.sendControls({ ...NEUTRAL_CONTROLS, thrustLevel: NaN })).toBe(false);
  expect(told.at(-1)).toMatch(/^refused .*thrust/);
});

it('reports what a host’s packing throws', async () => {
  const { told, live } = await welcomed({
    pack: () => {
      // What JavaScript may throw.
      // eslint-disable-next-line @typescript-eslint/only-throw-error
      throw 'no envelope';
    },
  });
  expect(live.sendControls(NEUTRAL_CONTROLS)).toBe(false);
  expect(told.at(-1)).toBe('refused no envelope');
});

it('gives up when no welcome comes in 10 s', async () => {
  const { clock, told } = connect();
  await until(() => heard.length === 1);
  say(STATE);
  await until(() => told.includes('refused state: came before the welcome'));
  clock.pass(10);
  expect(told.at(-1)).toContain('sent no welcome within 10 s');
});

it('reports an invalid address like a server that does not answer', () => {
  const { told } = connect({
    openSocket: () => {
      throw new Error('invalid address');
    },
  });
  expect(told.at(-1)).toMatch(/^status waiting: Nothing answers/);
});
