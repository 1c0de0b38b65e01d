import { describe, expect, it } from 'vitest';
import { beginTick, endTick, hashRows, SHIP_STRIDE, stepWorld, timingOfTick } from '../../src/dynamics';
import { compileReference, landingOf, type Reference, REFERENCES } from '../bench/cBaseline';
import { flying, landed, sliding, type Subject, tipped } from '../bench/subjects';
import { type Landing, runReference } from '../bench/cReference/landing';
import { drawCase } from './cases/drawCase';
import type { ExactCase } from './cases/exactCase';
import { BODY_ROW, caseTerrain, loadCase, playCase, SHIP_ROW, writeBodyRow } from './cases/playCase';

// The bench compares the law with its C references: that is meaningful only when all compute the same.
const programs = REFERENCES.map((reference) => [reference, compileReference(reference)] as const);
if (programs.some(([, program]) => program === null))
  console.warn('no C compiler: the law is not compared with its C references');

function toLanding(exact: ExactCase): Landing {
  const loaded = loadCase(exact, caseTerrain(exact.terrain));
  if (!loaded.ok) throw new Error(loaded.reason);
  const { ship, ...rest } = loaded.value;
  return { ...rest, ships: ship, ticks: exact.ticks, terrain: exact.terrain };
}

/** What main.c prints: the substeps, and the hash of all rows. */
function here(exact: ExactCase): string {
  let hash: number | undefined;
  const played = playCase(exact, (row) => {
    hash = hashRows(row, hash);
  });
  if (!played.ok) throw new Error(played.reason);
  return lineOf(played.value, hash ?? 0);
}

function lineOf(substeps: number, hash: number): string {
  return `${substeps} ${hash.toString(16).padStart(8, '0')}`;
}

describe.each(programs)('C reference, %s', (reference: Reference, program: string | null) => {
  it('is left out where no compiler is found', () => {
    expect(compileReference(reference, ['no-such-compiler'])).toBeNull();
  });

  if (program !== null) agreesInEveryBit(program);
});

/** Random cases and what the law makes of them: played once, for all references. */
let played: { readonly cases: readonly ExactCase[]; readonly ours: readonly string[] } | undefined;
function playRandomCases(): NonNullable<typeof played> {
  if (played === undefined) {
    const cases = Array.from({ length: 400 }, (_, i) => drawCase(i + 1)).filter(
      ({ terrain }) => !('name' in terrain && terrain.name === 'hills'),
    );
    played = { cases, ours: cases.map(here) };
  }
  return played;
}

function agreesInEveryBit(program: string): void {
  it('agrees in every bit over 200,000 substeps of random cases', () => {
    const { cases, ours } = playRandomCases();
    const lines = runReference(program, ['replay'], cases.map(toLanding));
    expect(ours.filter((line, i) => line !== lines[i])).toEqual([]);
    expect(lines).toHaveLength(cases.length);
    const substeps = lines.reduce((sum, line) => sum + Number(line.split(' ')[0]), 0);
    expect(substeps).toBeGreaterThan(200_000);
  });

  it.each([
    ['sliding', sliding],
    ['flying', flying],
    ['tipped', tipped],
    ['landed', landed],
  ] satisfies [string, () => Subject][])(
    'agrees in every bit on the benchmark subject: %s',
    (_, subjectOf) => {
      const ticks = 50;
      const subject = subjectOf();
      const [line] = runReference(program, ['replay'], [landingOf(subject, ticks)]);
      expect(line).toBe(lineOf(ticks, playSubject(subject, ticks)));
    },
  );
}

/** Steps a subject as a case of one-substep ticks is stepped, and hashes the same rows. */
function playSubject({ world, ships, bodies }: Subject, ticks: number): number {
  const row = new Float64Array(SHIP_ROW);
  const bodyRow = new Float64Array(BODY_ROW);
  const events = new Uint8Array(1);
  const timing = timingOfTick(0.01, 0.01);
  let hash: number | undefined;
  for (let tick = 0; tick < ticks; tick++) {
    beginTick(ships, bodies, world);
    stepWorld(ships, bodies, events, world, timing.dt);
    row.set(ships);
    row[SHIP_STRIDE] = events[0]!;
    endTick(bodies, world, timing);
    writeBodyRow(bodyRow, bodies, 0);
    hash = hashRows(bodyRow, hashRows(row, hash));
  }
  return hash ?? 0;
}
