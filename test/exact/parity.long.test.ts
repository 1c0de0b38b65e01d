import { describe, expect, it } from 'vitest';
import { differences, playDrawnCases, replaySpread } from './bothSides';
import { fewestOf } from './cases/coverage';
import { HAS_PYTHON, MAY_SKIP } from './python';

const SUBSTEPS = 1_000_000;

describe.skipIf(!HAS_PYTHON && MAY_SKIP)('TypeScript and Python agree in every bit', () => {
  it(`over ${SUBSTEPS} substeps of random cases`, async () => {
    const { cases, ours, coverage } = playDrawnCases(SUBSTEPS);
    const theirs = await replaySpread(cases);
    expect(await differences(cases, ours, theirs)).toEqual([]);
    expect(theirs).toEqual(ours);

    // The coverage of the cases, without which agreement would prove little.
    expect(fewestOf(coverage, 'state'), 'substeps in each state with each mode').toBeGreaterThan(2000);
    expect(fewestOf(coverage, 'event'), 'each event').toBeGreaterThan(40);
    expect(fewestOf(coverage, 'world'), 'substeps over each ground').toBeGreaterThan(50_000);
    expect(fewestOf(coverage, 'change'), 'changes of body, fuel run out, launches').toBeGreaterThan(20);
    expect(fewestOf(coverage, 'tilt'), 'substeps at each tilt').toBeGreaterThan(5000);
    expect(Math.min(...coverage.tickRates), 'lowest tick rate').toBe(0.1);
    expect(Math.max(...coverage.tickRates), 'highest tick rate').toBe(100);
    expect(Math.min(...coverage.timeScales), 'lowest time scale').toBe(0.1);
    expect(Math.max(...coverage.timeScales), 'highest time scale').toBe(100);
  });
});
