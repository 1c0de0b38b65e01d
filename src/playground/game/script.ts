import { findScenario, SCENARIOS, loadScenario, type ScheduledInput, ticksOf } from '../../scenarios';
import type { Choices } from '../panels/choices';

/**
 * What a scenario's ship does by itself, and when the scenario is over. The server in the page plays the plan at its exact substeps
 * and the predictor knows it beforehand, so that the run is the same whatever the display's rate and the network.
 */
export interface Script {
  readonly plan: readonly ScheduledInput[];
  /** Tick of the last boundary. */
  readonly lastTick: number;
  /** Hz and times, as asked for or the scenario's own. */
  readonly tickRate: number;
  readonly timeScale: number;
}

export function scriptOf(choices: Choices): Script {
  const scenario = findScenario(choices.scenario) ?? SCENARIOS[0]!;
  const tickRate = choices.tickRate === 0 ? scenario.tickRate : choices.tickRate;
  const timeScale = choices.timeScale === 0 ? scenario.timeScale : choices.timeScale;
  const loaded = loadScenario({ ...scenario, tickRate, timeScale });
  if (!loaded.ok) return { plan: [], lastTick: 0, tickRate, timeScale };
  return { plan: loaded.value.inputs, lastTick: ticksOf(loaded.value), tickRate, timeScale };
}
