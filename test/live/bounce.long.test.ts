import { afterAll, beforeAll, expect, it } from 'vitest';
import {
  beginTick,
  BODY_STRIDE,
  loadBody,
  loadSettings,
  loadShipClass,
  POSITION,
  SHIP_CLASSES,
  SHIP_STRIDE,
  type ShipRecord,
  stepWorld,
  TERRAINS,
  timingOfTick,
  type World,
  writeBodyMotion,
  writeShip,
} from '../../src/dynamics';
import type { ServerFrame } from '../../src/wire';
import { valueOf } from '../authority/moon';
import { type DelayProxy, startDelayProxy } from './delayProxy';
import { type Operator, startOperator } from './operator';
import { type LivePilot, startPilot } from './pilot';

/** One way, s. */
const DELAY = 0.05;
/** s; offsets are within 5 % after 0.3 (PREDICTION, What is drawn). */
const EASED = 1;

let operator: Operator;
let proxy: DelayProxy;

beforeAll(async () => {
  operator = await startOperator('no');
  proxy = await startDelayProxy(operator.stack.gatewayPort, DELAY);
});
afterAll(async () => {
  await proxy.close();
  await operator.stop();
});

/** A drop of `pilot`'s ship, watched until it has landed. */
async function watchDrop(pilot: LivePilot, name: string, look: () => void): Promise<void> {
  const before = (await operator.frame()).tick;
  await operator.drop(name, 40, 8);
  const isFalling = () =>
    pilot
      .frames()
      .some(
        ({ tick, ships }) =>
          tick > before &&
          ships.some(
            ({ shipId, surfaceContactState }) => shipId === `ship-${name}` && surfaceContactState === '',
          ),
      );
  let isDown = false;
  let since = NaN;
  await pilot.fly((view, now) => {
    const own = view.own;
    if (own === null || !isFalling()) return false;
    if (Number.isNaN(since)) since = now;
    // The jump to the new place is eased for a moment: no part of the bounce.
    if (now - since < EASED) return false;
    look();
    isDown ||= own.surfaceContactState === 'contact';
    return isDown && own.shownState === 'landed' && own.provenance === 'confirmed';
  });
}

it.each([1, 10])(
  'a coasting bounce at %i Hz agrees with the service on /stream, with no correction',
  async (rate) => {
    await operator.set('game:tick_rate', String(rate));
    await operator.drop('one', 5, 0.1);
    const pilot = startPilot(await operator.addressOf('one', 'stream', proxy.port));
    await pilot.fly((view) => view.own?.shownState === 'landed' && view.own.provenance === 'confirmed');
    pilot.predictor.teleported('ship-one');
    const corrections = () => {
      const { correctionsMismatch, correctionsLateInput, correctionsLostInput } = pilot.view().diagnosis;
      return correctionsMismatch + correctionsLateInput + correctionsLostInput;
    };
    let atStart = -1;
    await watchDrop(pilot, 'one', () => {
      if (atStart < 0) atStart = corrections();
    });
    const made = corrections() - atStart;
    pilot.dispose();
    console.log(
      `/stream at ${rate} Hz: ${made} corrections, last mismatch ${JSON.stringify(pilot.view().diagnosis.lastMismatch)}`,
    );
    expect(pilot.trouble).toEqual([]);
    expect(made).toBe(0);
  },
);

it.each([1, 10])(
  'on /ws, at %i Hz, a coasting bounce is drawn within 2 cm of the service at the 95th percentile',
  async (rate) => {
    await operator.set('game:tick_rate', String(rate));
    await operator.drop('two', 5, 0.1);
    const exact = startPilot(await operator.addressOf('one', 'stream'));
    const pilot = startPilot(await operator.addressOf('two', 'ws', proxy.port));
    await pilot.fly((view) => view.own?.shownState === 'landed' && view.own.provenance === 'confirmed');
    const seen: { tick: number; since: number; place: readonly number[] }[] = [];
    await watchDrop(pilot, 'two', () => {
      const view = pilot.view();
      seen.push({ tick: view.tick, since: view.sinceTick, place: [...view.own!.easedPosition] });
    });
    const errors = seen.map(({ tick, since, place }) =>
      distanceTo(exact.frames() as ServerFrame[], { tick, since, place }),
    );
    const known = errors.filter((error) => !Number.isNaN(error)).sort((a, b) => a - b);
    const p95 = known[Math.floor(known.length * 0.95)]!;
    console.log(
      `/ws at ${rate} Hz: p50 ${known[known.length >> 1]}, p95 ${p95}, largest ${known.at(-1)} m, of ${known.length}`,
    );
    exact.dispose();
    pilot.dispose();
    expect(known.length).toBeGreaterThan(60);
    expect(p95).toBeLessThan(0.02);
  },
);

/** How far a drawn place is from where the law takes the service's own state of that tick. */
function distanceTo(
  frames: readonly ServerFrame[],
  { tick, since, place }: { tick: number; since: number; place: readonly number[] },
): number {
  const frame = frames.find((one) => one.tick === tick);
  const ship = frame?.ships.find(({ shipId }) => shipId === 'ship-two');
  if (frame === undefined || ship?.relativePosition === null || ship === undefined) return NaN;
  const world = worldOf(frame);
  const rows = new Float64Array(SHIP_STRIDE);
  expect(writeShip(rows, 0, ship as unknown as ShipRecord, world)).toBeNull();
  const bodies = new Float64Array(world.bodies.length * BODY_STRIDE);
  for (const [i, body] of frame.bodies.entries()) writeBodyMotion(bodies, i * BODY_STRIDE, body);
  const { dt } = timingOfTick(frame.timeScale / frame.tickRate, world.settings.contactLongestSubstep);
  const events = new Uint8Array(1);
  beginTick(rows, bodies, world);
  const steps = since / dt;
  let before = [...rows.subarray(POSITION, POSITION + 3)];
  for (let s = 0; s < steps; s++) {
    before = [...rows.subarray(POSITION, POSITION + 3)];
    stepWorld(rows, bodies, events, world, dt);
  }
  const part = steps - Math.floor(steps);
  const at = before.map((from, k) =>
    part === 0 ? rows[POSITION + k]! : from + (rows[POSITION + k]! - from) * part,
  );
  return Math.hypot(...at.map((value, k) => value - place[k]!));
}

function worldOf(frame: ServerFrame): World {
  return {
    settings: valueOf(loadSettings({})),
    shipClasses: SHIP_CLASSES.map((one) => valueOf(loadShipClass(one))),
    bodies: frame.bodies.map((one) => valueOf(loadBody(one))),
    terrainHeight: TERRAINS['hills']!,
  };
}
