import { ok, type Result, loadControls, err, writeControls } from '../../dynamics';
import type { ScheduledInput } from './scheduledInput';
import { rowOf, type ShipTable } from './shipTable';

/** Inputs that a ship applies by itself until its player's first input acts. */
export interface Plan {
  readonly inputs: readonly ScheduledInput[];
  next: number;
}

const MAX_PLANNED = 10_000;

/** The checked plan, or a reason that names the field. */
export function loadPlan(given: readonly ScheduledInput[]): Result<Plan> {
  if (given.length > MAX_PLANNED) return err(`plan: expected at most ${MAX_PLANNED}, got ${given.length}`);
  const inputs: ScheduledInput[] = [];
  for (const [i, { tick, substep, controls }] of given.entries()) {
    const before = inputs.at(-1) ?? { tick: 0, substep: 0 };
    const whole = Number.isSafeInteger(tick) && Number.isSafeInteger(substep) && substep >= 0;
    if (!whole || tick < before.tick || (tick === before.tick && substep < before.substep))
      return err(
        `plan[${i}]: expected whole numbers, ascending in time, got tick ${tick} substep ${substep}`,
      );
    const checked = loadControls(controls);
    if (!checked.ok) return err(`plan[${i}].controls.${checked.reason}`);
    inputs.push({ tick, substep, controls: checked.value });
  }
  return ok({ inputs, next: 0 });
}

/** Writes the planned inputs that are due at the start of substep `substep` of the interval of `tick` into the ships' rows. */
export function flyPlans(plans: Map<string, Plan>, table: ShipTable, tick: number, substep: number): void {
  for (const [shipId, plan] of plans) {
    for (let due = plan.inputs[plan.next]; due !== undefined; due = plan.inputs[plan.next]) {
      if (due.tick > tick || (due.tick === tick && due.substep > substep)) break;
      writeControls(table.rows, rowOf(table, shipId), due.controls);
      plan.next += 1;
    }
  }
}
