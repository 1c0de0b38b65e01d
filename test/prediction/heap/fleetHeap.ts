import { createAuthority } from '../../../src/authority';
import { createPredictor, type Predictor } from '../../../src/prediction';
import { fleetOrders, loadScenario, type Scenario } from '../../../src/scenarios';
import type { ServerFrame } from '../../../src/wire';
import { scenarioNamed, value } from '../rig';

/** A long slide: every ship in contact for half a minute. */
export const LONG_SLIDE: Scenario = {
  ...scenarioNamed('slide'),
  terrain: 'flat',
  initial: { ...scenarioNamed('slide').initial, height: 0.5, velocity: [90, 0, -2] },
};

/** Hz, of server and page: many frames in little time. */
const TICK_RATE = 5;
const FRAME_RATE = 60;
const FRAMES = FRAME_RATE / TICK_RATE;
/** Ticks of the slide before a measurement, and measured ones. */
const WARM_UP = 110;
const MEASURED = 30;
/**
 * A small fleet that plays first, as long as the engine needs to compile for good what runs once per message and once per frame:
 * its ships, ticks, and the rate of both.
 */
const FIRST_SHIPS = 40;
const FIRST_TICKS = 140;
const FIRST_ROUNDS = 15;

/** Bytes that a predictor of `ships` ships allocates, garbage included. */
export interface FleetHeap {
  readonly ships: number;
  /** Per display frame: `advance` and `view`. */
  readonly frame: number;
  /** Per server frame, decoded, whose states all agree with the prediction. */
  readonly message: number;
  /** Ships in contact at the end, and corrections so far: the measurement is valid only if all are, without a correction. */
  readonly inContact: number;
  readonly corrections: number;
}

/** Plays with a small fleet until everything is compiled. */
export function compileFleet(scenario: Scenario, rounds = FIRST_ROUNDS): void {
  for (let round = 0; round < rounds; round++) {
    const { predictor, frames } = fleetOf(scenario, FIRST_SHIPS, FIRST_TICKS);
    for (const frame of frames) {
      predictor.receive(frame, arrivalOf(frame));
      show(predictor, frame);
    }
  }
}

/** The heap of a fleet that slides in one place; call compileFleet before. */
export function fleetHeap(scenario: Scenario, ships: number): FleetHeap {
  const { predictor, frames } = fleetOf(scenario, ships, WARM_UP + MEASURED);
  const message: number[] = [];
  const frame: number[] = [];
  const reading = median(Array.from({ length: MEASURED }, () => heapUsed() - heapUsed()).map(Math.abs));
  for (const [i, sent] of frames.entries()) {
    const before = heapUsed();
    predictor.receive(sent, arrivalOf(sent));
    const received = heapUsed();
    show(predictor, sent);
    const shown = heapUsed();
    if (i < WARM_UP) continue;
    message.push(received - before - reading);
    frame.push((shown - received - reading) / FRAMES);
  }
  const { ships: views, diagnosis } = predictor.view(0);
  return {
    ships,
    frame: median(frame),
    message: median(message),
    inContact: views.filter(({ surfaceContactState }) => surfaceContactState === 'contact').length,
    corrections: diagnosis.correctionsMismatch + diagnosis.correctionsOtherPilot,
  };
}

function fleetOf(scenario: Scenario, ships: number, ticks: number) {
  const loaded = value(loadScenario(scenario));
  const authority = value(
    createAuthority({
      shipClasses: [loaded.shipClass],
      bodies: [loaded.body],
      terrain: scenario.terrain,
      terrains: { [scenario.terrain]: loaded.terrainHeight },
      tickRate: TICK_RATE,
      timeScale: 1,
    }),
  );
  for (const order of fleetOrders(loaded, ships, 3)) authority.spawn(order);
  const predictor = createPredictor();
  predictor.receive(value(authority.join('me', ''))!, 0);
  const frames: ServerFrame[] = [];
  for (let tick = 1; tick <= ticks; tick++) {
    authority.tick(tick / TICK_RATE);
    frames.push(authority.frameFor('me')!);
  }
  return { predictor, frames };
}

/** Client wall s. */
function arrivalOf({ tick }: ServerFrame): number {
  return tick / TICK_RATE + 0.05;
}

/** The display frames until the next server frame. */
function show(predictor: Predictor, frame: ServerFrame): void {
  for (let k = 1; k <= FRAMES; k++) {
    const now = arrivalOf(frame) + k / FRAME_RATE - 0.01;
    predictor.advance(null, now);
    predictor.view(now);
  }
  predictor.takeOutgoing();
}

function heapUsed(): number {
  return process.memoryUsage().heapUsed;
}

/** Of the measurements during which no collection ran. */
function median(grown: readonly number[]): number {
  const sorted = grown.filter((bytes) => bytes >= 0).sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)]!;
}
