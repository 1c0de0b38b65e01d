/** The totals of vitest's JSON report. */
export interface Report {
  readonly numPassedTests: number;
  readonly numFailedTests: number;
  readonly numPendingTests: number;
  readonly numTodoTests: number;
  readonly success: boolean;
}
export function verdictOf(reports: readonly Report[]): { line: string; complaint: string | null };
