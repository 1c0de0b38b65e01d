/**
 * Bytes of heap that one more ship takes in a display frame, and one more state in a server frame, over flat ground and hills in turn.
 * Run as a bundle (test/run.mjs): the prediction as it is shipped, without a test runner's wrappers. Prints one number per case as JSON.
 */
import type { Scenario } from '../../../src/scenarios';
import { compileFleet, fleetHeap, LONG_SLIDE } from './fleetHeap';

/** The first 32 ships are put on the ground point by point; for the others it counts as level. */
const FEW = 8;
const POINT_BY_POINT = 32;
const MANY = 250;
/** Rounds of each scenario, enough with compilation in the foreground. */
const ROUNDS = 2;

const overHills: Scenario = { ...LONG_SLIDE, terrain: 'hills' };
const damped: Scenario = { ...LONG_SLIDE, settings: { ...LONG_SLIDE.settings, contactDampingRatio: 1 } };
const bytes: Record<string, number> = {};

// Settings, classes and terrains that an engine represents each in another way: what is read of the last must not be boxed.
for (const scenario of [overHills, damped, LONG_SLIDE]) compileFleet(scenario, ROUNDS);
const few = fleetHeap(LONG_SLIDE, FEW);
const exact = fleetHeap(LONG_SLIDE, POINT_BY_POINT);
const many = fleetHeap(LONG_SLIDE, MANY);
for (const { ships, inContact, corrections } of [few, exact, many])
  if (inContact < ships - 2 || corrections > 0) throw new Error('the ships do not slide as predicted');
bytes['a display frame, per ship on the ground point by point'] =
  (exact.frame - few.frame) / (POINT_BY_POINT - FEW);
bytes['a display frame, per other ship'] = (many.frame - exact.frame) / (MANY - POINT_BY_POINT);
bytes['a server frame, per state'] = (many.message - few.message) / (MANY - FEW);
console.log(JSON.stringify(bytes));
