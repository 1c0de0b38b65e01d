import { createRightingMemory, followRighting, measureRighting, type RightingMemory } from './righting';
import { forgetRightingRun } from './rightingRun';
import { createTippingMemory, forecastTipping, forgetTipping, type TippingMemory } from './tipping';

/** A landing readout's simulations ahead, and their functions: a lean one has none and does not load them. */
export interface LookAhead {
  readonly tipping: TippingMemory;
  readonly righting: RightingMemory;
  readonly forecastTipping: typeof forecastTipping;
  readonly forgetTipping: typeof forgetTipping;
  readonly measureRighting: typeof measureRighting;
  readonly followRighting: typeof followRighting;
  readonly forgetRightingRun: typeof forgetRightingRun;
}

export function createLookAhead(): LookAhead {
  return {
    tipping: createTippingMemory(),
    righting: createRightingMemory(),
    forecastTipping,
    forgetTipping,
    measureRighting,
    followRighting,
    forgetRightingRun,
  };
}
