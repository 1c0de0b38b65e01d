import { describe, expect, it } from 'vitest';
import { NEUTRAL_CONTROLS } from '../../src/dynamics';
import { createSession } from '../../src/playground/server/session';
import { createTabHost, openTab, type TabChannel, type ToGuest } from '../../src/playground/server/tabLink';
import { createPredictor, type Predictor } from '../../src/prediction';
import { NETWORK_PRESETS } from '../../src/scenarios';
import { decodeServerMessage, encodeClientMessage } from '../../src/wire';

/** Tabs that receive each other's messages at once, instead of shortly after like a BroadcastChannel's. */
function createRoom() {
  const ends: TabChannel[] = [];
  return (): TabChannel => {
    const end: TabChannel = {
      onmessage: null,
      postMessage(message) {
        for (const other of ends) if (other !== end) other.onmessage?.({ data: structuredClone(message) });
      },
      close: () => ends.splice(ends.indexOf(end), 1),
    };
    ends.push(end);
    return end;
  };
}

const LOAD = {
  kind: 'load',
  scenario: 'first-landing',
  body: '',
  shipClass: '',
  terrain: 'hills',
  legacy: false,
  tickRate: 10,
  timeScale: 1,
  network: NETWORK_PRESETS.lan,
  seed: 1,
  others: 0,
  pilot: 'Ann',
};

/** A host's session and a guest's page on one channel and one clock. */
function playTogether() {
  const channelOf = createRoom();
  const session = createSession();
  expect(session.operate(LOAD, 0)).toBeNull();
  let now = 0;
  const host = createTabHost(channelOf(), {
    join: (guest, name) => session.join(guest, name, now),
    leave: session.leave,
    send: (guest, bytes) => session.sendFrom(guest, bytes, now),
    world: session.world,
  });
  const told: string[] = [];
  const own = createPredictor({ ownShipId: 'own' });
  const guest = createPredictor({ ownShipId: 'own' });
  const ignore = () => undefined;
  const connection = openTab(
    'tab:test',
    { guest: 'guest-1', name: 'Bob' },
    {
      onOpen: (what) => told.push(`open ${what}`),
      onPending: (message) => guest.receivePending(message, now),
      onFrame: ignore,
      onLink: (words) => told.push(words),
      onScenario: (scenario, terrain) => told.push(`${scenario} on ${terrain}`),
      onClosed: ignore,
      onWelcome: ignore,
      onShipGone: ignore,
      onRefused: (reason: string) => told.push(reason),
      onRun: ignore,
    },
    channelOf(),
  );
  const step = (controls: Parameters<Predictor['advance']>[0]) => {
    now += 0.02;
    for (const { bytes } of session.run(now)) {
      const message = decodeServerMessage(bytes);
      if (message.ok) own.receive(message.value, now);
    }
    for (const id of host.guests())
      for (const { bytes } of session.deliverTo(id, now)) host.deliver(id, bytes);
    guest.advance(controls, now);
    own.advance(null, now);
    for (const message of guest.takeOutgoing()) connection.send(message);
    for (const message of own.takeOutgoing()) session.send(encodeClientMessage(message), now);
    return { own: own.view(now), guest: guest.view(now) };
  };
  return { host, session, connection, told, step };
}

describe('two tabs on one world', () => {
  it('show each other by name, fly their own ships, and cannot move the other’s', () => {
    const { step, told, connection, host } = playTogether();
    let views = step(null);
    for (let n = 0; n < 150; n++) views = step({ ...NEUTRAL_CONTROLS, thrustLevel: 0.5 });
    expect(told.slice(0, 3)).toEqual(['Waiting for the other tab …', '', 'first-landing on hills']);
    const namesOf = (view: typeof views.own) => view.ships.map(({ name }) => name).sort();
    expect(namesOf(views.own)).toEqual(['Ann', 'Bob']);
    expect(namesOf(views.guest)).toEqual(['Ann', 'Bob']);
    expect([views.own.own?.name, views.guest.own?.name]).toEqual(['Ann', 'Bob']);
    const climb = (view: typeof views.own, name: string) =>
      view.ships.find((ship) => ship.name === name)!.feetHeight;
    expect(climb(views.guest, 'Bob')).toBeGreaterThan(climb(views.guest, 'Ann') + 10);
    expect(climb(views.own, 'Bob')).toBeCloseTo(climb(views.guest, 'Bob'), -1);
    expect(views.guest.diagnosis.correctionsMismatch).toBe(0);
    connection.dispose();
    expect(host.guests()).toEqual([]);
    for (let n = 0; n < 60; n++) views = step(null);
    expect(namesOf(views.own)).toEqual(['Ann']);
  });

  it('continue together in the host’s next world', () => {
    const { step, session, host, told, connection } = playTogether();
    for (let n = 0; n < 20; n++) step(null);
    expect(session.operate({ ...LOAD, scenario: 'ridge' }, 0.4)).toBeNull();
    host.worldBegan();
    expect(told.at(-2)).toBe('ridge on hills');
    let views = step(null);
    for (let n = 0; n < 40; n++) views = step(null);
    expect(views.guest.own?.name).toBe('Bob');
    connection.dispose();
  });

  it('are not affected by other messages on the channel', () => {
    const channelOf = createRoom();
    const stranger = channelOf();
    const heard: ToGuest[] = [];
    stranger.onmessage = ({ data }) => heard.push(data as ToGuest);
    const joined: string[] = [];
    const host = createTabHost(channelOf(), {
      join: (_, name) => {
        joined.push(name);
        return null;
      },
      leave: () => undefined,
      send: () => expect.unreachable(),
      world: () => ({ scenario: 'settle', terrain: 'hills' }),
    });
    const garbage: unknown[] = [
      null,
      7,
      {},
      { kind: 'join', from: '' },
      { kind: 'join', from: 'a b', name: 'x' },
    ];
    garbage.push(
      { kind: 'bytes', from: 'x', bytes: 'no' },
      { kind: 'bytes', from: 'x', bytes: new Uint8Array(9) },
    );
    for (const each of garbage) stranger.postMessage(each as never);
    expect([joined, host.guests(), heard]).toEqual([[], [], []]);
    for (let n = 0; n < 9; n++)
      stranger.postMessage({ kind: 'join', from: `g${n}`, name: `${'<b>'.repeat(20)}\ud800` });
    expect(host.guests()).toHaveLength(7);
    expect(joined[0]).toBe('<b>'.repeat(8));
    expect(heard.filter(({ kind }) => kind === 'refused')).toHaveLength(2);
  });
});
