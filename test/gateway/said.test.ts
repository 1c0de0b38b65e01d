/** What clients say to the gateway, and what becomes of it. */
import { describe, expect, it, vi, onTestFinished } from 'vitest';
import { receive } from '../../src/gateway/clients/receive';
import { readBytes, readText } from '../../src/gateway/clients/speech';
import type { Place } from '../../src/gateway/place';
import { encodeClientMessage } from '../../src/wire';
import { EVENT, INPUT } from '../wire/messages';
import { type Connected, createPlace, shipOf, worldOf } from './fakePlace';

const say = (place: Place, { client }: Connected, message: object) =>
  receive(place, client, Buffer.from(JSON.stringify(message)), false);
const stream = (place: Place, { client }: Connected, message: Parameters<typeof encodeClientMessage>[0]) =>
  receive(place, client, Buffer.from(encodeClientMessage(message)), true);

/** A place whose world has a ship of p1, and its pilot. */
function piloted(protocol: 'json' | 'stream') {
  const made = createPlace();
  made.state.newest = worldOf([shipOf('p2'), shipOf('p1')], { tick: 50 });
  return { ...made, pilot: made.signedIn('p1', protocol) };
}

const refusalOf = (message: unknown) => (message as { error: { message: string } }).error.message;

/** Messages that the client has had too many. */
const excessOf = ({ client: { excess } }: ReturnType<typeof piloted>['pilot']) => excess.burst - excess.level;

describe('controls', () => {
  it('on /ws act on the own ship at the next tick, numbered by the gateway', () => {
    const { place, inputs, pilot } = piloted('json');
    say(place, pilot, { type: 'control', thrust_level: 0.5 });
    say(place, pilot, { type: 'control', controls: { thrust_level: 0.25 } });
    expect(inputs).toMatchObject([
      { shipId: 'ship of p1', playerId: 'p1', session: 'page', seq: 1, stamp: null },
      { seq: 2, controls: { thrustLevel: 0.25 } },
    ]);
    expect(inputs[0]!.controls.thrustLevel).toBe(0.5);
  });

  it('on /stream keep their own number and substep', () => {
    const { place, inputs, pilot } = piloted('stream');
    stream(place, pilot, { kind: 'inputs', inputs: [INPUT, { ...INPUT, seq: 2, substep: 4 }] });
    expect(inputs).toMatchObject([
      { shipId: 'ship of p1', seq: 1, stamp: { tick: 42, substep: 3 }, controls: INPUT.controls },
      { seq: 2, stamp: { tick: 42, substep: 4 } },
    ]);
    // Controls without a number would be told apart from nothing.
    say(place, pilot, { type: 'control', thrust_level: 0.5 });
    expect([inputs.length, excessOf(pilot), pilot.sent]).toEqual([2, 1, []]);
  });

  it('of a player without a ship go nowhere', () => {
    const { place, inputs, signedIn } = piloted('json');
    say(place, signedIn('p3', 'json'), { type: 'control', thrust_level: 0.5 });
    expect(inputs).toEqual([]);
  });
});

describe('a ping', () => {
  it('is answered on /ws, and on /stream with the tick and the seconds since it was due', () => {
    const { place, pilot } = piloted('json');
    say(place, pilot, { type: 'ping' });
    expect(pilot.sent).toEqual([{ type: 'pong' }]);
    const { place: other, state: world, pilot: streaming } = piloted('stream');
    world.now = 1000.5;
    stream(other, streaming, { kind: 'ping', id: 9 });
    // Redis's clock is 0.25 s ahead of the gateway's.
    expect(streaming.sent).toEqual([{ kind: 'pong', id: 9, tick: 50, sinceTick: 0.75 }]);
    world.now = 3e9;
    stream(other, streaming, { kind: 'ping', id: 10 });
    expect(streaming.sent[1]).toMatchObject({ sinceTick: 1e9 });
    world.newest = null;
    stream(other, streaming, { kind: 'ping', id: 11 });
    expect(streaming.sent).toHaveLength(2);
  });
});

describe('what cannot be used', () => {
  it('is refused by name on /ws, with the game’s code', () => {
    const { place, pilot } = piloted('json');
    say(place, pilot, { type: 'fly' });
    expect(pilot.sent).toEqual([
      { type: 'error', error: { code: 'E001', message: 'type: expected auth, control or ping' } },
    ]);
    receive(place, pilot.client, Buffer.from([1, 2]), true);
    expect(refusalOf(pilot.sent[1])).toBe('message: expected text');
    say(place, pilot, { type: 'auth', token: 'p9' });
    expect([pilot.sent.length, pilot.client.player!.playerId]).toEqual([2, 'p1']);
  });

  it('is counted, one a second forgiven, and over two hundred of them end the connection', () => {
    const { place, state, pilot } = piloted('json');
    // 204 of them take 3.4 s.
    for (let i = 0; i < 204; i++) {
      expect(pilot.closed).toEqual([]);
      state.now += 1 / 60;
      say(place, pilot, { type: 'fly' });
    }
    expect(pilot.sent).toHaveLength(203);
    expect(pilot.closed).toEqual([{ code: 4008, reason: 'Too many messages' }]);
  });

  it('includes messages beyond 120 at once and 60 a second, unanswered', () => {
    const { place, state, pilot } = piloted('json');
    const ping = (count: number) => {
      for (let i = 0; i < count; i++) say(place, pilot, { type: 'ping' });
      return [pilot.sent.length, excessOf(pilot)];
    };
    expect(ping(121)).toEqual([120, 1]);
    state.now += 0.5;
    // One of two is forgiven by half.
    expect(ping(31)).toEqual([150, 1.5]);
  });

  it('includes inputs beyond 1,024 at once and 120 a second', () => {
    const { place, state, inputs, pilot } = piloted('stream');
    const many = Array.from({ length: 128 }, () => INPUT);
    for (let i = 0; i < 9; i++) stream(place, pilot, { kind: 'inputs', inputs: many });
    expect([inputs.length, excessOf(pilot)]).toEqual([1024, 1]);
    state.now += 0.5;
    for (let i = 0; i < 61; i++) stream(place, pilot, { kind: 'inputs', inputs: [INPUT] });
    expect([inputs.length, excessOf(pilot)]).toEqual([1084, 1.5]);
  });
});

describe('a sign-in', () => {
  it('is announced to players on /ws, and told the world', async () => {
    const { place, state, connect, signedIn } = createPlace();
    state.newest = worldOf([shipOf('p1')], { tick: 50 });
    const other = signedIn('p2', 'json');
    const unheard = [signedIn('p3', 'stream'), connect('json'), signedIn('p4', 'json')];
    unheard[2]!.client.isBehind = true;
    const pilot = connect('json');
    let ended = false;
    pilot.client.timers.add(setTimeout(() => (ended = true), 20));
    say(place, pilot, { type: 'auth', token: 'p1', session: 'page-1' });
    await expect.poll(() => pilot.sent.length).toBe(2);
    expect(pilot.client).toMatchObject({ session: 'page-1', shipId: 'ship of p1', early: null });
    expect(pilot.client.timers.size).toBe(2);
    expect(other.sent).toEqual([{ type: 'player_joined', player_id: 'p1', username: 'user of p1' }]);
    expect(unheard.map(({ sent }) => sent.length)).toEqual([0, 0, 0]);
    await new Promise((later) => setTimeout(later, 40));
    expect(ended).toBe(false);
    for (const timer of pilot.client.timers) clearTimeout(timer);
  });

  it('on /stream is told what happened since the tick that the client knows', async () => {
    const { place, state, connect } = createPlace();
    state.newest = worldOf([shipOf('p1')], { tick: 50 });
    const asked: number[][] = [];
    const eventsSince = (tick: number, most: number) => {
      asked.push([tick, most]);
      return Promise.resolve([{ ...EVENT, shipId: 'ship of p1', tick: 45 }]);
    };
    Object.assign(place.feed, { eventsSince });
    const pilot = connect('stream');
    say(place, pilot, { type: 'auth', token: 'p1', since: 40, session: '?' });
    await expect.poll(() => pilot.sent.length).toBe(2);
    expect(pilot.sent[1]).toMatchObject({ kind: 'frame', events: [{ tick: 45 }] });
    expect([asked, pilot.client.session]).toEqual([[[40, 500]], 'nonce']);
    // The token's end; /stream renews none.
    expect(pilot.client.timers.size).toBe(1);
    const game = connect('json');
    say(place, game, { type: 'auth', token: 'p1', since: 40 });
    await expect.poll(() => game.sent.length).toBe(2);
    Object.assign(place.feed, { eventsSince: () => Promise.reject(new Error('gone')) });
    const late = connect('stream');
    say(place, late, { type: 'auth', token: 'p1', since: 40 });
    await expect.poll(() => late.sent.length).toBe(2);
    expect(asked).toHaveLength(1);
    for (const { client } of [pilot, game, late]) for (const timer of client.timers) clearTimeout(timer);
  });

  it('is renewed half-way through the token’s life on /ws, and ends with it', async () => {
    vi.useFakeTimers();
    onTestFinished(() => void vi.useRealTimers());
    const { place, connect } = createPlace();
    const pilot = connect('json');
    say(place, pilot, { type: 'auth', token: 'p1' });
    await vi.advanceTimersByTimeAsync(29_999);
    expect(pilot.sent).toEqual([]);
    await vi.advanceTimersByTimeAsync(1);
    expect(pilot.sent).toEqual([{ type: 'token_refresh', token: 'new token of p1' }]);
    await vi.advanceTimersByTimeAsync(29_999);
    expect(pilot.closed).toEqual([]);
    await vi.advanceTimersByTimeAsync(1);
    expect(pilot.closed).toEqual([{ code: 4001, reason: 'The token has expired' }]);
  });

  it('of a client that has gone meanwhile leaves nothing behind', async () => {
    const { place, connect } = createPlace();
    const pilot = connect('json');
    say(place, pilot, { type: 'auth', token: 'p1' });
    pilot.socket.readyState = 3;
    await expect.poll(() => pilot.client.early).toBeNull();
    expect([pilot.client.player, pilot.client.timers.size, pilot.sent]).toEqual([null, 0, []]);
  });

  it('keeps 32 messages at most until the token is verified', async () => {
    const { place, connect } = createPlace();
    const pilot = connect('json');
    say(place, pilot, { type: 'auth', token: 'p1' });
    for (let i = 0; i < 40; i++) say(place, pilot, { type: 'ping' });
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
  ])('signs in with a session and a tick only if they can be ones: %o', (fields, read) => {
    expect(readText(JSON.stringify({ type: 'auth', ...fields }))).toEqual({
      kind: 'auth',
      token: 't',
      ...read,
    });
  });

  it('is refused without a token, as a list, and as bytes that mean nothing', () => {
    expect(readText('{"type":"auth","token":""}')).toEqual({
      kind: 'refused',
      reason: 'auth.token: expected a string',
    });
    expect(readText('[]')).toEqual({ kind: 'refused', reason: 'message: expected an object' });
    expect(readText('null')).toEqual({ kind: 'refused', reason: 'message: expected an object' });
    expect(readBytes(Uint8Array.of(255))).toMatchObject({ kind: 'refused' });
  });
});
