/** The gateway's HTTP answers. */
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { expect, it, onTestFinished } from 'vitest';
import type { Accounts } from '../../src/gateway/accounts';
import { createHttpHandler } from '../../src/gateway/http';

const PLAYER = { playerId: 'p1', username: 'one', expires: 0 };
const accounts: Accounts = {
  login: (username, password) =>
    Promise.resolve(username === 'one' && password === 'x' ? { player: PLAYER, token: 'the token' } : null),
  verify: () => Promise.resolve(null),
  renew: () => Promise.resolve(''),
};

/** A server whose clock is set by the test. */
async function serve() {
  const clock = { now: 100 };
  const server = createServer(
    createHttpHandler({
      accounts,
      isAllowedOrigin: (origin) => origin !== 'http://strange.example',
      shipOf: (playerId) => `ship of ${playerId}`,
      health: () => ({ tick: 7 }),
      now: () => clock.now,
    }),
  );
  await new Promise<void>((ready) => server.listen(0, '127.0.0.1', ready));
  onTestFinished(() => {
    server.closeAllConnections();
    server.close();
  });
  const { port } = server.address() as AddressInfo;
  const ask = (path: string, options: RequestInit = {}) => fetch(`http://127.0.0.1:${port}${path}`, options);
  const login = async (body: string) => {
    const response = await ask('/api/auth/login', { method: 'POST', body });
    return { status: response.status, ...((await response.json()) as Record<string, unknown>) };
  };
  return { clock, ask, login };
}

const GOOD = JSON.stringify({ username: 'one', password: 'x' });

it('answers a sign-in with the game’s fields', async () => {
  const { login } = await serve();
  expect(await login(GOOD)).toEqual({
    status: 200,
    player_id: 'p1',
    username: 'one',
    ship_id: 'ship of p1',
    token: 'the token',
    is_admin: false,
  });
});

it.each([
  ['a wrong password', JSON.stringify({ username: 'one', password: 'y' }), 401, 'E005'],
  ['no password', JSON.stringify({ username: 'one' }), 400, 'E001'],
  ['a name that is no text', JSON.stringify({ username: 1, password: 'x' }), 400, 'E001'],
  ['no JSON', '{', 400, 'E001'],
  ['null', 'null', 400, 'E001'],
  ['a text', '"one"', 400, 'E001'],
  ['more than 4 kB', JSON.stringify({ username: 'one', password: 'x', more: '.'.repeat(4096) }), 400, 'E001'],
])('refuses %s', async (_, body, status, code) => {
  const { login } = await serve();
  expect(await login(body)).toMatchObject({ status, error: { code } });
});

it('accepts a body of exactly 4 kB', async () => {
  const { login } = await serve();
  const padding = 4096 - JSON.stringify({ username: 'one', password: 'x', more: '' }).length;
  const body = JSON.stringify({ username: 'one', password: 'x', more: '.'.repeat(padding) });
  expect(await login(body)).toMatchObject({ status: 200 });
});

it('allows ten attempts at once, then one every two seconds', async () => {
  const { clock, login } = await serve();
  const statuses: unknown[] = [];
  for (let i = 0; i < 11; i++) statuses.push((await login(GOOD)).status);
  expect(statuses).toEqual([...Array<number>(10).fill(200), 429]);
  clock.now += 1.9;
  expect(await login(GOOD)).toMatchObject({ status: 429, error: { code: 'E008' } });
  clock.now += 0.2;
  expect((await login(GOOD)).status).toBe(200);
});

it('answers allowed origins only, and echoes the origin', async () => {
  const { ask } = await serve();
  const strange = await ask('/healthz', { headers: { origin: 'http://strange.example' } });
  expect(strange.status).toBe(403);
  expect(strange.headers.get('access-control-allow-origin')).toBeNull();
  const known = await ask('/healthz?now', { headers: { origin: 'http://known.example' } });
  expect(known.status).toBe(200);
  expect(known.headers.get('access-control-allow-origin')).toBe('http://known.example');
  expect(known.headers.get('access-control-allow-headers')).toBe('content-type');
  expect(known.headers.get('vary')).toBe('Origin');
  expect(known.headers.get('content-type')).toBe('application/json');
  expect(await known.json()).toEqual({ tick: 7 });
  const none = await ask('/healthz');
  expect(none.headers.get('access-control-allow-origin')).toBeNull();
});

it('answers OPTIONS on any path, and 404 on unknown paths', async () => {
  const { ask } = await serve();
  const options = await ask('/api/auth/login', { method: 'OPTIONS' });
  expect([options.status, await options.text()]).toEqual([204, '']);
  for (const [method, path] of [
    ['GET', '/api/auth/login'],
    ['POST', '/healthz'],
    ['GET', '/'],
  ] as const) {
    const response = await ask(path, { method });
    expect([response.status, await response.json()]).toEqual([
      404,
      { error: { code: 'E004', message: 'Not found' } },
    ]);
  }
});
