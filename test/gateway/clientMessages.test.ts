/** Messages from clients, and how the gateway handles them. */
import { describe, expect, it, vi, onTestFinished } from 'vitest';
import { receive } from '../../src/gateway/clients/receive';
import { readBytes, readText } from '../../src/gateway/clients/messages';
import type { GatewayState } from '../../src/gateway/state';
import { encodeClientMessage } from '../../src/wire';
import { EVENT, INPUT } from '../wire/messages';
import { type Connected, createFakeGateway, shipOf, worldOf } from './fakeGateway';

const sendJson = (gateway: GatewayState, { client }: Connected, message: object) =>
  receive(gateway, client, Buffer.from(JSON.stringify(message)), false);
const sendBytes = (
  gateway: GatewayState,
  { client }: Connected,
  message: Parameters<typeof encodeClientMessage>[0],
) => receive(gateway, client, Buffer.from(encodeClientMessage(message)), true);

/** A gateway whose world has a ship of p1, and its pilot's connection. */
function piloted(protocol: 'json' | 'stream') {
  const made = createFakeGateway();
  made.state.newest = worldOf([shipOf('p2'), shipOf('p1')], { tick: 50 });
  return { ...made, pilot: made.signedIn('p1', protocol) };
}

const refusalOf = (message: unknown) => (message as { error: { message: string } }).error.message;

/** Number of excess and refused messages counted against the client. */
const excessOf = ({ client: { excess } }: ReturnType<typeof piloted>['pilot']) => excess.burst - excess.level;

describe('controls', () => {
  it('on /ws apply to the own ship at the next tick, with the gateway’s sequence numbers', () => {
    const { gateway, inputs, pilot } = piloted('json');
    sendJson(gateway, pilot, { type: 'control', thrust_level: 0.5 });
    sendJson(gateway, pilot, { type: 'control', controls: { thrust_level: 0.25 } });
    expect(inputs).toMatchObject([
      { shipId: 'ship of p1', playerId: 'p1', session: 'page', seq: 1, stamp: null },
      { seq: 2, controls: { thrustLevel: 0.25 } },
    ]);
    expect(inputs[0]!.controls.thrustLevel).toBe(0.5);
  });

  it('on /stream keep their own sequence number, tick and substep', () => {
    const { gateway, inputs, pilot } = piloted('stream');
    sendBytes(gateway, pilot, { kind: 'inputs', inputs: [INPUT, { ...INPUT, seq: 2, substep: 4 }] });
    expect(inputs).toMatchObject([
      { shipId: 'ship of p1', seq: 1, stamp: { tick: 42, substep: 3 }, controls: INPUT.controls },
      { seq: 2, stamp: { tick: 42, substep: 4 } },
    ]);
    // Controls without a sequence number are refused here.
    sendJson(gateway, pilot, { type: 'control', thrust_level: 0.5 });
    expect([inputs.length, excessOf(pilot), pilot.sent]).toEqual([2, 1, []]);
  });

  it('of a player without a ship are dropped', () => {
    const { gateway, inputs, signedIn } = piloted('json');
    sendJson(gateway, signedIn('p3', 'json'), { type: 'control', thrust_level: 0.5 });
    expect(inputs).toEqual([]);
  });
});

describe('a ping', () => {
  it('is answered; on /stream with the newest tick and the seconds since it was due', () => {
    const { gateway, pilot } = piloted('json');
    sendJson(gateway, pilot, { type: 'ping' });
    expect(pilot.sent).toEqual([{ type: 'pong' }]);
    const { gateway: other, state: world, pilot: streaming } = piloted('stream');
    world.now = 1000.5;
    sendBytes(other, streaming, { kind: 'ping', id: 9 });
    // Redis's clock is 0.25 s ahead of the gateway's.
    expect(streaming.sent).toEqual([{ kind: 'pong', id: 9, tick: 50, sinceTick: 0.75 }]);
    world.now = 3e9;
    sendBytes(other, streaming, { kind: 'ping', id: 10 });
    expect(streaming.sent[1]).toMatchObject({ sinceTick: 1e9 });
    world.newest = null;
    sendBytes(other, streaming, { kind: 'ping', id: 11 });
    expect(streaming.sent).toHaveLength(2);
  });
});

describe('an invalid or excess message', () => {
  it('is refused on /ws with the field’s name and the game’s error code', () => {
    const { gateway, pilot } = piloted('json');
    sendJson(gateway, pilot, { type: 'fly' });
    expect(pilot.sent).toEqual([
      { type: 'error', error: { code: 'E001', message: 'type: expected auth, control or ping' } },
    ]);
    receive(gateway, pilot.client, Buffer.from([1, 2]), true);
    expect(refusalOf(pilot.sent[1])).toBe('message: expected text');
    sendJson(gateway, pilot, { type: 'auth', token: 'p9' });
    expect([pilot.sent.length, pilot.client.player!.playerId]).toEqual([2, 'p1']);
  });

  it('is counted; one per second is forgiven, and more than 200 close the connection', () => {
    const { gateway, state, pilot } = piloted('json');
    // 204 of them take 3.4 s.
    for (let i = 0; i < 204; i++) {
      expect(pilot.closed).toEqual([]);
      state.now += 1 / 60;
      sendJson(gateway, pilot, { type: 'fly' });
    }
    expect(pilot.sent).toHaveLength(203);
    expect(pilot.closed).toEqual([{ code: 4008, reason: 'Too many messages' }]);
  });

  it('is a message beyond a burst of 120 and 60 per second, which gets no answer', () => {
    const { gateway, state, pilot } = piloted('json');
    const ping = (count: number) => {
      for (let i = 0; i < count; i++) sendJson(gateway, pilot, { type: 'ping' });
      return [pilot.sent.length, excessOf(pilot)];
    };
    expect(ping(121)).toEqual([120, 1]);
    state.now += 0.5;
    // One of two is forgiven by half.
    expect(ping(31)).toEqual([150, 1.5]);
  });

  it('is an input beyond a burst of 1,024 and 120 per second', () => {
    const { gateway, state, inputs, pilot } = piloted('stream');
    const many = Array.from({ length: 128 }, () => INPUT);
    for (let i = 0; i < 9; i++) sendBytes(gateway, pilot, { kind: 'inputs', inputs: many });
    expect([inputs.length, excessOf(pilot)]).toEqual([1024, 1]);
    state.now += 0.5;
    for (let i = 0; i < 61; i++) sendBytes(gateway, pilot, { kind: 'inputs', inputs: [INPUT] });
    expect([inputs.length, excessOf(pilot)]).toEqual([1084, 1.5]);
  });
});

describe('a sign-in', () => {
  it('is announced to players on /ws, and answered with the world', async () => {
    const { gateway, state, connect, signedIn } = createFakeGateway();
    state.newest = worldOf([shipOf('p1')], { tick: 50 });
    const other = signedIn('p2', 'json');
    const unheard = [signedIn('p3', 'stream'), connect('json'), signedIn('p4', 'json')];
    unheard[2]!.client.isBehind = true;
    const pilot = connect('json');
    let ended = false;
    pilot.client.timers.add(setTimeout(() => (ended = true), 20));
    sendJson(gateway, pilot, { type: 'auth', token: 'p1', session: 'page-1' });
    await expect.poll(() => pilot.sent.length).toBe(2);
    expect(pilot.client).toMatchObject({ session: 'page-1', shipId: 'ship of p1', queued: null });
    expect(pilot.client.timers.size).toBe(2);
    expect(other.sent).toEqual([{ type: 'player_joined', player_id: 'p1', username: 'user of p1' }]);
    expect(unheard.map(({ sent }) => sent.length)).toEqual([0, 0, 0]);
    await new Promise((later) => setTimeout(later, 40));
    expect(ended).toBe(false);
    for (const timer of pilot.client.timers) clearTimeout(timer);
  });

  it('on /stream is answered with the events since the client’s last tick', async () => {
    const { gateway, state, connect } = createFakeGateway();
    state.newest = worldOf([shipOf('p1')], { tick: 50 });
    const asked: number[][] = [];
    const eventsSince = (tick: number, most: number) => {
      asked.push([tick, most]);
      return Promise.resolve([{ ...EVENT, shipId: 'ship of p1', tick: 45 }]);
    };
    Object.assign(gateway.feed, { eventsSince });
    const pilot = connect('stream');
    sendJson(gateway, pilot, { type: 'auth', token: 'p1', since: 40, session: '?' });
    await expect.poll(() => pilot.sent.length).toBe(2);
    expect(pilot.sent[1]).toMatchObject({ kind: 'frame', events: [{ tick: 45 }] });
    expect([asked, pilot.client.session]).toEqual([[[40, 500]], 'nonce']);
    // Only the expiry timer: /stream does not renew tokens.
    expect(pilot.client.timers.size).toBe(1);
    const game = connect('json');
    sendJson(gateway, game, { type: 'auth', token: 'p1', since: 40 });
    await expect.poll(() => game.sent.length).toBe(2);
    Object.assign(gateway.feed, { eventsSince: () => Promise.reject(new Error('gone')) });
    const late = connect('stream');
    sendJson(gateway, late, { type: 'auth', token: 'p1', since: 40 });
    await expect.poll(() => late.sent.length).toBe(2);
    expect(asked).toHaveLength(1);
    for (const { client } of [pilot, game, late]) for (const timer of client.timers) clearTimeout(timer);
  });

  it('is renewed on /ws halfway through the token’s life, and ends when the token expires', async () => {
    vi.useFakeTimers();
    onTestFinished(() => void vi.useRealTimers());
    const { gateway, connect } = createFakeGateway();
    const pilot = connect('json');
    sendJson(gateway, pilot, { type: 'auth', token: 'p1' });
    await vi.advanceTimersByTimeAsync(29_999);
    expect(pilot.sent).toEqual([]);
    await vi.advanceTimersByTimeAsync(1);
    expect(pilot.sent).toEqual([{ type: 'token_refresh', token: 'new token of p1' }]);
    await vi.advanceTimersByTimeAsync(29_999);
    expect(pilot.closed).toEqual([]);
    await vi.advanceTimersByTimeAsync(1);
    expect(pilot.closed).toEqual([{ code: 4001, reason: 'The token has expired' }]);
  });

  it('of a client that has disconnected meanwhile leaves no state', async () => {
    const { gateway, connect } = createFakeGateway();
    const pilot = connect('json');
    sendJson(gateway, pilot, { type: 'auth', token: 'p1' });
    pilot.socket.readyState = 3;
    await expect.poll(() => pilot.client.queued).toBeNull();
    expect([pilot.client.player, pilot.client.timers.size, pilot.sent]).toEqual([null, 0, []]);
  });

  it('queues at most 32 messages until the token is verified', async () => {
    const { gateway, connect } = createFakeGateway();
    const pilot = connect('json');
    sendJson(gateway, pilot, { type: 'auth', token: 'p1' });
    for (let i = 0; i < 40; i++) sendJson(gateway, pilot, { type: 'ping' });
    await expect.poll(() => pilot.sent.length).toBe(32);
    for (const timer of pilot.client.timers) clearTimeout(timer);
  });
});

describe('a message', () => {
  it.each([
    [{ token: 't' }, { session: '', since: null }],
    [
      { token: 't', session: 'a-b_9', since: 0 },
      { session: 'a-b_9', since: 0 },
    ],
    [
      { token: 't', session: 'x'.repeat(49), since: -1 },
      { session: '', since: null },
    ],
    [
      { token: 't', session: 5, since: 1.5 },
      { session: '', since: null },
    ],
  ])('signs in and ignores an invalid session or tick: %o', (fields, read) => {
    expect(readText(JSON.stringify({ type: 'auth', ...fields }))).toEqual({
      kind: 'auth',
      token: 't',
      ...read,
    });
  });

  it('is refused if it is a sign-in without a token, a list, null, or not protobuf', () => {
    expect(readText('{"type":"auth","token":""}')).toEqual({
      kind: 'refused',
      reason: 'auth.token: expected a string',
    });
    expect(readText('[]')).toEqual({ kind: 'refused', reason: 'message: expected an object' });
    expect(readText('null')).toEqual({ kind: 'refused', reason: 'message: expected an object' });
    expect(readBytes(Uint8Array.of(255))).toMatchObject({ kind: 'refused' });
  });
});
