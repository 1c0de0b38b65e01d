import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { runScenario, SCENARIOS } from '../../src/scenarios';

// node test/run.mjs test/scenarios/writeGolden.ts
// Pins every scenario's bits anew. Only after a change that is meant to change them: an order of additions, a scenario.

const hashes: Record<string, string> = {};
for (const scenario of SCENARIOS) {
  const run = runScenario(scenario);
  if (!run.ok) throw new Error(`${scenario.name}: ${run.reason}`);
  hashes[scenario.name] = run.value.hash.toString(16);
}
writeFileSync(join(import.meta.dirname, 'golden.json'), `${JSON.stringify(hashes, null, 2)}\n`);
