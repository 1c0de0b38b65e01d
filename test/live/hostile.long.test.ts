import { connect, type Socket } from 'node:net';
import { UnsecuredJWT } from 'jose';
import { expect, it } from 'vitest';
import { WebSocket } from 'ws';
import type { WorldView } from '../../src/prediction';
import { type Operator, startOperator } from './operator';
import { type LivePilot, startPilot } from './pilot';

/** Tolerances for a pilot while other clients misbehave. On /ws states are rounded, so a ship in flight may differ by that. */
function figuresOf(pilot: LivePilot, index: number) {
  const { correctionsMismatch, correctionsLostInput, framesRefused, resyncs } = pilot.view().diagnosis;
  const mismatch = index === 0 ? { correctionsMismatch } : {};
  return { ...mismatch, correctionsLostInput, framesRefused, resyncs };
}

const isHome = (view: WorldView) => view.own?.shownState === 'landed' && view.own.provenance === 'confirmed';

/** A raw client of the gateway: its received messages, and how its connection ended. */
function rawClient(operator: Operator, path: string, options: { origin?: string } = {}) {
  const socket = new WebSocket(`ws://127.0.0.1:${operator.stack.gatewayPort}${path}`, options);
  const texts: string[] = [];
  socket.on('message', (data: Buffer, isBinary) => texts.push(isBinary ? 'bytes' : data.toString()));
  socket.on('error', () => undefined);
  const opened = new Promise((resolve) => socket.once('open', resolve));
  const closed = new Promise<number>((resolve) => socket.once('close', resolve));
  return { socket, texts, opened, closed };
}

/** An upgrade request whose connection is reset before its answer can be written. */
async function resetEarly(operator: Operator, path: string): Promise<void> {
  const socket = connect(operator.stack.gatewayPort, '127.0.0.1');
  socket.on('error', () => undefined);
  await new Promise((resolve) => socket.once('connect', resolve));
  const head = ['Host: game', 'Upgrade: websocket', 'Connection: Upgrade', 'Sec-WebSocket-Version: 13'];
  const key = 'Sec-WebSocket-Key: x3JJHMbDL1EzLkh9GBhXDw==';
  socket.write(`GET ${path} HTTP/1.1\r\n${[...head, key].join('\r\n')}\r\n\r\n`, () =>
    socket.resetAndDestroy(),
  );
  await new Promise((resolve) => socket.once('close', resolve));
}

it('keeps malformed, oversized, unauthenticated, slow and flooding clients from disturbing a pilot on /stream and one on /ws', async () => {
  const operator = await startOperator('no');
  const good = [
    startPilot(await operator.addressOf('one', 'stream')),
    startPilot(await operator.addressOf('three', 'ws')),
  ];
  try {
    await operator.set('game:tick_rate', '10');
    await operator.drop('one', 5, 0.1);
    await operator.drop('two', 5, 0.1);
    await operator.drop('three', 5, 0.1);
    for (const pilot of good) await pilot.fly(isHome);
    const before = good.map(figuresOf);
    const auth = JSON.stringify({ type: 'auth', token: await operator.tokenOf('two') });

    const foreign = rawClient(operator, '/ws', { origin: 'https://evil.example' });
    expect(await foreign.closed).toBe(4003);

    const silent = rawClient(operator, '/ws');
    const unsigned = new UnsecuredJWT({ iss: 'touchdown', sub: 'pilot-two' })
      .setExpirationTime('1h')
      .encode();
    for (const token of [`${await operator.tokenOf('two')}x`, unsigned, '.'.repeat(60_000)]) {
      const forged = rawClient(operator, '/stream');
      await forged.opened;
      forged.socket.send(JSON.stringify({ type: 'auth', token }));
      expect(await forged.closed).toBe(4001);
    }

    const eager = rawClient(operator, '/ws');
    await eager.opened;
    eager.socket.send(JSON.stringify({ type: 'control', thrust_level: 1 }));
    expect(await eager.closed).toBe(4001);

    const oversized = rawClient(operator, '/ws');
    await oversized.opened;
    oversized.socket.send('x'.repeat(70_000));
    expect(await oversized.closed).toBe(1009);

    const malformed = rawClient(operator, '/ws');
    await malformed.opened;
    malformed.socket.send(auth);
    await expect.poll(() => malformed.texts.some((text) => text.includes('"welcome"'))).toBe(true);
    for (const text of ['{', '[]', '{"type":"control","thrust_level":"NaN"}', '{"type":"fly"}'])
      malformed.socket.send(text);
    malformed.socket.send(Uint8Array.of(1, 2, 3));
    await expect.poll(() => malformed.texts.filter((text) => text.includes('"error"')).length).toBe(5);

    // Names another ship to fly: only its own moves.
    malformed.socket.send(JSON.stringify({ type: 'control', ship_id: 'ship-one', thrust_level: 1 }));
    const stateOf = async (id: string) =>
      (await operator.frame()).ships.find((ship) => ship['ship_id'] === id)?.['surface_contact_state'];
    await expect.poll(() => stateOf('ship-two')).toBe('');
    expect(await stateOf('ship-one')).toBe('landed');

    for (let i = 0; i < 50; i++) await resetEarly(operator, ['/nope', '/ws', '/stream'][i % 3]!);

    // Half a request, and half a frame of a client that has signed in.
    const halfOpen = connect(operator.stack.gatewayPort, '127.0.0.1');
    halfOpen.on('error', () => undefined);
    halfOpen.write('GET /ws HTTP/1.1\r\nHost: game\r\n');
    (malformed.socket as unknown as { _socket: Socket })._socket.write(Uint8Array.of(0x81, 0xfe, 0xea));

    const pinging = rawClient(operator, '/ws');
    await pinging.opened;
    pinging.socket.send(auth);
    for (let i = 0; i < 2000; i++) pinging.socket.ping('x'.repeat(125));
    expect(await pinging.closed).toBe(4008);

    const slow = rawClient(operator, '/stream');
    await slow.opened;
    slow.socket.send(auth);
    (slow.socket as unknown as { _socket: Socket })._socket.pause();

    const flooding = rawClient(operator, '/ws');
    await flooding.opened;
    flooding.socket.send(auth);
    await expect.poll(() => flooding.texts.length).toBeGreaterThan(0);
    for (let i = 0; i < 2000; i++) flooding.socket.send('{"type":"ping"}');
    expect(await flooding.closed).toBe(4008);
    expect(await silent.closed).toBe(4001);

    expect(good.map(figuresOf)).toEqual(before);
    for (const pilot of good) {
      await pilot.fly(isHome);
      expect(pilot.words.at(-1)).toBe('');
      expect(pilot.trouble).toEqual([]);
    }
    for (const client of [malformed, slow]) client.socket.terminate();
    halfOpen.destroy();
  } finally {
    for (const pilot of good) pilot.dispose();
    await operator.stop();
  }
});
