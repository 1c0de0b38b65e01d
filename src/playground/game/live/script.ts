import { findScenario, SCENARIOS, loadScenario, type ScheduledInput, ticksOf } from '../../../scenarios';
import type { Choices } from '../../panels/choices';
import { readFlight } from '../mission/runText';

/**
 * A scenario's scheduled inputs, and its end. The server in the page plays the plan at its exact substeps
 * and the predictor has it in advance: the run is the same at any frame rate and on any network.
 */
export interface Script {
  readonly plan: readonly ScheduledInput[];
  /** Tick of the last boundary. */
  readonly lastTick: number;
  /** Hz and times, as asked for or the scenario's own. */
  readonly tickRate: number;
  readonly timeScale: number;
  /** Of a tick. */
  readonly substeps: number;
}

export function scriptOf(choices: Choices): Script {
  const scenario = findScenario(choices.scenario) ?? SCENARIOS[0]!;
  const tickRate = choices.tickRate === 0 ? scenario.tickRate : choices.tickRate;
  const timeScale = choices.timeScale === 0 ? scenario.timeScale : choices.timeScale;
  const loaded = loadScenario({ ...scenario, tickRate, timeScale });
  if (!loaded.ok) return { plan: [], lastTick: 0, tickRate, timeScale, substeps: 1 };
  const { inputs, timing } = loaded.value;
  return {
    plan: planOf(inputs, choices.flight, timing.substeps),
    lastTick: ticksOf(loaded.value),
    tickRate,
    timeScale,
    substeps: timing.substeps,
  };
}

/** The scenario's own inputs until the flight's first one, as they were flown. */
function planOf(own: readonly ScheduledInput[], flight: string, substeps: number): readonly ScheduledInput[] {
  const read = flight === '' ? null : readFlight(flight, substeps);
  const first = read?.ok === true ? read.value[0] : undefined;
  if (read?.ok !== true || first === undefined) return own;
  const at = ({ tick, substep }: ScheduledInput) => tick * substeps + substep;
  return [...own.filter((input) => at(input) < at(first)), ...read.value];
}
