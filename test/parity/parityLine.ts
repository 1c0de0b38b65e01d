import { agrees, compareFixture, type Comparison, readFixture } from '../../src/rehearsal';

/** One file's outcome as `npm run parity` prints it. */
export function parityLine(name: string, text: string): { line: string; passed: boolean } {
  const fixture = readFixture(text);
  if (!fixture.ok) return { line: `${name}: ${fixture.reason}`, passed: false };
  const compared = compareFixture(fixture.value);
  if (!compared.ok) return { line: `${name}: ${compared.reason}`, passed: false };
  return { line: describe(name, compared.value), passed: agrees(compared.value) };
}

export function describe(name: string, comparison: Comparison): string {
  const { worst, outOfTolerance, disagreement, ticks, statesCompared } = comparison;
  const columns = [
    name.padEnd(28),
    `position ${number(worst.relativePosition)} m`,
    `velocity ${number(worst.relativeVelocity)} m/s`,
    `attitude ${number(worst.attitude)}`,
    `spin ${number(worst.angularVelocity)} rad/s`,
    `fuel ${number(worst.fuel)} kg`,
    `impact ${number(worst.impactSpeed)} m/s`,
    disagreement === null
      ? 'states and events agree'
      : `FIRST DISAGREEMENT tick ${disagreement.tick}: ${disagreement.how}`,
    `(${statesCompared} states over ${ticks} ticks)`,
  ];
  if (outOfTolerance !== null)
    columns.push(`OUT OF TOLERANCE: ${outOfTolerance.field} from tick ${outOfTolerance.tick}`);
  return columns.join('  ');
}

function number(value: number): string {
  return value === 0 ? '0'.padEnd(7) : value.toExponential(1).padEnd(7);
}
