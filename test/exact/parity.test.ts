import { describe, expect, it } from 'vitest';
import { differences, playDrawnCases, replaySpread } from './bothSides';
import { hashCase } from './compare';
import { fewestOf } from './cases/coverage';
import { HAS_PYTHON, MAY_SKIP, replayInPython, surveyInPython } from './python';
import { recordedCases, scenarioCases } from './scenarioData';
import { heightmapPoints, heightsHere, surveyMaps, surveyPoints } from './survey';

const withPython = !HAS_PYTHON && MAY_SKIP ? it.skip : it;
if (!HAS_PYTHON)
  console.warn('no python3 of at least 3.10: the comparison with the Python server is skipped');

/** A tenth of what `npm run test:long` compares. */
const SUBSTEPS = 100_000;

describe('TypeScript and Python agree in every bit', () => {
  withPython.each([
    ['scenario', scenarioCases(), 18],
    ['recorded trajectory', recordedCases(), 28],
  ] as const)('over every substep of every %s', async (_, cases, atLeast) => {
    const ours = cases.map((exact) => hashCase(exact));
    const theirs = await replayInPython(cases);
    expect(await differences(cases, ours, theirs)).toEqual([]);
    expect(theirs).toEqual(ours);
    expect(cases.length).toBeGreaterThanOrEqual(atLeast);
  });

  withPython('in the height of every terrain', async () => {
    const points = surveyPoints();
    const ours = heightsHere(points);
    const theirs = await surveyInPython(points);
    const first = points.find((_, i) => ours[i] !== theirs[i]);
    expect(first, 'the first point whose heights differ').toBeUndefined();
    expect(new Set(ours).size).toBeGreaterThan(0.8 * points.length);
  });

  withPython('in the height of every point of a heightmap', async () => {
    const points = heightmapPoints();
    const ours = heightsHere(points);
    const theirs = await surveyInPython(points, undefined, surveyMaps());
    const first = points.find((_, i) => ours[i] !== theirs[i]);
    expect(first, 'the first point whose heights differ').toBeUndefined();
    expect(theirs.length).toBe(points.length);
    expect(new Set(ours).size).toBeGreaterThan(0.8 * points.length);
  });

  withPython(`over ${SUBSTEPS} substeps of cases drawn by a seed`, async () => {
    const { cases, ours, coverage } = playDrawnCases(SUBSTEPS);
    const theirs = await replaySpread(cases);
    expect(await differences(cases, ours, theirs)).toEqual([]);
    expect(theirs).toEqual(ours);
    expect(fewestOf(coverage, 'state'), 'substeps in each state with each mode').toBeGreaterThan(100);
    expect(fewestOf(coverage, 'event'), 'each event').toBeGreaterThan(0);
  });
});
