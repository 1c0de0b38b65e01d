/** Messages from the gateway to its clients. */
import { describe, expect, it } from 'vitest';
import { disconnect } from '../../src/gateway/clients/client';
import { broadcastFrame, resendToSlow, sendNewest } from '../../src/gateway/clients/send';
import type { Hangar } from '../../src/gateway/options';
import { EVENT } from '../wire/messages';
import { createFakeGateway, shipOf, worldOf } from './fakeGateway';

const idsOf = (message: unknown) => (message as { ships: { shipId: string }[] }).ships.map((s) => s.shipId);

describe('a state', () => {
  it('follows the hello, which has the player’s ship and the current world', () => {
    const { gateway, state, signedIn } = createFakeGateway();
    const { client, sent } = signedIn('p1', 'stream');
    state.newest = worldOf([shipOf('p2'), shipOf('p1')], { tick: 50, tickRate: 20, timeScale: 2 });
    broadcastFrame(gateway, state.newest);
    expect(sent.map((message) => message['kind' as never])).toEqual(['hello', 'frame']);
    expect(sent[0]).toMatchObject({
      playerId: 'p1',
      shipId: 'ship of p1',
      tick: 50,
      tickRate: 20,
      timeScale: 2,
      inputGranularity: 'substep',
    });
    expect(idsOf(sent[1])).toEqual(['ship of p1', 'ship of p2']);
    expect(client.shipId).toBe('ship of p1');
    // A hello is sent again only for another ship.
    broadcastFrame(gateway, state.newest);
    expect(sent).toHaveLength(3);
    state.newest = worldOf([shipOf('p1', 'next')], { tick: 51 });
    broadcastFrame(gateway, state.newest);
    expect(sent.slice(3)).toMatchObject([{ kind: 'hello', shipId: 'next' }, { kind: 'frame' }]);
  });

  it('is the game’s state message on /ws, after a welcome', () => {
    const { gateway, state, signedIn } = createFakeGateway();
    const { sent } = signedIn('p1', 'json');
    state.newest = worldOf([shipOf('p1')]);
    sendNewest(gateway, gateway.clients.values().next().value!);
    expect(sent).toMatchObject([
      { type: 'welcome', username: 'user of p1', input_granularity: 'tick' },
      { type: 'state' },
    ]);
  });

  it('is not sent before sign-in, nor before there is a world', () => {
    const { gateway, state, connect, signedIn } = createFakeGateway();
    const stranger = connect('json');
    const pilot = signedIn('p1', 'json');
    sendNewest(gateway, pilot.client);
    resendToSlow(gateway);
    expect(pilot.sent).toEqual([]);
    state.newest = worldOf([shipOf('p1')]);
    broadcastFrame(gateway, state.newest);
    expect(stranger.sent).toEqual([]);
    expect(pilot.sent).toHaveLength(2);
    const { gateway: empty, state: queued, signedIn: join } = createFakeGateway();
    empty.world = null;
    const waiting = join('p1', 'stream');
    queued.newest = worldOf([shipOf('p1')]);
    broadcastFrame(empty, queued.newest);
    expect(waiting.sent).toEqual([]);
  });

  it('acknowledges only applied inputs of the client’s own session', () => {
    const { gateway, state, signedIn } = createFakeGateway();
    const { client, sent } = signedIn('p1', 'stream');
    const last = { seq: 7, tick: 42, substep: 3, margin: 0.5 };
    const acknowledged = (session: string, tick = 42) => {
      const lastInputs = new Map([['ship of p1', { ...last, tick, session }]]);
      state.newest = { ...worldOf([shipOf('p1')], { tick: 42 }), lastInputs };
      sendNewest(gateway, client);
      return (sent.at(-1) as unknown as { lastInput: unknown }).lastInput;
    };
    expect(acknowledged('page')).toEqual(last);
    expect(acknowledged('another page')).toBeNull();
    expect(acknowledged('page', 43)).toBeNull();
  });
});

describe('an event', () => {
  const near = { ...shipOf('p2'), position: [0, 0, 1000] as const };
  const own = { ...shipOf('p1'), position: [0, 0, 0] as const };
  const far = { ...shipOf('p3'), position: [0, 0, 200_001] as const };
  const of = (shipId: string, tick = 42) => ({ ...EVENT, shipId, tick });

  it('is sent once, not before its tick, for ships in range and ships that no longer exist', () => {
    const { gateway, state, signedIn } = createFakeGateway();
    const { sent } = signedIn('p1', 'stream');
    const events = [of('ship of p2'), of('ship of p3'), of('gone'), of('ship of p1', 43)];
    state.newest = worldOf([own, near, far], { tick: 42, events });
    broadcastFrame(gateway, state.newest);
    const idsOfEvents = (message: unknown) =>
      (message as { events: { shipId: string }[] }).events.map((e) => e.shipId);
    expect(idsOfEvents(sent[1])).toEqual(['ship of p2', 'gone']);
    resendToSlow(gateway);
    state.newest = worldOf([own, near, far], { tick: 43 });
    broadcastFrame(gateway, state.newest);
    expect(idsOfEvents(sent.at(-1))).toEqual([]);
  });

  it('on /ws: the owner of a crashed ship gets ship.destroyed, everyone gets ship.removed', () => {
    const { gateway, state, signedIn } = createFakeGateway();
    const victim = signedIn('p1', 'json');
    const witness = signedIn('p2', 'json');
    const gone = { shipId: 's1', playerId: 'p1', name: 'Kestrel', reason: 'collision', body: 'Luna' };
    const scrapped = { ...gone, shipId: 's0', reason: 'removed' };
    state.newest = { ...worldOf([shipOf('p2')]), removed: [gone, scrapped] };
    broadcastFrame(gateway, state.newest);
    const removed = ['s1', 's0'].map((ship_id) => ({ type: 'ship.removed', ship_id }));
    expect(victim.sent.slice(1, -1)).toEqual([
      { type: 'ship.destroyed', ship_id: 's1', ship_name: 'Kestrel', body: 'Luna', reason: 'collision' },
      ...removed,
    ]);
    expect(witness.sent.slice(1, -1)).toEqual(removed);
  });
});

describe('a client with a full socket', () => {
  const FULL = 256 * 1024 + 1;

  it('gets the newest state and the events it missed once it has room', () => {
    const { gateway, state, signedIn } = createFakeGateway();
    const { client, sent, socket } = signedIn('p1', 'stream');
    const send = (tick: number) => {
      state.newest = worldOf([shipOf('p1')], { tick, events: [{ ...EVENT, shipId: 'ship of p1', tick }] });
      broadcastFrame(gateway, state.newest);
    };
    send(1);
    socket.bufferedAmount = FULL;
    send(2);
    send(3);
    resendToSlow(gateway);
    expect([sent.length, client.isBehind]).toEqual([2, true]);
    socket.bufferedAmount = FULL - 1;
    resendToSlow(gateway);
    expect(sent.at(-1)).toMatchObject({ tick: 3, events: [{ tick: 2 }, { tick: 3 }] });
    expect(client.isBehind).toBe(false);
    resendToSlow(gateway);
    expect(sent).toHaveLength(3);
  });

  it('is disconnected after more than 10 s, or with more than 1,000 queued events', () => {
    const { gateway, state, signedIn } = createFakeGateway();
    const { closed, socket } = signedIn('p1', 'stream');
    state.newest = worldOf([shipOf('p1')]);
    broadcastFrame(gateway, state.newest);
    socket.bufferedAmount = FULL;
    for (const passed of [0, 10, 0.1]) {
      expect(closed).toEqual([]);
      state.now += passed;
      broadcastFrame(gateway, state.newest);
    }
    expect(closed).toEqual([{ code: 4009, reason: 'Too slow' }]);
    const late = signedIn('p2', 'stream');
    late.socket.bufferedAmount = FULL;
    const events = Array.from({ length: 500 }, () => EVENT);
    state.newest = worldOf([shipOf('p2')], { events });
    broadcastFrame(gateway, state.newest);
    broadcastFrame(gateway, state.newest);
    expect(late.closed).toEqual([]);
    broadcastFrame(gateway, state.newest);
    expect(late.closed).toEqual([{ code: 4009, reason: 'Too slow: too many events waiting' }]);
    const both = signedIn('p3', 'stream');
    both.socket.bufferedAmount = FULL;
    const gone = { shipId: 's1', playerId: 'p1', name: 'Kestrel', reason: 'collision', body: 'Luna' };
    state.newest = {
      ...worldOf([shipOf('p3')], { events }),
      removed: Array.from({ length: 501 }, () => gone),
    };
    broadcastFrame(gateway, state.newest);
    expect(both.closed).toHaveLength(1);
  });

  it('has its 10 s restarted when it has room', () => {
    const { gateway, state, signedIn } = createFakeGateway();
    const { closed, socket } = signedIn('p1', 'stream');
    state.newest = worldOf([shipOf('p1')]);
    for (const buffered of [FULL, 0, FULL, FULL]) {
      socket.bufferedAmount = buffered;
      broadcastFrame(gateway, state.newest);
      state.now += 6;
    }
    expect(closed).toEqual([]);
  });
});

it('a connection is closed once, and not if its socket has closed by itself', () => {
  const { connect } = createFakeGateway();
  const [pilot, gone] = [connect('json'), connect('json')];
  disconnect(pilot.client, 4001, 'first');
  disconnect(pilot.client, 4008, 'second');
  expect(pilot.closed).toEqual([{ code: 4001, reason: 'first' }]);
  gone.socket.readyState = 3;
  disconnect(gone.client, 4001, 'late');
  expect([gone.closed, gone.client.isClosing]).toEqual([[], false]);
});

describe('a hangar', () => {
  const hangar: Hangar = {
    shipId: (playerId) => `ship-${playerId}`,
    spawn: (playerId) => (playerId === 'nobody' ? null : { ship_id: `ship-${playerId}` }),
    delay: 5,
  };

  it('spawns a new player’s ship at once, and retries after 10 s, unless the world is paused', () => {
    const { gateway, state, commands, signedIn } = createFakeGateway(hangar);
    const { sent } = signedIn('p1', 'stream');
    signedIn('nobody', 'stream');
    const broadcast = (paused: boolean, seconds = 0) => {
      state.now += seconds;
      state.newest = worldOf([], { paused });
      broadcastFrame(gateway, state.newest);
      return commands.length;
    };
    expect(broadcast(true)).toBe(0);
    expect(broadcast(false)).toBe(1);
    expect(commands).toEqual([['spawn', { ship_id: 'ship-p1' }]]);
    expect(sent[0]).toMatchObject({ kind: 'hello', shipId: 'ship-p1' });
    expect([
      broadcast(false, 9.9),
      broadcast(false, 0.1),
      broadcast(false, 9.9),
      broadcast(false, 0.1),
    ]).toEqual([1, 2, 2, 3]);
  });

  it('spawns the next ship 5 s after a loss', () => {
    const { gateway, state, commands, signedIn } = createFakeGateway(hangar);
    signedIn('p1', 'stream');
    const broadcast = (ships: readonly ReturnType<typeof shipOf>[], seconds: number) => {
      state.now += seconds;
      state.newest = worldOf(ships);
      broadcastFrame(gateway, state.newest);
      return commands.length;
    };
    expect(broadcast([shipOf('p1')], 0)).toBe(0);
    expect([
      broadcast([], 100),
      broadcast([], 4.9),
      broadcast([], 0.1),
      broadcast([], 9.9),
      broadcast([], 0.1),
    ]).toEqual([0, 0, 1, 1, 2]);
    expect(broadcast([shipOf('p1')], 1)).toBe(2);
    expect([broadcast([], 1), broadcast([], 4.9), broadcast([], 0.1)]).toEqual([2, 2, 3]);
  });
});
