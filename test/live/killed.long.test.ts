import { expect, it } from 'vitest';
import type { Process } from '../../.ci/stack.mjs';
import { type Operator, type ShipEvent, startOperator } from './operator';
import { type LivePilot, startPilot } from './pilot';

/** Processes are killed with -9 in mid-bounce: each alone and all together, five times each. */
const VICTIMS: readonly (readonly ('redis' | 'service' | 'gateway')[])[] = [
  ['service'],
  ['gateway'],
  ['redis'],
  ['redis', 'service', 'gateway'],
];
const ROUNDS = 20;
const PILOTS = ['one', 'two'];
const SHIPS = PILOTS.map((name) => `ship-${name}`);
/** ms between two looks at Redis. */
const POLL = 20;
/** ms; for hangs alone. */
const PATIENCE = 120_000;

type SeenShip = Readonly<Record<string, unknown>>;
const isMidBounce = (ship: SeenShip) => ship['touched'] === true;
const isLanded = (ship: SeenShip) => ship['surface_contact_state'] === 'landed';

/** Both ships fall, bounce and settle; `disturb` runs between their first contact and rest. Returns the events of each ship. */
async function bounce(operator: Operator, disturb: () => Promise<void>): Promise<ShipEvent[][]> {
  const before = (await operator.frame()).tick;
  await Promise.all(PILOTS.map((name) => operator.drop(name, 5, 12)));
  await untilBoth(operator, before, isMidBounce);
  await disturb();
  await untilBoth(operator, before, isLanded);
  const all = await Promise.all(SHIPS.map((shipId) => operator.eventsOf(shipId)));
  return all.map((events) => events.filter(({ tick }) => tick >= before));
}

/** Waits until the service's newest frame is after `tick` and has both ships in the expected state. */
async function untilBoth(
  operator: Operator,
  tick: number,
  isMet: (ship: SeenShip) => boolean,
): Promise<void> {
  for (;;) {
    // Redis may be down.
    const frame = await operator.frame().catch(() => null);
    if (frame !== null && frame.tick > tick && frame.ships.length === 2 && frame.ships.every(isMet)) return;
    await new Promise((resolve) => setTimeout(resolve, POLL));
  }
}

/** Kills all, then starts Redis before its clients. */
async function restart({ stack }: Operator, victims: (typeof VICTIMS)[number]): Promise<void> {
  await Promise.all(victims.map((name) => stack[name].end('SIGKILL')));
  const start = (processes: readonly Process[]) => Promise.all(processes.map((process) => process.start()));
  if (victims.includes('redis')) await start([stack.redis]);
  await start(victims.filter((name) => name !== 'redis').map((name) => stack[name]));
}

const types = (events: readonly ShipEvent[]) => events.map(({ event }) => event);

/** The events of a ship in the frames that reached a pilot, of the ticks from `first` on. */
function receivedBy(pilot: LivePilot, shipId: string, first: number): string[] {
  return pilot
    .frames()
    .flatMap(({ events = [] }) => events)
    .filter((event) => event.shipId === shipId && event.tick >= first)
    .map(({ type }) => type);
}

/** Every pilot receives every event of both ships once; a pilot whose gateway died may still be reconnecting. */
async function expectReceived(
  pilots: readonly LivePilot[],
  events: readonly (readonly ShipEvent[])[],
  label: string,
): Promise<void> {
  for (const pilot of pilots)
    for (const [i, shipId] of SHIPS.entries())
      await expect
        .poll(() => receivedBy(pilot, shipId, events[i]![0]!.tick), { timeout: PATIENCE, message: label })
        .toEqual(types(events[i]!));
}

it(`reports every event once and loses no ship through ${ROUNDS} kills in mid-bounce`, async () => {
  const operator = await startOperator('always', ['--lease-ms', '1000']);
  const pilots: LivePilot[] = [];
  try {
    await operator.set('game:tick_rate', '10');
    await operator.set('game:time_scale', '4');
    for (const name of PILOTS) {
      await operator.drop(name, 5, 12);
      pilots.push(startPilot(await operator.addressOf(name, 'stream')));
    }
    await untilBoth(operator, 0, isLanded);
    const undisturbed = await bounce(operator, () => Promise.resolve());
    const expected = undisturbed.map(types);
    expect(expected[0]).toEqual(['ship.contact', 'ship.contact', 'ship.landed']);
    for (let round = 0; round < ROUNDS; round++) {
      const victims = VICTIMS[round % VICTIMS.length]!;
      const label = `round ${round}: ${victims.join(', ')}`;
      const events = await bounce(operator, () => restart(operator, victims));
      expect(events.map(types), label).toEqual(expected);
      const ids = (await operator.frame()).ships.map((ship) => ship['ship_id']);
      expect(ids, label).toEqual(SHIPS);
      await expectReceived(pilots, events, label);
    }
    const all = await Promise.all(SHIPS.map((shipId) => operator.eventsOf(shipId)));
    const since = all.map((events, i) => events.filter(({ tick }) => tick >= undisturbed[i]![0]!.tick));
    expect(since.map((events) => events.length)).toEqual([3 * (ROUNDS + 1), 3 * (ROUNDS + 1)]);
    await expectReceived(pilots, since, 'all rounds');
    for (const pilot of pilots) expect(pilot.trouble).toEqual([]);
  } finally {
    for (const pilot of pilots) pilot.dispose();
    await operator.stop();
  }
});
