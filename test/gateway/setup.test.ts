/** A gateway's options from its environment. */
import { describe, expect, it, vi } from 'vitest';
import type { WorldFrame } from '../../src/gateway/redis/feed';
import { runProcess } from '../../src/gateway/process';
import { loadSetup } from '../../src/gateway/setup';
import { BODY, FRAME } from '../wire/messages';

const TOUCHDOWN_SECRET = 'a secret that is long enough for a test';
const machine = { clock: () => 5, nonce: () => 'nonce', log: () => undefined };
const load = (given: Record<string, string>) => loadSetup({ TOUCHDOWN_SECRET, ...given }, machine);

function loaded(given: Record<string, string> = {}) {
  const setup = load(given);
  if (!setup.ok) throw new Error(setup.reason);
  return setup.value;
}

it('has its documented defaults', () => {
  expect(loaded()).toEqual({
    redis: 'redis://127.0.0.1:6379/0',
    host: '127.0.0.1',
    port: 8790,
    secret: TOUCHDOWN_SECRET,
    tokenLifetime: 43_200,
    accounts: [],
    origins: [],
    ...machine,
  });
});

it('reads all variables', () => {
  const account = { username: 'one', playerId: 'p1', password: 'x' };
  const given = {
    TOUCHDOWN_REDIS: 'redis://elsewhere:1/2',
    TOUCHDOWN_HOST: '0.0.0.0',
    TOUCHDOWN_PORT: '0',
    TOUCHDOWN_ACCOUNTS: JSON.stringify([account]),
    TOUCHDOWN_ORIGINS: 'https://a.example,,https://b.example',
  };
  expect(loaded(given)).toMatchObject({
    redis: 'redis://elsewhere:1/2',
    host: '0.0.0.0',
    port: 0,
    accounts: [account],
    origins: ['https://a.example', 'https://b.example'],
  });
  expect(loaded({ TOUCHDOWN_PORT: '65535' }).port).toBe(65535);
});

const HANGAR = 'TOUCHDOWN_HANGAR: expected {"body", "direction", "height", "ship_class", "delay"}';

it.each([
  [{ TOUCHDOWN_SECRET: 'x'.repeat(31) }, 'TOUCHDOWN_SECRET: expected at least 32 characters'],
  [{ TOUCHDOWN_PORT: '-1' }, 'TOUCHDOWN_PORT: expected 0 to 65535'],
  [{ TOUCHDOWN_PORT: '65536' }, 'TOUCHDOWN_PORT: expected 0 to 65535'],
  [{ TOUCHDOWN_PORT: '80.5' }, 'TOUCHDOWN_PORT: expected 0 to 65535'],
  [{ TOUCHDOWN_ACCOUNTS: '{}' }, 'TOUCHDOWN_ACCOUNTS: expected a JSON list'],
  [{ TOUCHDOWN_ACCOUNTS: '[' }, 'TOUCHDOWN_ACCOUNTS: expected a JSON list'],
  [
    { TOUCHDOWN_ACCOUNTS: '[{"username":"a","playerId":"b","password":""}]' },
    'TOUCHDOWN_ACCOUNTS[0].password: expected a string',
  ],
  [
    { TOUCHDOWN_ACCOUNTS: '[{"username":"a","playerId":1,"password":"x"}]' },
    'TOUCHDOWN_ACCOUNTS[0].playerId: expected a string',
  ],
  [{ TOUCHDOWN_HANGAR: '{' }, HANGAR],
  [{ TOUCHDOWN_HANGAR: '5' }, HANGAR],
  [{ TOUCHDOWN_HANGAR: 'null' }, HANGAR],
  [{ TOUCHDOWN_HANGAR: '{"body":"Luna"}' }, HANGAR],
])('refuses %o by name', (given: Record<string, string>, reason) => {
  expect(load(given)).toMatchObject({ ok: false, reason });
});

it('is refused by the process with the reason, and 2 as its exit code', async () => {
  const [log, error, exit] = [vi.fn(), vi.fn(), vi.fn()];
  await runProcess({ env: {}, exit } as never, { log, error }, machine);
  expect(error.mock.calls).toEqual([['gateway: TOUCHDOWN_SECRET: expected at least 32 characters']]);
  expect([exit.mock.calls, log.mock.calls]).toEqual([[[2]], []]);
});

it('accepts a secret of 32 characters', () => {
  expect(load({ TOUCHDOWN_SECRET: 'x'.repeat(32) }).ok).toBe(true);
});

describe('a hangar', () => {
  const accounts = ['one', 'two', 'three'].map((username) => ({
    username,
    playerId: `p-${username}`,
    password: 'x',
  }));
  const hangarOf = (given: object) =>
    loaded({ TOUCHDOWN_HANGAR: JSON.stringify(given), TOUCHDOWN_ACCOUNTS: JSON.stringify(accounts) }).hangar!;
  const worldOf = (names: string[]): WorldFrame => ({
    frame: { ...FRAME, bodies: names.map((name) => ({ ...BODY, name, radius: 600 })) },
    due: 0,
    lastInputs: new Map(),
    removed: [],
  });

  it('spawns each player’s ship 60 m east of the previous one', () => {
    const hangar = hangarOf({
      body: 'Mars',
      direction: [0.6, 0.48, 0.64],
      height: 7,
      ship_class: 'x',
      delay: 3,
    });
    expect([hangar.shipId('p'), hangar.delay]).toEqual(['ship-p', 3]);
    const world = worldOf(['Luna', 'Mars']);
    expect(hangar.spawn('p-one', world)).toEqual({
      ship_id: 'ship-p-one',
      player_id: 'p-one',
      name: 'one',
      ship_class: 'x',
      body: 'Mars',
      direction: [0.6, 0.48, 0.64],
      height: 7,
    });
    const { direction } = hangar.spawn('p-three', world) as { direction: [number, number, number] };
    // Two times 60 m of a radius of 600 m: 0.2 rad along (z, 0, −x) of the equator.
    const around = Math.hypot(0.6, 0.64);
    expect(direction[0]).toBeCloseTo(0.6 + (0.64 / around) * 0.2, 12);
    expect(direction[1]).toBe(0.48);
    expect(direction[2]).toBeCloseTo(0.64 - (0.6 / around) * 0.2, 12);
  });

  it('has defaults, gives an unknown player the first slot, and spawns nothing without a body', () => {
    const hangar = hangarOf({ direction: [0, 1, 0] });
    expect(hangar.delay).toBe(5);
    expect(hangar.spawn('stranger', worldOf(['Luna', 'Mars']))).toEqual({
      ship_id: 'ship-stranger',
      player_id: 'stranger',
      name: 'stranger',
      ship_class: 'planetary_lander',
      body: 'Luna',
      direction: [0, 1, 0],
      height: 100,
    });
    // At the pole no direction is east.
    expect(hangar.spawn('p-two', worldOf(['Luna']))).toMatchObject({ direction: [0, 1, 0] });
    expect(hangar.spawn('p-one', worldOf([]))).toBeNull();
  });
});
