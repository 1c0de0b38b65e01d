import { type PredictorEntry, type PredictorOptions, recordPredictor } from '../../src/prediction';
import { createRig, type RigOptions } from './rig';

/** s: every recorded scenario is at rest by then. */
const SECONDS = 14;

/** Everything that went into a predictor, and the options of another that shows the same. */
export interface RecordedFlight {
  readonly entries: readonly PredictorEntry[];
  readonly options: PredictorOptions;
}

export function recordFlight(given: RigOptions): RecordedFlight {
  const entries: PredictorEntry[] = [];
  const rig = createRig(given);
  rig.predictor = recordPredictor(rig.predictor, (entry) => entries.push(entry));
  rig.fly(SECONDS);
  const { scenario, terrainHeight, body, shipClass } = rig.loaded;
  const defaults = { bodies: [body], shipClasses: [shipClass], terrain: scenario.terrain };
  return {
    entries,
    options: { ownShipId: 'ship-1', terrains: { [scenario.terrain]: terrainHeight }, defaults },
  };
}
