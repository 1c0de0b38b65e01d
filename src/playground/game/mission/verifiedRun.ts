import type { Mission, RunOutcome, Score } from '../../../scenarios';

/** A run replayed from its inputs: its outcome and its score. */
export interface VerifiedRun {
  readonly mission: Mission;
  readonly bytes: Uint8Array;
  readonly outcome: RunOutcome;
  readonly score: Score;
  /** Whether it meets the goal. */
  readonly meetsGoal: boolean;
  /** Name of its pilot; '' for this browser's. */
  readonly by: string;
}
