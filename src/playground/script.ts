import { type Controls, NEUTRAL_CONTROLS } from '../dynamics';
import type { WorldView } from '../prediction';
import { SCENARIOS, stage, type StagedInput, ticksOf } from '../rehearsal';
import type { Choices } from './choices';

/** What a scenario's own pilot does, and when the scenario is over. */
export interface Script {
  readonly inputs: readonly StagedInput[];
  /** Tick of the last boundary. */
  readonly lastTick: number;
  /** Hz and times, as asked for or the scenario's own. */
  readonly tickRate: number;
  readonly timeScale: number;
}

export function scriptOf(choices: Choices): Script {
  const scenario = SCENARIOS.find(({ name }) => name === choices.scenario) ?? SCENARIOS[0]!;
  const tickRate = choices.tickRate === 0 ? scenario.tickRate : choices.tickRate;
  const timeScale = choices.timeScale === 0 ? scenario.timeScale : choices.timeScale;
  const staged = stage({ ...scenario, tickRate, timeScale });
  if (!staged.ok) return { inputs: [], lastTick: 0, tickRate, timeScale };
  return { inputs: staged.value.inputs, lastTick: ticksOf(staged.value), tickRate, timeScale };
}

/** The script's controls at the present of a view. */
export function scriptedControls(script: Script, view: WorldView): Controls {
  const { inputs } = script;
  const perTick = script.timeScale / script.tickRate;
  const substeps = Math.max(1, Math.ceil(perTick * 100 - 1e-9));
  const substep = Math.floor((view.sinceTick / perTick) * substeps);
  let controls = NEUTRAL_CONTROLS;
  for (const input of inputs) {
    if (input.tick > view.tick || (input.tick === view.tick && input.substep > substep)) break;
    controls = input.controls;
  }
  return controls;
}
