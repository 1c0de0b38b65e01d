import type { Scenario } from '../scenario';
import { START, STILL } from '../start';

/** In flight above the pad. */
export const PILOTED: Scenario['initial'] = { ...STILL, height: 200, fuelFraction: 0.25 };

/** The scenario of a mission. Its duration is the longest flight that is scored. */
export function missionStart(
  name: string,
  title: string,
  changes: Partial<Scenario> & Pick<Scenario, 'about' | 'initial'>,
): Scenario {
  return {
    name,
    title,
    ...START,
    inputs: [{ at: 0, controls: { attitudeHold: true } }],
    duration: 900,
    expected: [],
    ...changes,
  };
}
