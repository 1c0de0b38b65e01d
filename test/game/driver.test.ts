import { expect, it } from 'vitest';
import { createDriver } from '../../src/game';
import type { GameSocket } from '../../src/game/socket';
import { createVirtualClock } from './virtualClock';

it('sends nothing of the caller’s between the socket’s opening and the welcome', () => {
  const sent: unknown[] = [];
  const socket: GameSocket = {
    ...{ onopen: null, onmessage: null, onclose: null, onerror: null },
    readyState: 1,
    send: (message) => sent.push(message),
    close: () => undefined,
  };
  const driver = createDriver({
    address: 'ws://localhost/stream',
    clock: createVirtualClock(),
    jitter: () => 0.5,
    openSocket: () => socket,
    auth: () => 'auth',
    ping: () => 'ping',
    onData: () => undefined,
    onStatus: undefined,
  });
  socket.onopen!({} as never);
  expect(driver.write('inputs')).toBe(false);
  expect(sent).toEqual(['auth']);
  driver.happen({ kind: 'welcome' });
  expect(driver.write('inputs')).toBe(true);
  expect(sent).toEqual(['auth', 'inputs']);
});
