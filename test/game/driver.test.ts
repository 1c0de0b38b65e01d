import { expect, it } from 'vitest';
import { createDriver } from '../../src/game';
import type { GameSocket } from '../../src/game/socket';
import { createVirtualClock } from './virtualClock';

/** A driver on a stopped clock with an open socket, and everything that it sent. */
function openedDriver() {
  const sent: unknown[] = [];
  const socket: GameSocket = {
    onopen: null,
    onmessage: null,
    onclose: null,
    onerror: null,
    readyState: 1,
    send: (message) => sent.push(message),
    close: () => undefined,
  };
  const clock = createVirtualClock();
  const driver = createDriver({
    address: 'ws://localhost/stream',
    clock,
    jitter: () => 0.5,
    openSocket: () => socket,
    auth: () => 'auth',
    ping: () => 'ping',
    onData: () => undefined,
    onStatus: undefined,
  });
  socket.onopen!({} as never);
  return { driver, sent, clock, socket };
}

it('sends no messages of the caller between the opening of the socket and the welcome', () => {
  const { driver, sent } = openedDriver();
  expect(driver.write('inputs')).toBe(false);
  expect(sent).toEqual(['auth']);
  driver.dispatch({ kind: 'welcome' });
  expect(driver.write('inputs')).toBe(true);
  expect(sent).toEqual(['auth', 'inputs']);
});

it('sends nothing on a closing socket, and reports it', () => {
  const { driver, sent, socket } = openedDriver();
  driver.dispatch({ kind: 'welcome' });
  Object.assign(socket, { readyState: 2 });
  expect(driver.write('inputs')).toBe(false);
  expect(sent).toEqual(['auth']);
});

it.each([
  // The server's own interval, or the measured one where the server is slower than announced.
  ['told', 1, [3, 3, 4.5]],
  // A quarter of the way to each interval seen, from one second on.
  ['seen', undefined, [3, 2.625, 3.09375]],
] as const)('waits for three intervals, %s, before it takes a server for silent', (_, interval, waits) => {
  const { driver, clock } = openedDriver();
  driver.dispatch({ kind: 'welcome' });
  const waitsAfter = [0, 0.5, 1.5].map((seconds) => {
    clock.pass(seconds);
    driver.stateReceived(interval);
    return driver.state().stateBy - clock.now();
  });
  expect(waitsAfter).toEqual(waits);
});

it('detaches from a socket that it gives up, and ignores its late messages', () => {
  const { driver, socket } = openedDriver();
  driver.dispatch({ kind: 'end' });
  expect([socket.onopen, socket.onmessage, socket.onclose]).toEqual([null, null, null]);
});

it.each([
  ['an error', new Error('bad address'), 'bad address'],
  ['anything else', 'no network', 'no network'],
])('keeps the reason why no socket opens: %s', (_, thrown, reason) => {
  const driver = createDriver({
    address: 'ws://localhost/stream',
    clock: createVirtualClock(),
    jitter: () => 0.5,
    openSocket: () => {
      // What a host may throw.
      // eslint-disable-next-line @typescript-eslint/only-throw-error
      throw thrown;
    },
    auth: () => 'auth',
    ping: () => 'ping',
    onData: () => undefined,
    onStatus: undefined,
  });
  expect(driver.state()).toMatchObject({
    phase: 'waiting',
    ended: { cause: 'unreachable', code: 0, reason },
  });
});
