/** The rehearsals as the JSON that the Python server reads: test/server/scenarios.json. */
import { fileURLToPath } from 'node:url';
import { SCENARIOS } from '../../src/rehearsal';
import { caseOf, caseToJson, type ExactCase } from './exactCase';

export const SCENARIO_FILE = fileURLToPath(new URL('../server/scenarios.json', import.meta.url));

/** Every rehearsal as a case. @throws when one cannot be staged. */
export function rehearsalCases(): ExactCase[] {
  return SCENARIOS.map((scenario) => {
    const exact = caseOf(scenario);
    if (!exact.ok) throw new Error(`${scenario.name}: ${exact.reason}`);
    return exact.value;
  });
}

/** What belongs into the file. A line a scenario. */
export function scenarioText(): string {
  const cases = rehearsalCases();
  const lines = SCENARIOS.map(({ about }, i) =>
    JSON.stringify({ about, ...(caseToJson(cases[i]!) as object) }),
  );
  return `[\n${lines.join(',\n')}\n]\n`;
}
