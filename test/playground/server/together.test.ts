import { afterEach, describe, expect, it, vi } from 'vitest';
import { NEUTRAL_CONTROLS } from '../../../src/dynamics';
import { createLive } from '../../../src/playground/game/live/live';
import { DEFAULT_CHOICES } from '../../../src/playground/panels/choices';
import { createSession } from '../../../src/playground/server/session';
import {
  createTabHost,
  openTab,
  type TabChannel,
  type ToGuest,
} from '../../../src/playground/server/tabLink';
import { createPredictor, type Predictor } from '../../../src/prediction';
import { NETWORK_PRESETS } from '../../../src/scenarios';
import { decodeServerMessage, encodeClientMessage } from '../../../src/wire';

afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

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

  it('begin the scenario for a guest when it joins: the engine hovers until the guest flies', async () => {
    vi.useFakeTimers();
    const channelOf = createRoom();
    vi.stubGlobal('BroadcastChannel', function () {
      return channelOf();
    });
    const session = createSession();
    const now = () => performance.now() / 1000;
    expect(session.operate({ ...LOAD, terrain: '' }, now())).toBeNull();
    const host = createTabHost(channelOf(), {
      join: (guest, name) => session.join(guest, name, now()),
      leave: session.leave,
      send: (guest, bytes) => session.sendFrom(guest, bytes, now()),
      world: session.world,
    });
    const nothing = () => undefined;
    const live = createLive('main.js', {
      ...{ onState: nothing, onWorld: nothing, onRefused: nothing, onEvent: nothing, onEntry: nothing },
      ...{ onLost: nothing, onRun: nothing, onScenario: nothing },
    });
    const play = async (seconds: number) => {
      for (let n = 0; n < seconds * 20; n++) {
        await vi.advanceTimersByTimeAsync(50);
        session.run(now());
        for (const id of host.guests())
          for (const { bytes } of session.deliverTo(id, now())) host.deliver(id, bytes);
        live.frame();
      }
    };
    await play(5);
    live.begin({ ...DEFAULT_CHOICES, server: 'tab:test' });
    // The page loads the tab's code on demand.
    await vi.waitFor(() => expect(host.guests()).toHaveLength(1));
    await play(4);
    const { own, diagnosis } = live.frame();
    expect(own!.controls).toMatchObject({ thrustLevel: 0.078, attitudeHold: true });
    expect(diagnosis.correctionsMismatch).toBe(0);
    live.flightControls.press('throttleCut');
    live.steer();
    await play(1);
    expect(live.frame().own!.controls.thrustLevel).toBe(0);
    // A new name is a new guest: the one before has left.
    live.begin({ ...DEFAULT_CHOICES, server: 'tab:test', pilot: 'Cleo' });
    await play(4);
    expect([live.frame().own!.name, host.guests().length]).toEqual(['Cleo', 1]);
    live.dispose();
  });

  it('fly a plan from the tick at which the guest joined', () => {
    const session = createSession();
    expect(session.operate({ ...LOAD, scenario: 'launch' }, 0)).toBeNull();
    const runTo = (end: number, from: number) => {
      for (let now = from; now <= end; now += 0.1) session.run(now);
    };
    runTo(8, 0);
    expect(session.join('guest-1', 'Bob', 8)).toBeNull();
    runTo(12, 8);
    const states = session.deliverTo('guest-1', 12).flatMap(({ bytes }) => {
      const message = decodeServerMessage(bytes);
      return message.ok && message.value.kind === 'frame' ? message.value.ships : [];
    });
    const own = states.filter(({ shipId }) => shipId === 'guest-1');
    expect(new Set(own.map(({ surfaceContactState }) => surfaceContactState))).toEqual(
      new Set(['landed', '']),
    );
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
