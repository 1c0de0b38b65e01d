import { type Controls, NEUTRAL_CONTROLS } from '../../../src/dynamics';
import { createRandom, type Random, NETWORK_PRESETS } from '../../../src/scenarios';
import type { ServerMessage } from '../../../src/wire';
import { createRig, type Rig } from '../../prediction/rig';
import type { Figure } from './figure';
import { createSeededPilot } from './flights/pilots';

const HOUR = 3600;
/** Wall s between faults, each kind in turn. */
const FAULT_EVERY = 7;
/** Wall s between readings of the heap; the first belongs to the warm-up. */
const READ_EVERY = 300;

/** Starts a fault, and ends it a few seconds later. */
const FAULTS: readonly (readonly [begin: (rig: Rig, rng: Random) => void, end?: (rig: Rig) => void])[] = [
  [({ exchange }) => exchange.drop('me'), ({ exchange, now }) => exchange.reconnect('me', now)],
  [
    ({ exchange, now }) => exchange.setFrozen(true, now),
    ({ exchange, now }) => exchange.setFrozen(false, now),
  ],
  [({ authority }) => authority.setPaused(true), ({ authority }) => authority.setPaused(false)],
  [({ authority }) => authority.setTickRate(20), ({ authority }) => authority.setTickRate(1)],
  [({ authority }) => authority.setTickRate(5), ({ authority }) => authority.setTickRate(1)],
  [({ authority }) => authority.setTimeScale(10), ({ authority }) => authority.setTimeScale(1)],
  [({ authority }, rng) => authority.kick('ship-1', [rng(), rng(), 2 * rng()], [0, 0.1 * rng(), 0])],
  [({ authority }) => authority.respawn('ship-1')],
  [({ authority }) => authority.despawn('other-1'), respawnOther],
  [hide],
  [({ predictor }) => predictor.refused('garbage')],
  [({ predictor, now }) => predictor.advance({ ...NEUTRAL_CONTROLS, thrustLevel: Number.NaN }, now)],
];

function respawnOther({ authority, loaded }: Rig): void {
  authority.spawn({ shipId: 'other-1', playerId: 'player-1', name: 'Back', ship: loaded.ship });
}

function hide(rig: Rig): void {
  for (let i = 0; i < 150; i++) rig.receiveOnly();
}

/** An hour at 60 Hz on a bad network with all faults: nothing is thrown, and the heap stays flat. */
export function* soakFigures(): Generator<Figure> {
  const rng = createRandom(99);
  const pilot = createSeededPilot(4);
  const controls: { now: Controls } = { now: NEUTRAL_CONTROLS };
  const rig = createRig({
    scenario: 'slide',
    network: NETWORK_PRESETS.broken,
    others: 3,
    pilot: () => controls.now,
  });
  rig.tamper = disorder(rig.tamper, rng);
  const heaps: number[] = [];
  let thrown = '';
  let faults = 0;
  let readings = 0;
  try {
    while (rig.now < HOUR) {
      const [begin, end] = FAULTS[faults % FAULTS.length]!;
      faults += 1;
      controls.now = pilot.at(rig.now);
      begin(rig, rng);
      rig.fly(FAULT_EVERY / 2);
      end?.(rig);
      rig.fly(FAULT_EVERY / 2);
      // Not the predictor's memory: logs of the rig for tests.
      for (const written of [rig.notices, rig.sentInputs, rig.truth.events]) written.length = 0;
      if (rig.now < (readings + 1) * READ_EVERY) continue;
      readings += 1;
      (globalThis as { gc?: () => void }).gc?.();
      heaps.push(process.memoryUsage().heapUsed / 2 ** 20);
    }
  } catch (error) {
    thrown = String((error as Error).stack);
  }
  const d = rig.view().diagnosis;
  const note = `${faults} faults; ${d.framesAccepted} frames taken, ${d.framesDuplicate} duplicate, ${d.framesOutOfOrder} out of order, ${d.resyncs} resyncs, ${d.snaps} snaps`;
  // Because of the collector, readings vary by half a megabyte. Growth is the difference of their means.
  const grown = mean(heaps.slice(-4)) - mean(heaps.slice(2, 6));
  const whole = rig.now >= HOUR && heaps.length >= 11;
  yield {
    name: 'an hour with every fault: thrown',
    unit: '',
    value: thrown === '' ? 0 : 1,
    target: '0',
    met: thrown === '' && whole,
    note: thrown === '' ? note : thrown,
  };
  yield {
    name: 'an hour with every fault: heap grown',
    unit: 'MB',
    value: grown,
    target: '± 1',
    met: whole && Math.abs(grown) <= 1,
    timing: true,
  };
}

function mean(values: readonly number[]): number {
  return values.reduce((sum, x) => sum + x, 0) / values.length;
}

/** Sends some messages twice, and holds some until the next. */
function disorder(tamper: Rig['tamper'], rng: Random): Rig['tamper'] {
  let held: ServerMessage | null = null;
  return (message) => {
    const out = [...tamper(message)];
    if (rng() < 0.05) out.push(...out);
    if (held !== null) {
      out.push(held);
      held = null;
    } else if (message.kind === 'frame' && rng() < 0.1) held = out.pop() ?? null;
    return out;
  };
}
