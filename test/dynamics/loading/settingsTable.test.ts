import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { DEFAULT_SETTINGS } from '../../../src/dynamics';
import { snakeCase } from '../../../src/scenarios/fixtures/snakeCase';

/** Name and default of each row of the table in DYNAMICS, Settings: numbers without their unit. */
function documentedDefaults(): Record<string, string> {
  const text = readFileSync(new URL('../../../src/dynamics/DYNAMICS.md', import.meta.url), 'utf8');
  const table = text.slice(text.indexOf('\n## Settings'), text.indexOf('\n### Ranges'));
  const rows = [...table.matchAll(/^\| `(\w+)` +\| `?([\w.]+)/gm)];
  return Object.fromEntries(rows.map(([, name, value]) => [name!, value!]));
}

it('the defaults of the settings are those that DYNAMICS states', () => {
  const defaults = Object.entries(DEFAULT_SETTINGS).map(([name, value]) => [snakeCase(name), String(value)]);
  expect(documentedDefaults()).toEqual(Object.fromEntries(defaults));
});
