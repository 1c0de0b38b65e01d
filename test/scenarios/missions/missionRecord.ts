import {
  loadScenario,
  type Mission,
  padPlaces,
  type RunOutcome,
  runScenario,
  scoreRun,
} from '../../../src/scenarios';
import { valueOf } from '../../authority/moon';

/** Seconds of the flight without a pilot that the record covers. */
const FLOWN = 3;

/** The data that a race link relies on: the link has only inputs, and is invalid if they lead to another flight or score. */
export interface MissionRecord {
  /** Longest flight that is scored, s. */
  readonly duration: number;
  /** Hash of the flight's start without a pilot. */
  readonly start: string;
  /** Body axes, m, to the millimetre. */
  readonly pads: readonly (readonly number[])[];
  /** Sum of the scores of landings from perfect to poor. */
  readonly points: number;
}

const GOOD: RunOutcome = {
  outcome: 'landed',
  seconds: 0,
  padsReached: 1,
  touchSpeed: 0,
  distance: 0,
  tilt: 0,
  fuelUsed: 0,
  hasTipped: false,
  track: new Float64Array(0),
};

export function recordOf(mission: Mission): MissionRecord {
  const { hash } = valueOf(runScenario({ ...mission.scenario, duration: FLOWN }));
  let points = 0;
  for (let n = 0; n < 400; n++) {
    points += scoreRun(mission, { ...GOOD, seconds: 2 * n }).total;
    points += scoreRun(mission, { ...GOOD, fuelUsed: 5 * n, touchSpeed: n / 40 }).total;
    points += scoreRun(mission, { ...GOOD, distance: n / 4, tilt: n / 10 }).total;
  }
  const pads = padPlaces(mission, valueOf(loadScenario(mission.scenario))).map((place) =>
    place.map((metres) => Math.round(1000 * metres) / 1000),
  );
  return { duration: mission.scenario.duration, start: hash.toString(16), pads, points };
}
