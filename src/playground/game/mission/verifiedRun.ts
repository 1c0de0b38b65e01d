import type { Mission, RunOutcome, Score } from '../../../scenarios';

/** A run that was flown again from its inputs: what it came to and what it was worth. */
export interface VerifiedRun {
  readonly mission: Mission;
  readonly bytes: Uint8Array;
  readonly outcome: RunOutcome;
  readonly score: Score;
  /** As softly as the goal says. */
  readonly meetsGoal: boolean;
  /** Whose; '' = one's own. */
  readonly by: string;
}
