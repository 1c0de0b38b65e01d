import { describe, expect, it, onTestFinished, vi } from 'vitest';
import { EVENT } from '../wire/messages';
import { createFakeGateway, sendJson, shipOf, worldOf } from './fakeGateway';

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
