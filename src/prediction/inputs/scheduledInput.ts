import { writeControls } from '../../dynamics';
import type { Inputs, ScheduledInput } from './inputs';
import { isBefore, type Position } from '../time/timeline';

/**
 * Inputs of the player's ship in order: its plan until the pilot's first input acts, then the pilot's inputs (PREDICTION, Inputs). A cursor
 * indexes both.
 */

/** The cursor at the first input that acts at or after (tick, substep). */
export function seek({ plan, records }: Inputs, tick: number, substep: number): number {
  let i = records.length;
  while (i > 0 && !isBefore(records[i - 1]!.tick, records[i - 1]!.substep, tick, substep)) i--;
  if (i > 0) return plan.length + i;
  let k = plan.length;
  while (k > 0 && !isBefore(plan[k - 1]!.tick, plan[k - 1]!.substep, tick, substep)) k--;
  return k;
}

/** Writes the inputs due at `due` into the row at `at`, starting at `cursor`. Returns the cursor after them. */
export function applyDue(
  { plan, records }: Inputs,
  cursor: number,
  due: Position,
  rows: Float64Array,
  at: number,
): number {
  let i = cursor;
  if (i < plan.length && records.length > 0 && isDue(records[0]!, due)) i = plan.length;
  for (; i < plan.length; i++) {
    if (!isDue(plan[i]!, due)) return i;
    writeControls(rows, at, plan[i]!.controls);
  }
  for (; i < plan.length + records.length; i++) {
    const stored = records[i - plan.length]!;
    if (!isDue(stored, due)) break;
    writeControls(rows, at, stored.record.controls);
  }
  return i;
}

/** Whether the plan has inputs at or after `from` that no input of the pilot overrides. */
export function isPlanned({ plan, records }: Inputs, from: Position): boolean {
  const last = plan.at(-1);
  return (
    records.length === 0 && last !== undefined && !isBefore(last.tick, last.substep, from.tick, from.substep)
  );
}

function isDue({ tick, substep }: Position | ScheduledInput, due: Position): boolean {
  return !isBefore(due.tick, due.substep, tick, substep);
}

/** Whether an input acts on the player's ship from tick boundary `from` to before tick boundary `to`. */
export function actsBetween({ plan, records }: Inputs, from: number, to: number): boolean {
  const isBetween = ({ tick, substep }: Position): boolean =>
    !isBefore(tick, substep, from, 0) && isBefore(tick, substep, to, 0);
  return records.some(isBetween) || plan.some(isBetween);
}
