/** node test/run.mjs test/exact/writeScenarios.ts: brings the service's world, scenarios and trajectories up to date with src. */
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { SERVICE_TESTS, writeFixtures } from './python';
import { SCENARIO_FILE, scenarioText, WORLD_FILE, worldText } from './scenarioData';

writeFileSync(SCENARIO_FILE, scenarioText());
writeFileSync(WORLD_FILE, worldText());
writeFixtures(join(SERVICE_TESTS, 'fixtures'));
