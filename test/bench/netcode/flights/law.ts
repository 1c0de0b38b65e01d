import { correctionsOf, type Flight, flyMeasured } from './flights';
import { type Figure, spread } from '../figure';
import { createSeededPilot } from './pilots';
import { NETWORK_PRESETS } from '../../../../src/scenarios';
import type { ClientMessage } from '../../../../src/wire';
import { createRandom } from '../../../../src/scenarios';

const COASTING = ['settle', 'bounce', 'slide', 'topple', 'crash'];
const FLOWN = ['right-itself', 'launch', 'opening'];

/** Drawn state relative to the server's true state at the (tick, substep) of the view's label. */
export function* lawFigures(): Generator<Figure> {
  yield* coasting();
  yield* ownInTime();
  yield* ownLate();
  yield* gamesOwnServer();
}

function* coasting(): Generator<Figure> {
  const flights = COASTING.map((scenario) => flyMeasured({ scenario }, 25));
  const drawn = spread(flights.flatMap(({ measures }) => measures.map((m) => m.drawn)));
  yield {
    name: 'law, coasting ship: drawn − server',
    unit: 'm',
    ...drawn,
    target: 'max ≤ 1e-6',
    met: drawn.max <= 1e-6,
    note: `${COASTING.join(', ')}; 1 Hz, 4G`,
  };
  const corrections = flights.reduce((sum, flight) => sum + correctionsOf(flight), 0);
  yield count('law, coasting ship: corrections', corrections, 0);
  yield count('states shown that the server never had, coasting', flights.reduce(sumWrong, 0), 0);

  let worst = 0;
  let wrong = 0;
  let corrected = 0;
  let flown = 0;
  for (const scenario of [...COASTING, ...FLOWN]) {
    for (const tickRate of [1, 5, 20]) {
      for (const timeScale of [1, 10]) {
        const flight = flyMeasured({ scenario, tickRate, timeScale }, 25 / timeScale + 2);
        for (const m of flight.measures) worst = Math.max(worst, m.drawn);
        wrong += sumWrong(0, flight);
        corrected += correctionsOf(flight) - flight.rig.view().diagnosis.correctionsLateInput;
        flown += 1;
      }
    }
  }
  const note = `${flown} flights: 8 scenarios at 1, 5, 20 Hz, time scale 1 and 10, 4G`;
  yield { ...count('law, all server rates: corrections without a late input', corrected, 0), note };
  yield count('states shown that the server never had, all server rates', wrong, 0);
}

function* ownInTime(): Generator<Figure> {
  let inTime = 0;
  let corrections = 0;
  let late = 0;
  let applied = 0;
  const drawn: number[] = [];
  for (let seed = 1; seed <= 6; seed++) {
    const flight = flyPilot(seed, undefined);
    const { counters } = flight.rig.authority;
    late += counters.inputsLate;
    applied += counters.inputsApplied;
    if (counters.inputsLate > 0) continue;
    inTime += 1;
    corrections += correctionsOf(flight);
    drawn.push(...flight.measures.map((m) => m.drawn));
  }
  yield {
    ...count('law, own ship, inputs in time: corrections', corrections, 0),
    met: corrections === 0 && inTime > 0,
    note: `${inTime} of 6 flights of a minute had no late input; ${late} of ${applied} inputs were late by 4G itself`,
  };
  const errors = spread(drawn);
  yield {
    name: 'law, own ship, inputs in time: drawn − server',
    unit: 'm',
    ...errors,
    target: 'max ≤ 1e-6',
    met: errors.max <= 1e-6,
  };
}

function* ownLate(): Generator<Figure> {
  const drawn: number[] = [];
  const counters = { late: 0, other: 0, applied: 0, lateInputs: 0 };
  for (let seed = 1; seed <= 6; seed++) {
    const flight = flyPilot(seed, 0.1);
    const { diagnosis } = flight.rig.view();
    counters.late += diagnosis.correctionsLateInput;
    counters.other += correctionsOf(flight) - diagnosis.correctionsLateInput;
    counters.lateInputs += flight.rig.authority.counters.inputsLate;
    counters.applied += flight.rig.authority.counters.inputsApplied;
    drawn.push(...flight.measures.map((m) => m.drawn));
  }
  const errors = spread(drawn);
  const share = ((100 * counters.lateInputs) / counters.applied).toFixed(1);
  yield {
    name: 'law, own ship, 10 % of inputs late: drawn − server',
    unit: 'm',
    ...errors,
    target: 'p99 ≤ 0.3',
    met: errors.p99 <= 0.3,
    note: `${counters.lateInputs} of ${counters.applied} inputs late (${share} %), by 20 to 200 ms past the server’s last moment for them`,
  };
  yield {
    ...count('law, own ship, 10 % of inputs late: corrections not classified late', counters.other, 0),
    note: `${counters.late} classified late`,
  };
}

/** The game's own server: no hello, no acknowledgements, no fields 31–34, whole-tick inputs. */
function* gamesOwnServer(): Generator<Figure> {
  const flights = COASTING.map((scenario) => flyMeasured({ scenario, legacy: true }, 25));
  const drawn = spread(flights.flatMap(({ measures }) => measures.map((m) => m.drawn)));
  yield {
    name: 'the game’s own server, coasting: drawn − server',
    unit: 'm',
    ...drawn,
    target: 'p99 ≤ 0.01',
    met: drawn.p99 <= 0.01,
    note: `${flights.reduce((sum, flight) => sum + correctionsOf(flight), 0)} corrections`,
  };
  yield count('the game’s own server, coasting: states it never had', flights.reduce(sumWrong, 0), 0);
}

/** A minute of an active pilot over the Moon; `lateShare` of the inputs are held until the server has simulated their substep. */
export function flyPilot(
  seed: number,
  lateShare: number | undefined,
  network = NETWORK_PRESETS.fourG,
): Flight {
  const pilot = createSeededPilot(100 + seed);
  const rng = createRandom(500 + seed);
  const holdBack = (message: ClientMessage, now: number) => {
    if (message.kind !== 'inputs' || lateShare === undefined || rng() >= lateShare) return now;
    return message.inputs[0]!.tick + 1 - network.delay + 0.02 + 0.18 * rng();
  };
  return flyMeasured({ scenario: 'slide', seed, network, pilot: (game) => pilot.at(game), holdBack }, 62);
}

function sumWrong(sum: number, { measures }: Flight): number {
  return sum + measures.filter(({ sample, truth }) => sample.state !== truth.state).length;
}

function count(name: string, value: number, target: number): Figure {
  return { name, unit: '', value, target: String(target), met: value <= target };
}
