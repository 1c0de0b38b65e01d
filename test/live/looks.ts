/** A page's drawn ships, from its recording, compared with the service's states. */
import { createPredictor, type Diagnosis } from '../../src/prediction';
import type { RecordingEntry } from '../../src/scenarios';
import type { ServiceStates } from './serviceStates';

/** Wall s after the first state of a fall, or a step of the present; the drawn ships ease after either (PREDICTION, Drawing). */
const EASED = 1;
/** Rate of the present above which it has stepped, and the slack of a look's time, wall s. */
const STEP = { rate: 1.1, slack: 0.002 } as const;

/** A bounce between two ticks. */
export interface Bounce {
  readonly rate: number;
  readonly first: number;
  readonly last: number;
}

export interface Look {
  readonly at: number;
  readonly tick: number;
  readonly sinceTick: number;
  readonly corrections: number;
  readonly ships: readonly {
    readonly shipId: string;
    readonly state: string;
    readonly position: readonly number[];
  }[];
}

const correctionsOf = (diagnosis: Diagnosis) =>
  diagnosis.correctionsMismatch + diagnosis.correctionsLateInput + diagnosis.correctionsLostInput;

/** Everything that the page drew, from its recording: a predictor with the same input draws the same. */
export function looksOf(entries: readonly RecordingEntry[], ownShipId: string): Look[] {
  const predictor = createPredictor();
  predictor.setOwnShip(ownShipId);
  const looks: Look[] = [];
  for (const entry of entries) {
    if (entry.kind === 'received') predictor.receive(entry.message, entry.at);
    if (entry.kind !== 'advanced') continue;
    predictor.advance(entry.controls, entry.at);
    predictor.takeOutgoing();
    const { tick, sinceTick, ships, diagnosis } = predictor.view(entry.at);
    looks.push({
      at: entry.at,
      tick,
      sinceTick,
      corrections: correctionsOf(diagnosis),
      ships: ships.map(({ shipId, surfaceContactState: state, easedPosition }) => ({
        shipId,
        state,
        position: [...easedPosition],
      })),
    });
  }
  return looks;
}

/**
 * The looks at which nothing is eased after a step of the present. A service that stalls for lack of CPU time makes the present wait;
 * when it resumes, the present steps to it (0.2 s at 10 m/s is 2 m), and the drawn ships ease after it.
 */
function withoutSteps(looks: readonly Look[], rate: number): Look[] {
  const presentOf = ({ tick, sinceTick }: Look) => tick / rate + sinceTick;
  let steppedAt = -Infinity;
  return looks.filter((look, i) => {
    const before = looks[i - 1] ?? look;
    const most = STEP.rate * (look.at - before.at) + STEP.slack;
    if (presentOf(look) - presentOf(before) > most) steppedAt = look.at;
    return look.at > steppedAt + EASED;
  });
}

/** The samples of a bounce, from a second after both ships were first seen falling. */
export function looksAt(looks: readonly Look[], { rate, first, last }: Bounce): Look[] {
  const during = withoutSteps(looks, rate).filter(({ tick }) => tick > first && tick < last);
  const falling = during.find(({ ships }) => ships.length === 2 && ships.every(({ state }) => state === ''));
  return during.filter(({ at }) => falling !== undefined && at > falling.at + EASED);
}

/** Distances between drawn and true positions of both ships, m, ascending. */
export function errorsOf(looks: readonly Look[], states: ServiceStates): number[] {
  return looks
    .flatMap((look) =>
      look.ships.map(({ shipId, position }) => {
        const truth = states.positionAt(shipId, look);
        return truth === null ? NaN : Math.hypot(...truth.map((value, k) => value - position[k]!));
      }),
    )
    .filter((error) => !Number.isNaN(error))
    .sort((a, b) => a - b);
}
