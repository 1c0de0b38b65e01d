import { BODY_STRIDE, SHIP_STRIDE, stepWorld, writeBodyMotion, writeShip } from '../../../src/dynamics';
import { fleetOrders, loadScenario } from '../../../src/scenarios';
import { compileFleet, fleetHeap, LONG_SLIDE } from '../../prediction/heap/fleetHeap';
import { value } from '../../prediction/rig';
import type { ServerFrame } from '../../../src/wire';
import { type Figure, spread } from './figure';
import { createAuthority } from '../../../src/authority';
import { createPredictor } from '../../../src/prediction';
import { createDiagnosis } from '../../../src/prediction/diagnosis';
import { AWAKE_FEATURES } from '../../../src/prediction/features';
import { createSimulation } from '../../../src/prediction/simulation/createSimulation';
import { runReplays, startReplay } from '../../../src/prediction/simulation/replay';
import { addTrack } from '../../../src/prediction/simulation/track';
import { setTempo } from '../../../src/prediction/time/timeline';
import { updateBodies } from '../../../src/prediction/snapshots/bodies/updateBodies';
import { loadConfig } from '../../../src/prediction/lifecycle/worldConfig';

const SHIPS = 1000;
/** Hz: many frames in little time. */
const TICK_RATE = 5;
/** Warm-up ticks, and measured ticks. */
const WARM_UP = 120;
const MEASURED = 25;

/** Cost of prediction. Timings vary between runs and with load. */
export function* costFigures(): Generator<Figure> {
  yield* thousandShips();
  yield* heapOfFleet();
  yield replayOfHundred();
}

function* thousandShips(): Generator<Figure> {
  const loaded = value(loadScenario(LONG_SLIDE));
  const authority = value(
    createAuthority({
      shipClasses: [loaded.shipClass],
      bodies: [loaded.body],
      terrain: 'flat',
      terrains: { flat: loaded.terrainHeight },
      tickRate: TICK_RATE,
      timeScale: 1,
    }),
  );
  for (const order of fleetOrders(loaded, SHIPS, 3)) authority.spawn(order);
  const predictor = createPredictor();
  predictor.receive(value(authority.join('me', ''))!, 0);
  const frames: ServerFrame[] = [];
  for (let tick = 1; tick <= WARM_UP + MEASURED; tick++) {
    authority.tick(tick / TICK_RATE);
    frames.push(authority.frameFor('me')!);
  }
  const timings = { frame: [] as number[], receive: [] as number[] };
  for (const [i, frame] of frames.entries()) {
    const arrival = (i + 1) / TICK_RATE + 0.05;
    const began = performance.now();
    predictor.receive(frame, arrival);
    const took = performance.now() - began;
    const measuring = i >= WARM_UP;
    if (measuring) timings.receive.push((took * 1000) / SHIPS);
    for (let k = 1; k <= 60 / TICK_RATE; k++) {
      const now = arrival + k / 60 - 0.01;
      const start = performance.now();
      predictor.advance(null, now);
      predictor.view(now);
      if (measuring) timings.frame.push(performance.now() - start);
    }
    predictor.takeOutgoing();
  }
  const view = predictor.view(0);
  const inContact = view.ships.filter(({ surfaceContactState }) => surfaceContactState === 'contact').length;
  const d = view.diagnosis;
  const corrections = d.correctionsMismatch + d.correctionsOtherPilot;
  const note = `${inContact} of ${SHIPS} ships in contact, ${corrections} corrections`;
  const sound = inContact >= 0.99 * SHIPS && corrections === 0;
  const frame = spread(timings.frame);
  const quietest = quietestMedian(timings.frame, 60 / TICK_RATE);
  yield {
    name: '1,000 ships in contact, one 60 Hz frame (advance + view)',
    unit: 'ms',
    value: quietest,
    ...frame,
    target: '≤ 1',
    met: sound && quietest <= 1,
    timing: true,
    note: `${note}; the value is the median of the quietest of ${MEASURED} ticks, for other programs share the machine`,
  };
  const receive = spread(timings.receive);
  yield {
    name: 'reconcile without a difference',
    unit: 'µs a ship',
    p50: receive.p50,
    max: receive.max,
    target: 'p50 ≤ 2',
    met: sound && receive.p50 <= 2,
    timing: true,
    note,
  };
}

/**
 * Heap that a display frame and a received state allocate, once all is compiled. A server frame has a fixed cost; that of a state is
 * the additional cost of the larger fleet's frame.
 */
function* heapOfFleet(): Generator<Figure> {
  compileFleet(LONG_SLIDE);
  const half = fleetHeap(LONG_SLIDE, SHIPS / 2);
  const whole = fleetHeap(LONG_SLIDE, SHIPS);
  const sound = [half, whole].every(
    ({ ships, inContact, corrections }) => inContact >= 0.99 * ships && corrections === 0,
  );
  const perShip = whole.frame / SHIPS;
  yield {
    name: '1,000 ships in contact, one 60 Hz frame: heap',
    unit: 'bytes a ship',
    value: perShip,
    target: '0 (below 0.5)',
    met: sound && perShip < 0.5,
    timing: true,
    note: `${Math.round(whole.frame)} bytes a frame; ${Math.round(half.frame)} with half as many ships`,
  };
  const perState = (whole.message - half.message) / (whole.ships - half.ships);
  yield {
    name: 'reconcile without a difference: heap',
    unit: 'bytes a state',
    value: perState,
    target: '0 (below 0.5)',
    met: sound && perState < 0.5,
    timing: true,
    note: `${Math.round(whole.message)} bytes a server frame; ${Math.round(half.message)} with half as many states`,
  };
}

/** The smallest of the medians over `length` frames: the cost without other load. */
function quietestMedian(values: readonly number[], length: number): number {
  let least = Number.POSITIVE_INFINITY;
  for (let i = 0; i + length <= values.length; i += length)
    least = Math.min(least, spread(values.slice(i, i + length)).p50);
  return least;
}

/** Adopting and replaying 100 substeps of one ship, relative to 100 steps of the law alone. */
function replayOfHundred(): Figure {
  const loaded = value(loadScenario(LONG_SLIDE));
  const told = { settings: {}, shipClasses: [loaded.shipClass], bodies: [loaded.body], terrain: 'flat' };
  const world = value(loadConfig(told, { terrains: { flat: loaded.terrainHeight }, features: {} }));
  const sim = createSimulation(world, [loaded.body], {
    features: AWAKE_FEATURES,
    counters: createDiagnosis(),
    warn: () => undefined,
    plan: [],
  });
  setTempo(sim.timeline, 0, { tickRate: 1, timeScale: 1, paused: false }, null);
  updateBodies(sim.bodies, 0, [loaded.body]);
  const track = addTrack(sim.fleet, 'ship-1', sim.ringLength);
  const start = new Float64Array(SHIP_STRIDE);
  writeShip(start, 0, { ...loaded.ship, surfaceContactState: 'contact' }, world);
  sim.front.tick = 1;
  const rows = start.slice();
  const bodies = new Float64Array(BODY_STRIDE);
  const events = new Uint8Array(1);
  const plain = () => {
    rows.set(start);
    writeBodyMotion(bodies, 0, loaded.body);
    for (let s = 0; s < 100; s++) stepWorld(rows, bodies, events, world, 0.01);
  };
  const replayed = () => {
    startReplay(track, sim, 0, start, 0);
    runReplays(sim, 1000);
  };
  const ratios: number[] = [];
  for (let round = 0; round < 40; round++) {
    const law = timed(plain);
    const replay = timed(replayed);
    if (round >= 10) ratios.push(replay / law);
  }
  const same = rows.every((v, k) => Object.is(v, sim.fleet.front[k]));
  const { p50 } = spread(ratios);
  return {
    name: 'adopt + replay of 100 substeps, as a multiple of 100 substeps of the law',
    unit: '',
    value: p50,
    target: '≤ 1.15',
    met: same && p50 <= 1.15,
    timing: true,
  };
}

/** µs per call. */
function timed(call: () => void): number {
  const began = performance.now();
  for (let i = 0; i < 200; i++) call();
  return ((performance.now() - began) * 1000) / 200;
}
