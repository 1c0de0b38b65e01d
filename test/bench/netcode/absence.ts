import { createAuthority } from '../../../src/authority';
import { createPredictor, type Predictor } from '../../../src/prediction';
import { encodeServerMessage, pendingServerMessage } from '../../../src/protobuf';
import { fleetOrders, loadScenario } from '../../../src/scenarios';
import type { ServerFrame, ServerMessage } from '../../../src/wire';
import { scenarioNamed, value } from '../../prediction/rig';
import type { Figure } from './figure';

/** Ships, tick rate and length of the absence, Hz and wall s. */
const SHIPS = 1000;
const TICK_RATE = 20;
const HIDDEN = 600;
/** First frames, in which every run warms up. */
const WARM_UP = 60;
const BYTES_PER_MEGABYTE = 2 ** 20;
/** The most ships in a frame of the wire. */
const MOST_SHIPS = 10_000;
const ROUNDS = 5;

/** How long one call blocks a page that was hidden, and one whose frame has the most ships. */
export function* absenceFigures(): Generator<Figure> {
  yield* hiddenPage();
  yield firstFrames();
}

/** A server of `ships` ships in contact: its hello, and its frames tick by tick. */
function serverOf(ships: number, tickRate: number) {
  const loaded = value(loadScenario({ ...scenarioNamed('slide'), terrain: 'flat' }));
  const authority = value(
    createAuthority({
      shipClasses: [loaded.shipClass],
      bodies: [loaded.body],
      terrain: 'flat',
      terrains: { flat: loaded.terrainHeight },
      tickRate,
      timeScale: 1,
    }),
  );
  for (const order of fleetOrders(loaded, ships, 3)) authority.spawn(order);
  const hello: ServerMessage = value(authority.join('me', ''))!;
  let tick = 0;
  const next = (): ServerFrame => {
    tick += 1;
    authority.tick(tick / tickRate);
    return authority.frameFor('me')!;
  };
  return { hello, next };
}

/** All frames of the absence are handed over at once, as a frozen page gets them. */
function* hiddenPage(): Generator<Figure> {
  const { hello, next } = serverOf(SHIPS, TICK_RATE);
  const times: number[] = [];
  const grown: number[] = [];
  const before = Array.from({ length: WARM_UP }, next);
  const bytes = encodeServerMessage(next());
  for (let round = 0; round < ROUNDS; round++) {
    const predictor = createPredictor();
    predictor.receive(hello, 0);
    for (const frame of before) show(predictor, frame, frame.tick / TICK_RATE);
    const last = before.at(-1)!;
    const newest = encodeServerMessage({ ...last, tick: last.tick + HIDDEN * TICK_RATE });
    gc();
    const heap = memory();
    const began = performance.now();
    const now = last.tick / TICK_RATE + HIDDEN;
    for (let i = 1; i < HIDDEN * TICK_RATE; i++) predictor.receivePending(pendingServerMessage(bytes), now);
    predictor.receivePending(pendingServerMessage(newest), now);
    predictor.advance(null, now);
    predictor.view(now);
    times.push(performance.now() - began);
    grown.push((memory() - heap) / BYTES_PER_MEGABYTE);
  }
  const name = `a page hidden for ${HIDDEN / 60} minutes, ${SHIPS} ships at ${TICK_RATE} Hz: back`;
  const [time, most] = [Math.min(...times), Math.min(...grown)];
  yield { name, unit: 'ms', value: time, target: '≤ 200', met: time <= 200, timing: true };
  yield { name: `${name}, memory`, unit: 'MB', value: most, target: '≤ 50', met: most <= 50, timing: true };
}

/** The first three seconds with the most ships: the longest call. */
function firstFrames(): Figure {
  const { hello, next } = serverOf(MOST_SHIPS, 1);
  const frames = [next(), next(), next()];
  const longest: number[] = [];
  for (let round = 0; round < ROUNDS; round++) {
    const predictor = createPredictor();
    predictor.receive(hello, 0);
    gc();
    let worst = 0;
    const time = (call: () => void) => {
      const began = performance.now();
      call();
      worst = Math.max(worst, performance.now() - began);
    };
    for (const frame of frames) {
      time(() => {
        predictor.receive(frame, frame.tick);
      });
      for (let k = 1; k <= 20; k++) {
        time(() => {
          predictor.advance(null, frame.tick + k / 60);
        });
        time(() => predictor.view(frame.tick + k / 60));
      }
    }
    longest.push(worst);
  }
  const least = Math.min(...longest);
  const name = `${MOST_SHIPS} ships: the longest of receive, advance and view in the first three seconds`;
  const note = `the value is that of the quietest of ${ROUNDS} runs`;
  return { name, unit: 'ms', value: least, target: '≤ 100', met: least <= 100, timing: true, note };
}

function show(predictor: Predictor, frame: ServerFrame, now: number): void {
  predictor.receive(frame, now);
  predictor.advance(null, now);
  predictor.view(now);
}

function gc(): void {
  (globalThis as { gc?: () => void }).gc?.();
}

function memory(): number {
  const { heapUsed, external } = process.memoryUsage();
  return heapUsed + external;
}
