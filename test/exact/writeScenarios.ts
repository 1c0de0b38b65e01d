/** node test/run.mjs test/exact/writeScenarios.ts: brings test/service, scenarios and trajectories, up to date with src/scenarios. */
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { SERVICE_TESTS, writeFixtures } from './python';
import { SCENARIO_FILE, scenarioText } from './scenarioData';

writeFileSync(SCENARIO_FILE, scenarioText());
writeFixtures(join(SERVICE_TESTS, 'fixtures'));
