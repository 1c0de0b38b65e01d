import { expect, it } from 'vitest';
import { WebSocket } from 'ws';
import { type Operator, startOperator } from './operator';
import { startPilot } from './pilot';

/** A raw client of the gateway: what it was told, and how it ended. */
function rawClient(operator: Operator, path: string, options: { origin?: string } = {}) {
  const socket = new WebSocket(`ws://127.0.0.1:${operator.stack.gatewayPort}${path}`, options);
  const texts: string[] = [];
  socket.on('message', (data: Buffer, isBinary) => texts.push(isBinary ? 'bytes' : data.toString()));
  socket.on('error', () => undefined);
  const opened = new Promise((resolve) => socket.once('open', resolve));
  const closed = new Promise<number>((resolve) => socket.once('close', resolve));
  return { socket, texts, opened, closed };
}

it('keeps strangers, the malformed, the oversized, the slow and the flooding from a good pilot', async () => {
  const operator = await startOperator('no');
  const good = startPilot(await operator.addressOf('one', 'stream'));
  try {
    await operator.set('game:tick_rate', '10');
    await operator.drop('one', 5, 0.1);
    await operator.drop('two', 5, 0.1);
    await good.fly((view) => view.own?.shownState === 'landed' && view.own.provenance === 'confirmed');
    const before = { ...good.view().diagnosis };
    const auth = JSON.stringify({ type: 'auth', token: await operator.tokenOf('two') });

    const foreign = rawClient(operator, '/ws', { origin: 'https://evil.example' });
    expect(await foreign.closed).toBe(4003);

    const silent = rawClient(operator, '/ws');
    const forged = rawClient(operator, '/stream');
    await forged.opened;
    forged.socket.send(JSON.stringify({ type: 'auth', token: `${await operator.tokenOf('two')}x` }));
    expect(await forged.closed).toBe(4001);

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

    // Says whose ship it would fly: its own is the only one that moves.
    malformed.socket.send(JSON.stringify({ type: 'control', ship_id: 'ship-one', thrust_level: 1 }));
    const stateOf = async (id: string) =>
      (await operator.frame()).ships.find((ship) => ship['ship_id'] === id)?.['surface_contact_state'];
    await expect.poll(() => stateOf('ship-two')).toBe('');
    expect(await stateOf('ship-one')).toBe('landed');

    const slow = rawClient(operator, '/stream');
    await slow.opened;
    slow.socket.send(auth);
    (slow.socket as unknown as { _socket: { pause: () => void } })._socket.pause();

    const flooding = rawClient(operator, '/ws');
    await flooding.opened;
    flooding.socket.send(auth);
    await expect.poll(() => flooding.texts.length).toBeGreaterThan(0);
    for (let i = 0; i < 2000; i++) flooding.socket.send('{"type":"ping"}');
    expect(await flooding.closed).toBe(4008);
    expect(await silent.closed).toBe(4001);

    const { correctionsMismatch, framesRefused, resyncs } = good.view().diagnosis;
    expect({ correctionsMismatch, framesRefused, resyncs }).toEqual({
      correctionsMismatch: before.correctionsMismatch,
      framesRefused: before.framesRefused,
      resyncs: before.resyncs,
    });
    expect(good.view().own).toMatchObject({ shownState: 'landed', provenance: 'confirmed' });
    expect(good.words.at(-1)).toBe('');
    for (const client of [malformed, slow]) client.socket.terminate();
  } finally {
    good.dispose();
    await operator.stop();
  }
});
