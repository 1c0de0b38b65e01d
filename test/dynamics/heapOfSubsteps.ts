/**
 * Bytes of heap that a million substeps leave behind, in every state and mode. Run as a bundle with --expose-gc (test/run.mjs) and
 * a young generation that holds them all: the
 * law as it is shipped; module by module a test runner's own wrappers would be measured too. Prints one number a case as JSON.
 */
import { createTrial, type Setup, stepOnce } from './provingGround';

const SLIPPERY = { contactFrictionKinetic: 0, contactFrictionStatic: 0, contactSettleAngularVel: 1e-12 };

const CASES: Readonly<Record<string, Setup>> = {
  flying: { height: 1e9, controls: { attitudeMode: 'prograde', thrustLevel: 1e-4 } },
  sliding: { settings: SLIPPERY, velocity: [30, 0, 0], state: 'contact', spin: [0, 0, 1e-3] },
  landed: { state: 'landed' },
  // Lies past 90° again after each substep, so that it is laid flat in each.
  tipped: { state: 'tipped', tilt: 90, controls: { attitudeHold: true } },
  toppling: {
    settings: { touchdownAttitude: 'kept', contactTippedAngleDeg: 89 },
    state: 'contact',
    tilt: 120,
  },
};

declare const gc: () => void;

/** Garbage counts too: the heap is read before it is collected. The least of three, as the engine's compilers allocate as well. */
function bytesOf(setup: Setup): number {
  const trial = createTrial(setup);
  for (let i = 0; i < 100_000; i++) stepOnce(trial);
  let least = Infinity;
  for (let repeat = 0; repeat < 3; repeat++) {
    gc();
    gc();
    const before = process.memoryUsage().heapUsed;
    for (let i = 0; i < 1_000_000; i++) stepOnce(trial);
    least = Math.min(least, process.memoryUsage().heapUsed - before);
  }
  return least;
}

const bytes = Object.fromEntries(Object.entries(CASES).map(([name, setup]) => [name, bytesOf(setup)]));
console.log(JSON.stringify(bytes));
