import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
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
writeFileSync(join(import.meta.dirname, 'golden.json'), `${JSON.stringify(hashes, null, 2)}\n`);

const missions = [...MISSIONS, ...LESSONS].map(
  (mission) => [mission.scenario.name, recordOf(mission)] as const,
);
writeFileSync(
  join(import.meta.dirname, 'missions/goldenMissions.json'),
  `${JSON.stringify(Object.fromEntries(missions), null, 2)}\n`,
);
