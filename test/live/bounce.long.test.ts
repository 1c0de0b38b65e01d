import { afterAll, beforeAll, expect, it } from 'vitest';
import type { Diagnosis } from '../../src/prediction';
import { type DelayProxy, startDelayProxy } from './delayProxy';
import { type Operator, startOperator } from './operator';
import { type LivePilot, startPilot } from './pilot';
import { readServiceStates, type ServiceStates } from './serviceStates';

/** One way, s. */
const DELAY = 0.05;
/** s; the offset of the respawn itself is within 5 % after 0.3 s (PREDICTION, Drawing). */
const EASED = 1;
/** Share of samples that must agree. */
const P95 = 0.95;

let operator: Operator;
let proxy: DelayProxy;
let states: ServiceStates;

beforeAll(async () => {
  operator = await startOperator('no');
  proxy = await startDelayProxy(operator.stack.gatewayPort, DELAY);
  states = await readServiceStates(operator.stack.redisUrl);
});
afterAll(async () => {
  states.stop();
  await proxy.close();
  await operator.stop();
});

interface Look {
  readonly tick: number;
  readonly sinceTick: number;
  readonly position: readonly number[];
  readonly corrections: number;
}

const correctionsOf = (diagnosis: Diagnosis) =>
  diagnosis.correctionsMismatch + diagnosis.correctionsLateInput + diagnosis.correctionsLostInput;

/** A pilot on the ground is respawned 40 m up and watched, from a second after the fall began until the ship has landed. */
async function watchBounce(pilot: LivePilot, name: string): Promise<Look[]> {
  await pilot.fly((view) => view.own?.shownState === 'landed' && view.own.provenance === 'confirmed');
  const before = (await operator.frame()).tick;
  await operator.drop(name, 40, 8);
  const looks: Look[] = [];
  let isDown = false;
  let fallingSince = NaN;
  await pilot.fly((view, now) => {
    const { own, tick, sinceTick } = view;
    if (own === null || !hasFrameOfFall(pilot, name, before)) return false;
    if (Number.isNaN(fallingSince)) fallingSince = now;
    if (now - fallingSince < EASED) return false;
    looks.push({
      tick,
      sinceTick,
      position: [...own.easedPosition],
      corrections: correctionsOf(view.diagnosis),
    });
    isDown ||= own.surfaceContactState === 'contact';
    return isDown && own.shownState === 'landed' && own.provenance === 'confirmed';
  });
  return looks;
}

function hasFrameOfFall(pilot: LivePilot, name: string, before: number): boolean {
  return pilot
    .frames()
    .some(
      ({ tick, ships }) =>
        tick > before &&
        ships.some(
          ({ shipId, surfaceContactState }) => shipId === `ship-${name}` && surfaceContactState === '',
        ),
    );
}

/** Distances of the drawn ship from the service's, m, ascending. */
function errorsOf(looks: readonly Look[], shipId: string): number[] {
  return looks
    .flatMap((look) => {
      const truth = states.positionAt(shipId, look);
      return truth === null ? [] : [Math.hypot(...truth.map((value, k) => value - look.position[k]!))];
    })
    .sort((a, b) => a - b);
}

const CASES = [
  { path: 'stream', rate: 1 },
  { path: 'stream', rate: 10 },
  { path: 'ws', rate: 1 },
  { path: 'ws', rate: 10 },
] as const;

it.each(CASES)(
  'draws a coasting bounce on /$path at $rate Hz at the service’s position',
  async ({ path, rate }) => {
    await operator.set('game:tick_rate', String(rate));
    await operator.drop('one', 5, 0.1);
    const pilot = startPilot(await operator.addressOf('one', path, proxy.port));
    const looks = await watchBounce(pilot, 'one');
    pilot.dispose();
    const errors = errorsOf(looks, 'ship-one');
    const [p95, worst] = [errors[Math.floor(errors.length * P95)]!, errors.at(-1)!];
    const corrections = looks.at(-1)!.corrections - looks[0]!.corrections;
    console.log(
      `/${path}, ${rate} Hz: ${corrections} corrections; p95 ${(p95 * 1000).toFixed(3)} mm, worst ${(worst * 1000).toFixed(3)} mm of ${errors.length} looks`,
    );
    expect(pilot.trouble).toEqual([]);
    expect(errors.length).toBeGreaterThan(looks.length / 2);
    expect(p95).toBeLessThan(0.02);
    // Without relative fields the states are rounded.
    if (path === 'stream') expect(corrections).toBe(0);
  },
);
