import type { Mission } from '../../../scenarios';
import type * as BestRunsModule from './bestRuns';
import type { BestRuns } from './bestRuns';
import { BEST_RUN_KEY } from './runText';

/** Replays and scores runs: loaded once a run was flown, stored or received. */
export interface Runs {
  /** Whether a best run of a mission is stored in this browser. */
  readonly isKept: (mission: Mission) => boolean;
  readonly load: () => Promise<LoadedRuns>;
}

export interface LoadedRuns {
  readonly module: typeof BestRunsModule;
  readonly best: BestRuns;
}

export function createRuns(store: Storage | null): Runs {
  let loading: Promise<LoadedRuns> | null = null;
  let isFlown = false;
  return {
    isKept(mission) {
      try {
        return isFlown || (store?.getItem(BEST_RUN_KEY + mission.scenario.name) ?? null) !== null;
      } catch {
        return isFlown;
      }
    },
    load() {
      isFlown = true;
      loading ??= import('./bestRuns').then((module) => ({ module, best: module.createBestRuns(store) }));
      loading.catch(() => (loading = null));
      return loading;
    },
  };
}
