/** The scenarios by subject. */
import type { Scenario } from '../scenario';
import { ACTUATORS } from './actuators';
import { OTHER_BODIES } from './bodies';
import { FLAT_GROUND } from './flat';
import { HILLS } from './hills';

/** All scenarios, in the order of the page's list: the simplest first. */
export const SCENARIOS: readonly Scenario[] = [...FLAT_GROUND, ...ACTUATORS, ...HILLS, ...OTHER_BODIES];
