/** The law's bits as one number per engine: every scenario, and cases drawn by a seed, hashed substep by substep. */
import { hashRows } from '../../src/dynamics';
import { SCENARIOS } from '../../src/scenarios';
import { drawCase } from '../exact/cases/drawCase';
import { caseOf, type ExactCase } from '../exact/cases/exactCase';
import { playCase } from '../exact/cases/playCase';

/**
 * The hash of all trajectories, eight hexadecimal digits; the same in every engine. A change of the law, of a terrain, of a scenario
 * or of the drawing of cases changes it: `npm run engines` prints the new one, to be written here once all engines agree on it.
 */
export const PINNED_HASH = 'd46ab53f';

/** An interpreter needs about 20 s for them and the scenarios; with 250, quickjs-ng 0.32.0 as WebAssembly stopped with a memory access out of bounds. */
const DRAWN_CASES = 60;

/** "name hash" of a case: of every row of its substeps and of the body's after each tick. */
export interface CaseHash {
  readonly name: string;
  readonly hash: number;
  readonly substeps: number;
}

/** Plays everything. @throws if a case cannot be played */
export function caseHashes(): CaseHash[] {
  return hashedCases().map((exact) => {
    let hash: number | undefined;
    const played = playCase(exact, (row) => {
      hash = hashRows(row, hash);
    });
    if (!played.ok) throw new Error(`${exact.name}: ${played.reason}`);
    return { name: exact.name, hash: hash ?? 0, substeps: played.value };
  });
}

/** One hash of all, in the format of PINNED_HASH. */
export function trajectoryHash(hashes: readonly CaseHash[] = caseHashes()): string {
  return hexadecimal(hashRows(Float64Array.from(hashes, ({ hash }) => hash)));
}

export function hexadecimal(hash: number): string {
  return `0000000${hash.toString(16)}`.slice(-8);
}

function hashedCases(): ExactCase[] {
  const scenarios = SCENARIOS.map((scenario) => {
    const exact = caseOf(scenario);
    if (!exact.ok) throw new Error(`${scenario.name}: ${exact.reason}`);
    return exact.value;
  });
  return [...scenarios, ...Array.from({ length: DRAWN_CASES }, (_, i) => drawCase(i + 1))];
}
