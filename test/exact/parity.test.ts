import { availableParallelism } from 'node:os';
import { describe, expect, it } from 'vitest';
import { ATTITUDE_MODES, EVENT_NAMES, SURFACE_STATES } from '../../src/dynamics';
import { firstDifference, hashCase } from './compare';
import { createCoverage } from './coverage';
import { drawCase } from './drawCase';
import type { ExactCase } from './exactCase';
import { MAY_SKIP, type PythonResult, pythonVersion, replayInPython, surveyInPython } from './python';
import { recordedCases, rehearsalCases } from './scenarioData';
import { heightsHere, surveyPoints } from './survey';

const python = pythonVersion();
const withPython = python === null && MAY_SKIP ? it.skip : it;
if (python === null)
  console.warn('no python3 of at least 3.10: the comparison with the Python server is skipped');

const RANDOM_SUBSTEPS = 1_000_000;
const MINUTES = 60_000;

/** Plays the cases in as many Python processes as there are cores; results in the cases' order. */
async function replaySpread(cases: readonly ExactCase[]): Promise<PythonResult[]> {
  const shares = Math.min(4, availableParallelism());
  const share = (k: number) => cases.filter((_, i) => i % shares === k);
  const played = await Promise.all(Array.from({ length: shares }, (_, k) => replayInPython(share(k))));
  return cases.map((_, i) => played[i % shares]![Math.floor(i / shares)]!);
}

/** Of the first cases that differ, where. */
async function differences(
  cases: readonly ExactCase[],
  ours: readonly PythonResult[],
  theirs: readonly PythonResult[],
): Promise<(string | null)[]> {
  const differing = cases.filter((_, i) => ours[i]!.hash !== theirs[i]?.hash);
  return Promise.all(differing.slice(0, 3).map((exact) => firstDifference(exact)));
}

describe('TypeScript and Python agree in every bit', () => {
  withPython.each([
    ['rehearsal', rehearsalCases(), 18],
    ['recorded trajectory', recordedCases(), 28],
  ] as const)(
    'over every substep of every %s',
    async (_, cases, atLeast) => {
      const ours = cases.map((exact) => hashCase(exact));
      const theirs = await replayInPython(cases);
      expect(await differences(cases, ours, theirs)).toEqual([]);
      expect(theirs).toEqual(ours);
      expect(cases.length).toBeGreaterThanOrEqual(atLeast);
    },
    2 * MINUTES,
  );

  withPython('in the height of every terrain', async () => {
    const points = surveyPoints();
    const ours = heightsHere(points);
    const theirs = await surveyInPython(points);
    const first = points.find((_, i) => ours[i] !== theirs[i]);
    expect(first, 'the first point whose heights differ').toBeUndefined();
    expect(new Set(ours).size).toBeGreaterThan(0.8 * points.length);
  });

  withPython(
    `over ${RANDOM_SUBSTEPS} substeps of cases drawn by a seed`,
    async () => {
      const cases: ExactCase[] = [];
      const ours: PythonResult[] = [];
      const coverage = createCoverage();
      for (let seed = 1, substeps = 0; substeps < RANDOM_SUBSTEPS; seed++) {
        const exact = drawCase(seed);
        const result = hashCase(exact, coverage.follow(exact));
        cases.push(exact);
        ours.push(result);
        substeps += result.substeps;
      }
      const theirs = await replaySpread(cases);
      expect(await differences(cases, ours, theirs)).toEqual([]);
      expect(theirs).toEqual(ours);

      // What the cases have been through: an agreement on what never happens would say little.
      const { counts } = coverage;
      const rarest = (prefix: string, keys: readonly string[]) =>
        Math.min(...keys.map((key) => counts.get(`${prefix} ${key}`) ?? 0));
      const states = SURFACE_STATES.flatMap((state) => ATTITUDE_MODES.map((mode) => `${state}/${mode}`));
      expect(rarest('state', states), 'substeps in each state with each mode').toBeGreaterThan(2000);
      expect(rarest('event', EVENT_NAMES.slice(1)), 'each event').toBeGreaterThan(40);
      expect(rarest('world', ['aligned', 'kept', 'flat', 'hills', 'bowl']), 'substeps').toBeGreaterThan(
        50_000,
      );
      expect(rarest('change', ['reference body']), 'changes of reference body').toBeGreaterThan(20);
      expect(rarest('change', ['ran dry', 'launched']), 'ran out of fuel, launched').toBeGreaterThan(20);
      expect(rarest('tilt', ['under 5', 'to 90', 'past 90', 'overhead']), 'substeps').toBeGreaterThan(5000);
      expect(Math.min(...coverage.tickRates), 'lowest tick rate').toBe(0.1);
      expect(Math.max(...coverage.tickRates), 'highest tick rate').toBe(100);
      expect(Math.min(...coverage.timeScales), 'lowest time scale').toBe(0.1);
      expect(Math.max(...coverage.timeScales), 'highest time scale').toBe(100);
    },
    10 * MINUTES,
  );
});
