/**
 * Bytes of heap that 200,000 substeps leave behind, in every state, and over several terrains in turn. Run as a bundle with --expose-gc
 * (test/run.mjs) and a young generation that holds them all: the law as it is shipped, without a test runner's wrappers. Prints one
 * number per case as JSON.
 */
import { heightmapTerrain, hillsTerrain, type TerrainHeight } from '../../../src/dynamics';
import { flying, landed, sliding, slidingOverHills, tipped } from '../../bench/subjects';
import { createTrial, type Setup, stepOnce, type Trial } from '../provingGround';

const SLIPPERY = { contactFrictionKinetic: 0, contactFrictionStatic: 0, contactSettleAngularVel: 1e-12 };

const CASES: Readonly<Record<string, Setup>> = {
  flying: { height: 1e9, controls: { attitudeMode: 'prograde', thrustLevel: 1e-4 } },
  sliding: { settings: SLIPPERY, velocity: [30, 0, 0], state: 'contact', spin: [0, 0, 1e-3] },
  landed: { state: 'landed' },
  // Tilted beyond 90° again after each substep, so that each substep turns it back.
  tipped: { state: 'tipped', tilt: 90, controls: { attitudeHold: true } },
  toppling: {
    settings: { touchdownAttitude: 'kept', contactTippedAngleDeg: 89 },
    state: 'contact',
    tilt: 120,
  },
  'over hills': slidingOver(hillsTerrain),
  'over a heightmap': slidingOver(mapped()),
  'over flat ground again': { settings: SLIPPERY, velocity: [30, 0, 0], state: 'contact' },
};

/** A point of the hills with a slope of 22°. */
function slidingOver(terrain: TerrainHeight): Setup {
  const place = [0.601265926, 0.474432245, 0.64295671] as const;
  const settings = { ...SLIPPERY, surfaceNormal: 'terrain', contactCrashSpeed: 1e6 } as const;
  return { settings, terrain, place, velocity: [3, 0, 0], state: 'contact' };
}

function mapped(): TerrainHeight {
  const samples = Int16Array.from({ length: 8 * 16 }, (_, i) => (i * 37) % 100);
  const map = { samples, rows: 8, columns: 16, scale: 0.5, referenceRadius: 1737400 };
  const terrain = heightmapTerrain({ Luna: map });
  if (!terrain.ok) throw new Error(terrain.reason);
  return terrain.value;
}

const SUBSTEPS = 200_000;
/** Enough for the engine to compile the law for good. */
const WARM_UP = 50_000;
/** Bytes that the engine's compilers may leave: with so few there is no need to measure again. */
const FEW = 5000;

declare const gc: () => void;

/** Garbage counts: the heap is read before a collection. The minimum of three, since the engine's compilers allocate too. */
function bytesOf(run: (substeps: number) => void): number {
  for (let pass = 0; pass < 3; pass++) run(WARM_UP);
  let least = Infinity;
  for (let repeat = 0; repeat < 3 && least > FEW; repeat++) {
    gc();
    gc();
    const before = process.memoryUsage().heapUsed;
    run(SUBSTEPS);
    least = Math.min(least, process.memoryUsage().heapUsed - before);
  }
  return least;
}

/** A separate function is compiled once; a loop in the measuring function is compiled for each repeat. */
function run(trial: Trial, substeps: number): void {
  for (let i = 0; i < substeps; i++) stepOnce(trial);
}

const bytes: Record<string, number> = {};
for (const [name, setup] of Object.entries(CASES)) {
  const trial = createTrial(setup);
  bytes[name] = bytesOf((substeps) => run(trial, substeps));
}
// Worlds whose settings and classes an engine represents each in another way: what is read of the next must not be boxed.
const others = [
  sliding(),
  slidingOverHills('radial'),
  slidingOverHills('terrain'),
  flying(),
  tipped(),
  landed(),
];
for (const subject of others) subject.step(SUBSTEPS);
const last = sliding();
bytes['sliding after other worlds'] = bytesOf((substeps) => last.step(substeps));
console.log(JSON.stringify(bytes));
