import {
  agrees,
  compareFixture,
  compareRecording,
  type Comparison,
  readFixture,
  readRecording,
} from '../../src/scenarios';
import type { Result } from '../../src/dynamics';

/** One file's outcome as `npm run parity` prints it: a fixture, or a recording of a server's states if it is JSON lines. */
export function parityLine(name: string, text: string): { line: string; passed: boolean } {
  return name.endsWith('.jsonl') ? recordingLine(name, text) : fixtureLine(name, text);
}

function fixtureLine(name: string, text: string): { line: string; passed: boolean } {
  const compared = then(readFixture(text), compareFixture);
  if (!compared.ok) return refusal(name, compared.reason);
  return { line: describe(name, compared.value), passed: agrees(compared.value) };
}

function recordingLine(name: string, text: string): { line: string; passed: boolean } {
  const compared = then(readRecording(text), compareRecording);
  if (!compared.ok) return refusal(name, compared.reason);
  const { unknownInputs, withoutRelativeState } = compared.value;
  const left = `not comparable: ${unknownInputs} by inputs, ${withoutRelativeState} without relative state`;
  return { line: `${describe(name, compared.value)}  ${left}`, passed: agrees(compared.value) };
}

/** All faults of a file that cannot be read, one per line. */
function refusal(name: string, reason: string): { line: string; passed: boolean } {
  const faults = reason.split('\n');
  const line = faults.length === 1 ? `${name}: ${reason}` : `${name}:\n  ${faults.join('\n  ')}`;
  return { line, passed: false };
}

function then<A, B>(checked: Result<A>, next: (value: A) => Result<B>): Result<B> {
  return checked.ok ? next(checked.value) : checked;
}

function describe(name: string, comparison: Comparison): string {
  const { worst, outOfTolerance, disagreement, ticks, statesCompared } = comparison;
  const columns = [
    name.padEnd(48),
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
  if (outOfTolerance !== null) columns.push(`OUT OF TOLERANCE: ${deviationText(outOfTolerance)}`);
  return columns.join('  ');
}

function deviationText({ field, tick, got, expected }: NonNullable<Comparison['outOfTolerance']>): string {
  return `${field} from tick ${tick}: here ${String(got)}, in the file ${String(expected)}`;
}

function number(value: number): string {
  return value === 0 ? '0'.padEnd(7) : value.toExponential(1).padEnd(7);
}
