import { expect, it } from 'vitest';
import { NEUTRAL_CONTROLS } from '../../src/dynamics';
import { connect, heard, say, sockets, until, useGameServer, welcomed } from './gameServer';

useGameServer();

const thrust = (level: number) => ({ ...NEUTRAL_CONTROLS, thrustLevel: level });
const thrustsHeard = () =>
  (heard as { type: string; thrust_level?: number }[])
    .filter(({ type }) => type === 'control')
    .map(({ thrust_level: level }) => level);

/** The server drops the connection, and the client comes back to another. */
async function reconnect(
  { clock, told }: Awaited<ReturnType<typeof welcomed>>,
  { shipId = 'a', whileDown }: { shipId?: string; whileDown?: () => void } = {},
): Promise<void> {
  const [signIns, welcomes] = [sockets.length, told.filter((text) => text.startsWith('welcome')).length];
  sockets.at(-1)!.terminate();
  await until(() => told.at(-1)!.startsWith('status waiting'));
  whileDown?.();
  clock.pass(2);
  await until(
    () =>
      sockets.length > signIns &&
      heard.filter((one) => (one as { type: string }).type === 'auth').length > signIns,
  );
  say({ type: 'welcome', player_id: 'p', ship_id: shipId });
  await until(() => told.filter((text) => text.startsWith('welcome')).length > welcomes);
}

/** What was sent before has been heard once this has. */
async function heardAll({ live }: Awaited<ReturnType<typeof welcomed>>): Promise<void> {
  live.send({ type: 'service' });
  await until(() => (heard.at(-1) as { type: string }).type === 'service');
}

it('sends the newest controls that were given while the link was down after the next welcome, ahead of later ones', async () => {
  const made = await welcomed();
  await reconnect(made, {
    whileDown() {
      expect(made.live.sendControls(thrust(0.2))).toBe(false);
      expect(made.live.sendControls(thrust(0.4))).toBe(false);
    },
  });
  made.live.sendControls(thrust(0.6));
  await heardAll(made);
  expect(thrustsHeard()).toEqual([0.4, 0.6]);
});

it('sends controls that were given before the first welcome after it', async () => {
  const made = connect();
  made.live.sendControls(thrust(0.3));
  await until(() => heard.length === 1);
  say({ type: 'welcome', player_id: 'p', ship_id: 'a' });
  await until(() => heard.length === 2);
  expect(thrustsHeard()).toEqual([0.3]);
});

it('sends controls again that may have been lost with the connection, and no others', async () => {
  const made = await welcomed();
  made.live.sendControls(thrust(0.5));
  await heardAll(made);
  // Nothing has confirmed their arrival.
  await reconnect(made);
  await heardAll(made);
  expect(thrustsHeard()).toEqual([0.5, 0.5]);
  // A ping that was sent after them is answered: they have.
  made.clock.pass(2);
  await until(() => (heard.at(-1) as { type: string }).type === 'ping');
  say({ type: 'pong' });
  await until(() => made.told.at(-1)!.includes('paused'));
  await reconnect(made);
  await heardAll(made);
  expect(thrustsHeard()).toEqual([0.5, 0.5]);
});

it('does not take a pong for an answer to controls that were given after its ping', async () => {
  const made = await welcomed();
  made.clock.pass(2);
  await until(() => (heard.at(-1) as { type: string }).type === 'ping');
  made.live.sendControls(thrust(0.7));
  say({ type: 'pong' });
  await until(() => made.told.at(-1)!.includes('paused'));
  await reconnect(made);
  await heardAll(made);
  expect(thrustsHeard()).toEqual([0.7, 0.7]);
});

it('does not send one ship’s controls to another', async () => {
  const made = await welcomed();
  await reconnect(made, { shipId: 'b', whileDown: () => void made.live.sendControls(thrust(1)) });
  await heardAll(made);
  expect(thrustsHeard()).toEqual([]);
});
