/** What the gateway tells its clients of the world. */
import { describe, expect, it } from 'vitest';
import { tellAll, tellBehind, tellOne } from '../../src/gateway/clients/tell';
import type { Hangar } from '../../src/gateway/options';
import { EVENT } from '../wire/messages';
import { createPlace, shipOf, worldOf } from './fakePlace';

const idsOf = (message: unknown) => (message as { ships: { shipId: string }[] }).ships.map((s) => s.shipId);

describe('a state', () => {
  it('follows the hello, which names the player’s own ship and the world as it stands', () => {
    const { place, state, signedIn } = createPlace();
    const { client, sent } = signedIn('p1', 'stream');
    state.newest = worldOf([shipOf('p2'), shipOf('p1')], { tick: 50, tickRate: 20, timeScale: 2 });
    tellAll(place, state.newest);
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
    // The same ship needs no other hello, another one does.
    tellAll(place, state.newest);
    expect(sent).toHaveLength(3);
    state.newest = worldOf([shipOf('p1', 'next')], { tick: 51 });
    tellAll(place, state.newest);
    expect(sent.slice(3)).toMatchObject([{ kind: 'hello', shipId: 'next' }, { kind: 'frame' }]);
  });

  it('is the game’s own on /ws, after a welcome', () => {
    const { place, state, signedIn } = createPlace();
    const { sent } = signedIn('p1', 'json');
    state.newest = worldOf([shipOf('p1')]);
    tellOne(place, place.clients.values().next().value!);
    expect(sent).toMatchObject([
      { type: 'welcome', username: 'user of p1', input_granularity: 'tick' },
      { type: 'state' },
    ]);
  });

  it('goes to nobody who has not signed in, and nowhere before there is a world', () => {
    const { place, state, connect, signedIn } = createPlace();
    const stranger = connect('json');
    const pilot = signedIn('p1', 'json');
    tellOne(place, pilot.client);
    tellBehind(place);
    expect(pilot.sent).toEqual([]);
    state.newest = worldOf([shipOf('p1')]);
    tellAll(place, state.newest);
    expect(stranger.sent).toEqual([]);
    expect(pilot.sent).toHaveLength(2);
    const { place: empty, state: early, signedIn: join } = createPlace();
    empty.world = null;
    const waiting = join('p1', 'stream');
    early.newest = worldOf([shipOf('p1')]);
    tellAll(empty, early.newest);
    expect(waiting.sent).toEqual([]);
  });

  it('acknowledges inputs of the client’s own session that have been applied', () => {
    const { place, state, signedIn } = createPlace();
    const { client, sent } = signedIn('p1', 'stream');
    const last = { seq: 7, tick: 42, substep: 3, margin: 0.5 };
    const acknowledged = (session: string, tick = 42) => {
      const lastInputs = new Map([['ship of p1', { ...last, tick, session }]]);
      state.newest = { ...worldOf([shipOf('p1')], { tick: 42 }), lastInputs };
      tellOne(place, client);
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

  it('is told of ships in sight and of those that are gone, once, and not before its tick', () => {
    const { place, state, signedIn } = createPlace();
    const { sent } = signedIn('p1', 'stream');
    const events = [of('ship of p2'), of('ship of p3'), of('gone'), of('ship of p1', 43)];
    state.newest = worldOf([own, near, far], { tick: 42, events });
    tellAll(place, state.newest);
    const told = (message: unknown) =>
      (message as { events: { shipId: string }[] }).events.map((e) => e.shipId);
    expect(told(sent[1])).toEqual(['ship of p2', 'gone']);
    tellBehind(place);
    state.newest = worldOf([own, near, far], { tick: 43 });
    tellAll(place, state.newest);
    expect(told(sent.at(-1))).toEqual([]);
  });

  it('of a ship that is gone is the game’s own on /ws: whose it was is told that it was destroyed', () => {
    const { place, state, signedIn } = createPlace();
    const victim = signedIn('p1', 'json');
    const witness = signedIn('p2', 'json');
    const gone = { shipId: 's1', playerId: 'p1', name: 'Kestrel', reason: 'collision', body: 'Luna' };
    const scrapped = { ...gone, shipId: 's0', reason: 'removed' };
    state.newest = { ...worldOf([shipOf('p2')]), removed: [gone, scrapped] };
    tellAll(place, state.newest);
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

  it('gets the newest state once it has room, with the events that it missed', () => {
    const { place, state, signedIn } = createPlace();
    const { client, sent, socket } = signedIn('p1', 'stream');
    const send = (tick: number) => {
      state.newest = worldOf([shipOf('p1')], { tick, events: [{ ...EVENT, shipId: 'ship of p1', tick }] });
      tellAll(place, state.newest);
    };
    send(1);
    socket.bufferedAmount = FULL;
    send(2);
    send(3);
    tellBehind(place);
    expect([sent.length, client.isBehind]).toEqual([2, true]);
    socket.bufferedAmount = FULL - 1;
    tellBehind(place);
    expect(sent.at(-1)).toMatchObject({ tick: 3, events: [{ tick: 2 }, { tick: 3 }] });
    expect(client.isBehind).toBe(false);
    tellBehind(place);
    expect(sent).toHaveLength(3);
  });

  it('is sent away after more than 10 s, or with more than 1,000 events waiting', () => {
    const { place, state, signedIn } = createPlace();
    const { closed, socket } = signedIn('p1', 'stream');
    state.newest = worldOf([shipOf('p1')]);
    tellAll(place, state.newest);
    socket.bufferedAmount = FULL;
    for (const passed of [0, 10, 0.1]) {
      expect(closed).toEqual([]);
      state.now += passed;
      tellAll(place, state.newest);
    }
    expect(closed).toEqual([{ code: 4009, reason: 'Too slow' }]);
    const late = signedIn('p2', 'stream');
    late.socket.bufferedAmount = FULL;
    const events = Array.from({ length: 500 }, () => EVENT);
    state.newest = worldOf([shipOf('p2')], { events });
    tellAll(place, state.newest);
    tellAll(place, state.newest);
    expect(late.closed).toEqual([]);
    tellAll(place, state.newest);
    expect(late.closed).toEqual([{ code: 4009, reason: 'Too slow: too many events waiting' }]);
  });

  it('starts its 10 s anew once it had room', () => {
    const { place, state, signedIn } = createPlace();
    const { closed, socket } = signedIn('p1', 'stream');
    state.newest = worldOf([shipOf('p1')]);
    for (const buffered of [FULL, 0, FULL, FULL]) {
      socket.bufferedAmount = buffered;
      tellAll(place, state.newest);
      state.now += 6;
    }
    expect(closed).toEqual([]);
  });
});

describe('a hangar', () => {
  const hangar: Hangar = {
    shipId: (playerId) => `ship-${playerId}`,
    spawn: (playerId) => (playerId === 'nobody' ? null : { ship_id: `ship-${playerId}` }),
    delay: 5,
  };

  it('gives a newcomer a ship at once and again after 10 s, while the world runs', () => {
    const { place, state, commands, signedIn } = createPlace(hangar);
    const { sent } = signedIn('p1', 'stream');
    signedIn('nobody', 'stream');
    const told = (paused: boolean, seconds = 0) => {
      state.now += seconds;
      state.newest = worldOf([], { paused });
      tellAll(place, state.newest);
      return commands.length;
    };
    expect(told(true)).toBe(0);
    expect(told(false)).toBe(1);
    expect(commands).toEqual([['spawn', { ship_id: 'ship-p1' }]]);
    expect(sent[0]).toMatchObject({ kind: 'hello', shipId: 'ship-p1' });
    expect([told(false, 9.9), told(false, 0.1), told(false, 9.9), told(false, 0.1)]).toEqual([1, 2, 2, 3]);
  });

  it('gives the next one 5 s after a loss', () => {
    const { place, state, commands, signedIn } = createPlace(hangar);
    signedIn('p1', 'stream');
    const told = (ships: readonly ReturnType<typeof shipOf>[], seconds: number) => {
      state.now += seconds;
      state.newest = worldOf(ships);
      tellAll(place, state.newest);
      return commands.length;
    };
    expect(told([shipOf('p1')], 0)).toBe(0);
    expect([told([], 100), told([], 4.9), told([], 0.1), told([], 9.9), told([], 0.1)]).toEqual([
      0, 0, 1, 1, 2,
    ]);
    expect(told([shipOf('p1')], 1)).toBe(2);
    expect([told([], 1), told([], 4.9), told([], 0.1)]).toEqual([2, 2, 3]);
  });
});
