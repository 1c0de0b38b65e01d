import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { runScenario, SCENARIOS } from '../../src/scenarios';

// node test/run.mjs test/scenarios/writeGolden.ts
// Pins the bits of every scenario. Run it only after a change that is meant to change them, such as the order of a sum or a scenario.

const hashes: Record<string, string> = {};
for (const scenario of SCENARIOS) {
  const run = runScenario(scenario);
  if (!run.ok) throw new Error(`${scenario.name}: ${run.reason}`);
  hashes[scenario.name] = run.value.hash.toString(16);
}
writeFileSync(join(import.meta.dirname, 'golden.json'), `${JSON.stringify(hashes, null, 2)}\n`);
