/** Plays the same cases in TypeScript and Python. */
import { availableParallelism } from 'node:os';
import { firstDifference, hashCase } from './compare';
import { createCoverage } from './cases/coverage';
import type { Coverage } from './cases/coverage';
import { drawCase } from './cases/drawCase';
import type { ExactCase } from './cases/exactCase';
import { replayInPython } from './python';
import type { PythonResult } from './python';

/** Plays cases drawn by the seeds 1, 2, … until they have `substeps` in total. */
export function playDrawnCases(substeps: number): {
  readonly cases: readonly ExactCase[];
  readonly ours: readonly PythonResult[];
  readonly coverage: Coverage;
} {
  const cases: ExactCase[] = [];
  const ours: PythonResult[] = [];
  const coverage = createCoverage();
  for (let seed = 1, played = 0; played < substeps; seed++) {
    const exact = drawCase(seed);
    const result = hashCase(exact, coverage.follow(exact));
    cases.push(exact);
    ours.push(result);
    played += result.substeps;
  }
  return { cases, ours, coverage };
}

/** Plays the cases in as many Python processes as there are cores; results in the cases' order. */
export async function replaySpread(cases: readonly ExactCase[]): Promise<PythonResult[]> {
  const shares = Math.min(4, availableParallelism());
  const share = (k: number) => cases.filter((_, i) => i % shares === k);
  const played = await Promise.all(Array.from({ length: shares }, (_, k) => replayInPython(share(k))));
  return cases.map((_, i) => played[i % shares]![Math.floor(i / shares)]!);
}

/** Where the first differing cases differ. */
export async function differences(
  cases: readonly ExactCase[],
  ours: readonly PythonResult[],
  theirs: readonly PythonResult[],
): Promise<(string | null)[]> {
  const differing = cases.filter((_, i) => ours[i]!.hash !== theirs[i]?.hash);
  return Promise.all(differing.slice(0, 3).map((exact) => firstDifference(exact)));
}
