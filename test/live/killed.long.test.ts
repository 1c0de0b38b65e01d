import { expect, it } from 'vitest';
import type { Process } from '../../.ci/stack.mjs';
import { type Operator, type ShipEvent, startOperator } from './operator';
import { type LivePilot, startPilot } from './pilot';

/** What is killed with -9 in mid-bounce, in turn: each alone and all together, five times each. */
const VICTIMS: readonly (readonly ('service' | 'gateway' | 'redis')[])[] = [
  ['service'],
  ['gateway'],
  ['redis'],
  ['redis', 'service', 'gateway'],
];
const ROUNDS = 20;
/** ms between two looks at Redis. */
const POLL = 20;

/** Both ships fall and bounce; `disturb` comes while the first is on its way up or down again. */
async function bounce(operator: Operator, disturb: () => Promise<void>): Promise<ShipEvent[][]> {
  const before = (await operator.frame()).tick;
  for (const name of ['one', 'two']) await operator.drop(name, 5, 12);
  await untilFrame(operator, ({ tick, state }) => tick > before && state === 'contact');
  await disturb();
  await untilFrame(operator, ({ tick, state }) => tick > before && state === 'landed');
  const all = await Promise.all(['one', 'two'].map((name) => operator.eventsOf(`ship-${name}`)));
  return all.map((events) => events.filter(({ tick }) => tick >= before));
}

/** Until the service's newest frame has both ships and the last of them in a state. */
async function untilFrame(
  operator: Operator,
  met: (seen: { tick: number; state: string }) => boolean,
): Promise<void> {
  for (;;) {
    const { tick, ships } = await operator.frame().catch(() => ({ tick: -1, ships: [] }));
    const states = ships.map((ship) => String(ship['surface_contact_state']));
    if (states.length === 2 && states.every((state) => met({ tick, state }))) return;
    await new Promise((resolve) => setTimeout(resolve, POLL));
  }
}

async function restart(victims: readonly Process[]): Promise<void> {
  await Promise.all(victims.map((victim) => victim.end('SIGKILL')));
  for (const victim of victims) await victim.start();
}

const types = (events: readonly ShipEvent[]) => events.map(({ event }) => event);

it(`tells every event once and loses no ship through ${ROUNDS} kills in mid-bounce`, async () => {
  const operator = await startOperator('always');
  const { stack } = operator;
  const pilots: LivePilot[] = [];
  try {
    await operator.set('game:tick_rate', '10');
    for (const name of ['one', 'two']) {
      await operator.drop(name, 5, 12);
      pilots.push(startPilot(await operator.addressOf(name, 'stream')));
    }
    await untilFrame(operator, ({ state }) => state === 'landed');
    const undisturbed = (await bounce(operator, () => Promise.resolve())).map(types);
    expect(undisturbed[0]).toEqual(expect.arrayContaining(['ship.contact', 'ship.landed']));
    for (let round = 0; round < ROUNDS; round++) {
      const victims = VICTIMS[round % VICTIMS.length]!;
      const events = await bounce(operator, () => restart(victims.map((name) => stack[name])));
      const said = `round ${round}, ${victims.join(' and ')}`;
      expect(events.map(types), said).toEqual(undisturbed);
      for (const list of events)
        expect(new Set(list.map((event) => JSON.stringify(event))).size, said).toBe(list.length);
      const { ships } = await operator.frame();
      expect(
        ships.map((ship) => ship['ship_id']),
        said,
      ).toEqual(['ship-one', 'ship-two']);
    }
    for (const pilot of pilots) {
      await pilot.fly((view) => view.own?.shownState === 'landed' && view.own.provenance === 'confirmed');
      expect(pilot.trouble).toEqual([]);
    }
  } finally {
    for (const pilot of pilots) pilot.dispose();
    await operator.stop();
  }
});
