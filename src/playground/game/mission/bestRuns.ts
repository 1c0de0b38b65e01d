export { scoreCard, verdict } from './scoreCard';
export type { VerifiedRun } from './verifiedRun';
import {
  findMission,
  flyRun,
  meetsGoal,
  type Mission,
  readRun,
  type RunInput,
  scoreRun,
  loadScenario,
  writeRun,
} from '../../../scenarios';
import { BEST_RUN_KEY, bytesOf, textOf } from './runText';
import type { VerifiedRun } from './verifiedRun';

/** Replays the inputs, encoded and decoded as in a link; null if they are not a run. */
export function verifyRun(mission: Mission, inputs: readonly RunInput[], by = ''): VerifiedRun | null {
  return verifyBytes(mission, writeRun(inputs, substepsOf(mission)), by);
}

function verifyBytes(mission: Mission, bytes: Uint8Array, by: string): VerifiedRun | null {
  const read = readRun(bytes, substepsOf(mission));
  if (!read.ok) return null;
  const outcome = flyRun(mission, read.value);
  if (!outcome.ok) return null;
  return {
    mission,
    bytes,
    outcome: outcome.value,
    score: scoreRun(mission, outcome.value),
    meetsGoal: meetsGoal(mission, outcome.value),
    by,
  };
}

function substepsOf({ scenario }: Mission): number {
  const loaded = loadScenario(scenario);
  return loaded.ok ? loaded.value.timing.substeps : 100;
}

export interface BestRuns {
  /** The best run of a mission, replayed; null without one. */
  readonly of: (mission: Mission) => VerifiedRun | null;
  /** Stores a run if it is better than the best. Returns whether it is. */
  readonly keep: (run: VerifiedRun) => boolean;
}

/** One best run per mission, stored in this browser as text. */
export function createBestRuns(store: Storage | null): BestRuns {
  const known = new Map<string, VerifiedRun | null>();
  const of = (mission: Mission): VerifiedRun | null => {
    const { name } = mission.scenario;
    if (!known.has(name)) known.set(name, readBest(store, mission));
    return known.get(name) ?? null;
  };
  return {
    of,
    keep(run) {
      const best = of(run.mission);
      if (best !== null && best.score.total >= run.score.total) return false;
      if (run.outcome.outcome !== 'landed') return false;
      known.set(run.mission.scenario.name, run);
      try {
        store?.setItem(BEST_RUN_KEY + run.mission.scenario.name, textOf(run.bytes));
      } catch {
        // A full or forbidden store: the best run holds until the page closes.
      }
      return true;
    },
  };
}

function readBest(store: Storage | null, mission: Mission): VerifiedRun | null {
  try {
    const text = store?.getItem(BEST_RUN_KEY + mission.scenario.name) ?? null;
    const bytes = text === null ? null : bytesOf(text);
    const run = bytes === null ? null : verifyBytes(mission, bytes, '');
    return run?.outcome.outcome === 'landed' ? run : null;
  } catch {
    return null;
  }
}

const MAX_NAME_LENGTH = 24;

/** The part of an address that lets a friend race a run. */
export function raceQuery(run: VerifiedRun, by: string): string {
  const query = new URLSearchParams({ scenario: run.mission.scenario.name, run: textOf(run.bytes) });
  if (by !== '') query.set('by', by.slice(0, MAX_NAME_LENGTH));
  return `?${query.toString()}`;
}

/** A friend's run in the page's address, verified by replaying it; or the reason why it cannot be; null without one. */
export function readRace(query: URLSearchParams): VerifiedRun | string | null {
  const text = query.get('run');
  if (text === null) return null;
  const mission = findMission(query.get('scenario') ?? '');
  if (mission === null) return 'run: the link names no mission in scenario=';
  const bytes = bytesOf(text);
  const run =
    bytes === null
      ? null
      : verifyBytes(mission, bytes, (query.get('by') ?? 'a friend').slice(0, MAX_NAME_LENGTH));
  return run ?? 'run: invalid inputs';
}
