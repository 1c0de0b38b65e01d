import { SignJWT, UnsecuredJWT } from 'jose';
import { expect, it } from 'vitest';
import { createAccounts } from '../../src/gateway/accounts';
import { isFull } from '../../src/gateway/clients/client';
import { reconnectDelay } from '../../src/gateway/redis/connection';
import { shareFrame } from '../../src/gateway/redis/sharedFrame';
import { readWorldFrame } from '../../src/gateway/redis/feed';
import { shipsInSight } from '../../src/gateway/clients/interest';
import { consume, createBucket, MAX_STATE } from '../../src/gateway/clients/limits';
import { readText } from '../../src/gateway/clients/messages';
import { decodeFrameJson, decodeServerMessage, encodeFrameJson, type ShipState } from '../../src/wire';
import { FRAME, SHIP } from '../wire/messages';

const SECRET = 'a secret that is long enough for a test';

it('joins shared parts into the same bytes as a frame encoded whole', () => {
  const shared = shareFrame(FRAME);
  const decoded = decodeServerMessage(shared.bytes([1, 0], FRAME.events, FRAME.lastInput));
  expect(decoded).toEqual({ ok: true, value: { ...FRAME, ships: [FRAME.ships[1], FRAME.ships[0]] } });
  const some = decodeServerMessage(shared.bytes([1], [], null));
  expect(some).toEqual({
    ok: true,
    value: { ...FRAME, ships: [FRAME.ships[1]], events: [], lastInput: null },
  });
});

it.each([
  ['exactly 64 KB has', 0, ['ship-1', 'ship-2']],
  ['one byte more lacks', 1, ['ship-1']],
])('a state message that would be %s its last ship', (_, more, expected) => {
  const [first, last] = FRAME.ships as [ShipState, ShipState];
  const textOf = (name: string) => shareFrame({ ...FRAME, ships: [first, { ...last, name }] }).json([0, 1]);
  const text = textOf('x'.repeat(MAX_STATE - Buffer.byteLength(textOf('')) + more));
  const { ships } = JSON.parse(text) as { ships: { ship_id: string }[] };
  expect(ships.map((ship) => ship.ship_id)).toEqual(expected);
  if (more === 0) expect(Buffer.byteLength(text)).toBe(MAX_STATE);
});

it('encodes the game’s state message in at most 64 KB', () => {
  const ships = Array.from({ length: 300 }, (_, i) => ({ ...SHIP, shipId: `ship-${i}` }));
  const text = shareFrame({ ...FRAME, ships }).json(ships.map((_, i) => i));
  expect(Buffer.byteLength(text)).toBeLessThanOrEqual(MAX_STATE);
  expect(text).not.toMatch(/relative_position|reference_body|contact_impact_speed|last_input/);
  const decoded = decodeFrameJson(JSON.parse(text));
  if (!decoded.ok) throw new Error(decoded.reason);
  expect(decoded.value.refusals).toEqual([]);
  expect(decoded.value.ships.length).toBeGreaterThan(30);
  const { kind, tick, tickRate, timeScale, gameTime, paused, bodies } = FRAME;
  expect(decoded.value).toMatchObject({ kind, tick, tickRate, timeScale, gameTime, paused, bodies });
  expect(decoded.value.ships[0]).toMatchObject({
    shipId: 'ship-0',
    position: SHIP.position,
    relativePosition: null,
  });
});

it('sends the player’s ship first, then the nearest within the radius', () => {
  const at = (x: number, shipId: string) => ({ ...SHIP, shipId, position: [x, 0, 0] as const });
  const ships = [at(5000, 'far'), at(0, 'own'), at(10, 'near'), at(300, 'next')];
  expect(shipsInSight(ships, 1, { radius: 1000, maxShips: 10 })).toEqual([1, 2, 3]);
  expect(shipsInSight(ships, 1, { radius: 1000, maxShips: 2 })).toEqual([1, 2]);
  expect(shipsInSight(ships, 1, { radius: 5000, maxShips: 10 })).toEqual([1, 2, 3, 0]);
  expect(shipsInSight(ships, -1, { radius: 1, maxShips: 3 })).toEqual([0, 1, 2]);
  expect(shipsInSight(ships, 1, { radius: 300, maxShips: 10 })).toEqual([1, 2, 3]);
  expect(shipsInSight(ships, 1, { radius: 299, maxShips: 10 })).toEqual([1, 2]);
  // 2, 3, 6 → 7 m; from (−5, 4, 9) in any order of the axes.
  const around = [
    { ...SHIP, position: [-5, 4, 9] as const },
    ...[[2, 3, 6] as const, [6, 2, -3] as const, [-3, -6, 2] as const].map((away) => ({
      ...SHIP,
      position: [away[0] - 5, away[1] + 4, away[2] + 9] as const,
    })),
  ];
  expect(shipsInSight(around, 0, { radius: 7, maxShips: 10 })).toEqual([0, 1, 2, 3]);
  expect(shipsInSight(around, 0, { radius: 6.99, maxShips: 10 })).toEqual([0]);
});

it('has room for 64 connections of one address, and for 256 of all that have not signed in', () => {
  const player = { playerId: 'p', username: 'p', expires: 0 };
  const signedIn = (count: number, address: string) =>
    Array.from({ length: count }, () => ({ address, player }));
  const strangers = (count: number) =>
    Array.from({ length: count }, (_, i) => ({ address: `stranger ${i}`, player: null }));
  expect(isFull([...signedIn(63, 'here'), ...signedIn(500, 'there')], 'here')).toBe(false);
  expect(isFull(signedIn(64, 'here'), 'here')).toBe(true);
  expect(isFull([...strangers(255), ...signedIn(500, 'there')], 'here')).toBe(false);
  expect(isFull(strangers(256), 'here')).toBe(true);
});

it('waits longer before each attempt to reach Redis, a second at most', () => {
  expect([0, 1, 2, 3, 4, 5, 50].map(reconnectDelay)).toEqual([50, 100, 200, 400, 800, 1000, 1000]);
});

it('allows a burst, then a steady rate', () => {
  const bucket = createBucket({ perSecond: 2, burst: 3 }, 0);
  expect([1, 1, 1, 1].map((count) => consume(bucket, count, 0))).toEqual([true, true, true, false]);
  expect(consume(bucket, 1, 0.5)).toBe(true);
  expect(consume(bucket, 1, 0.5)).toBe(false);
  expect(consume(bucket, 4, 1000)).toBe(false);
  expect(consume(bucket, 3, 1000)).toBe(true);
  // A clock that is set back takes no tokens away.
  expect(consume(bucket, 0, 999)).toBe(true);
  expect(consume(bucket, 1, 999.5)).toBe(true);
});

it('checks name and password, and accepts its own tokens until they expire', async () => {
  let now = 1_800_000_000;
  const made = { secret: SECRET, lifetime: 3600, now: () => now };
  const account = { username: 'one', playerId: 'p1', password: 'x' };
  const accounts = await createAccounts([account], made);
  expect(await accounts.login('one', 'y')).toBeNull();
  expect(await accounts.login('nobody', 'x')).toBeNull();
  now = Date.now() / 1000;
  const found = await accounts.login('one', 'x');
  expect(await accounts.verify(found!.token)).toMatchObject({ playerId: 'p1', username: 'one' });
  expect(await accounts.verify(`${found!.token}x`)).toBeNull();
  const other = await createAccounts([account], { ...made, secret: `${SECRET}!` });
  expect(await other.verify(found!.token)).toBeNull();
  now = Date.now() / 1000 - 7200;
  const old = await accounts.login('one', 'x');
  expect(await accounts.verify(old!.token)).toBeNull();
  await expect(createAccounts([], { ...made, secret: 'x'.repeat(32) })).resolves.toBeDefined();
  await expect(createAccounts([], { ...made, secret: 'x'.repeat(31) })).rejects.toThrow(
    'secret: expected at least 32',
  );
});

const NOW = Math.floor(Date.now() / 1000);
const CLAIMS = { iss: 'touchdown', sub: 'p1', username: 'one', exp: NOW + 3600 };

function signed(claims: object, alg = 'HS256', secret = SECRET): Promise<string> {
  return new SignJWT({ ...claims }).setProtectedHeader({ alg }).sign(new TextEncoder().encode(secret));
}

it.each([
  ['without a signature', () => new UnsecuredJWT({ ...CLAIMS }).encode()],
  ['signed with another algorithm', () => signed(CLAIMS, 'HS512')],
  ['signed with another secret', () => signed(CLAIMS, 'HS256', `${SECRET}!`)],
  ['that has expired', () => signed({ ...CLAIMS, exp: NOW - 1 })],
  ['that is not valid yet', () => signed({ ...CLAIMS, nbf: NOW + 1800 })],
  ['that never expires', () => signed({ ...CLAIMS, exp: undefined })],
  ['of another issuer', () => signed({ ...CLAIMS, iss: 'elsewhere' })],
  ['for another audience', () => signed({ ...CLAIMS, aud: 'mail' })],
  ['for several audiences', () => signed({ ...CLAIMS, aud: ['mail', 'log'] })],
  ['for no player', () => signed({ ...CLAIMS, sub: '' })],
  ['with a subject that is no text', () => signed({ ...CLAIMS, sub: 5 })],
  [
    'of 60 kB, signed with another secret',
    () => signed({ ...CLAIMS, more: 'x'.repeat(60_000) }, 'HS256', 'y'),
  ],
  ['of 60 kB of dots', () => '.'.repeat(60_000)],
  ['of no characters', () => ''],
])('accepts no token %s', async (_, make) => {
  const accounts = await createAccounts([], { secret: SECRET, lifetime: 60, now: () => NOW });
  expect(await accounts.verify(await signed(CLAIMS))).toEqual({
    playerId: 'p1',
    username: 'one',
    expires: NOW + 3600,
  });
  expect(await accounts.verify(await make())).toBeNull();
});

it('reads the valid parts of the service’s frame', () => {
  const told: string[] = [];
  const sent = {
    ...encodeFrameJson({ ...FRAME, lastInput: null }),
    due: 12.5,
    events: [
      { event: 'ship.contact', ship_id: 'gone', body: 'Luna', tick: 41 },
      { event: 'ship.destroyed', ship_id: 'other', body: 'Phobos', tick: 41 },
      { event: 'ship.destroyed', ship_id: 'gone', body: 'Deimos', tick: 41 },
    ],
    removed: [{ ship_id: 'gone', player_id: 'p', name: 'n', reason: 'collision' }],
  } as Record<string, unknown>;
  sent['ships'] = [
    ...(sent['ships'] as object[]).map((ship) => ({
      ...ship,
      last_input: { session: 's', seq: 3, tick: 41, substep: 2, margin: 0.1 },
    })),
    { ship_id: 'broken' },
    ...[{ session: 5 }, { margin: 'much' }].map((wrong, i) => ({
      ship_id: `unread ${i}`,
      last_input: { session: 's', seq: 3, tick: 41, substep: 2, margin: 0.1, ...wrong },
    })),
    { ship_id: 'unread', last_input: 5 },
  ];
  const world = readWorldFrame(JSON.stringify(sent), (reason) => told.push(reason));
  const { tick, tickRate, timeScale, gameTime, paused, bodies } = FRAME;
  expect(world).toMatchObject({
    due: 12.5,
    frame: { tick, tickRate, timeScale, gameTime, paused, bodies },
    removed: [{ shipId: 'gone', playerId: 'p', name: 'n', reason: 'collision', body: 'Deimos' }],
  });
  expect(world!.frame.ships).toHaveLength(2);
  expect(world!.lastInputs.get('ship-1')).toEqual({
    session: 's',
    seq: 3,
    tick: 41,
    substep: 2,
    margin: 0.1,
  });
  expect([...world!.lastInputs.keys()]).toEqual(['ship-1', 'ship-2']);
  expect(told).toEqual([2, 3, 4, 5].map((i) => `frame.ships[${i}].position: missing`));
  expect(world!.frame.events.map(({ shipId }) => shipId)).toEqual(['gone', 'other', 'gone']);
  const bare = readWorldFrame('{"tick":1,"ships":[],"removed":[{}]}', (reason) => told.push(reason));
  expect(bare).toEqual({
    frame: {
      ...{ kind: 'frame', tick: 1, tickRate: 1, timeScale: 1, paused: false },
      ...{ bodies: [], ships: [], events: [], lastInput: null },
    },
    due: 0,
    lastInputs: new Map(),
    removed: [{ shipId: '', playerId: '', name: '', reason: '', body: '' }],
  });
  expect(readWorldFrame('{"tick":1,"ships":[null],"removed":[null]}', () => undefined)).toEqual({
    ...bare,
    removed: [],
  });
  expect(readWorldFrame('{', (reason) => told.push(reason))).toBeNull();
});

it('a world frame without its null ships, inputs and removals is valid', () => {
  const sent = { tick: 1, ships: [null, { ship_id: 'a', last_input: null }], removed: [null, 5] };
  const world = readWorldFrame(JSON.stringify(sent), () => undefined);
  expect(world).toMatchObject({ frame: { tick: 1 }, lastInputs: new Map(), removed: [] });
});

it.each([
  ['{', 'message: not JSON'],
  ['5', 'message: expected an object'],
  ['{"type":"auth"}', 'auth.token: expected a string'],
  ['{"type":"control","thrust_level":"much"}', 'control.thrust_level: expected a finite number, got "much"'],
  ['{"type":"service"}', 'type: expected auth, control or ping'],
])('refuses an invalid %s by name', (text, reason) => {
  expect(readText(text)).toEqual({ kind: 'refused', reason });
});
