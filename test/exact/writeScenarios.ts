/** node test/run.mjs test/exact/writeScenarios.ts: brings test/server/scenarios.json up to date with src/scenarios. */
import { writeFileSync } from 'node:fs';
import { SCENARIO_FILE, scenarioText } from './scenarioData';

writeFileSync(SCENARIO_FILE, scenarioText());
