import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { format, resolveConfig } from 'prettier';
import { LESSONS, MISSIONS, runScenario, SCENARIOS } from '../../src/scenarios';
import { recordOf } from './missions/missionRecord';

// node test/run.mjs test/scenarios/writeGolden.ts
// Pins the bits of every scenario, and what the race links of a mission rely on. Run it only after a change that is meant to change them, such as the order of a sum or a scenario.

const hashes: Record<string, string> = {};
for (const scenario of SCENARIOS) {
  const run = runScenario(scenario);
  if (!run.ok) throw new Error(`${scenario.name}: ${run.reason}`);
  hashes[scenario.name] = run.value.hash.toString(16);
}
await write('golden.json', hashes);

const missions = [...MISSIONS, ...LESSONS].map(
  (mission) => [mission.scenario.name, recordOf(mission)] as const,
);
await write('missions/goldenMissions.json', Object.fromEntries(missions));

/** Formatted as the linter wants it, so that only what changed differs. */
async function write(name: string, value: object): Promise<void> {
  const path = join(import.meta.dirname, name);
  writeFileSync(
    path,
    await format(JSON.stringify(value, null, 2), { ...(await resolveConfig(path)), filepath: path }),
  );
}
