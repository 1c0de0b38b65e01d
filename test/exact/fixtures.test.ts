import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { describe, expect, it, vi } from 'vitest';
import { compareFixture, readFixture, SCENARIOS } from '../../src/scenarios';
import { HAS_PYTHON, MAY_SKIP, SERVICE_TESTS, writeFixtures } from './python';
import { SCENARIO_FILE, scenarioText, WORLD_FILE, worldText } from './scenarioData';

const COMMITTED = join(SERVICE_TESTS, 'fixtures');
const withPython = !HAS_PYTHON && MAY_SKIP ? it.skip : it;

function filesIn(folder: string): Map<string, string> {
  const names = readdirSync(folder).sort();
  return new Map(names.map((name) => [name, readFileSync(join(folder, name), 'utf8')]));
}

// Leaves the cores to other tests.
vi.setConfig({ testTimeout: 120_000 });

describe('the Python service’s trajectories', () => {
  it('come from the current scenarios (else: node test/run.mjs test/exact/writeScenarios.ts)', () => {
    expect(readFileSync(SCENARIO_FILE, 'utf8')).toBe(scenarioText());
  });

  it('use the catalogue’s bodies and classes (else: the same command)', () => {
    expect(readFileSync(WORLD_FILE, 'utf8')).toBe(worldText());
  });

  it('exist for every scenario', () => {
    expect([...filesIn(COMMITTED).keys()]).toEqual(SCENARIOS.map(({ name }) => `${name}.json`).sort());
  });

  withPython(
    'come out byte for byte as committed (else: node test/run.mjs test/exact/writeScenarios.ts)',
    () => {
      const folder = mkdtempSync(join(tmpdir(), 'fixtures-'));
      try {
        writeFixtures(folder);
        const committed = filesIn(COMMITTED);
        const made = filesIn(folder);
        expect([...made.keys()]).toEqual([...committed.keys()]);
        for (const [name, text] of made) expect(text, name).toBe(committed.get(name));
      } finally {
        rmSync(folder, { recursive: true });
      }
    },
  );

  it.each(SCENARIOS.map(({ name }) => name))('%s: the dynamics agree exactly', (name) => {
    const fixture = readFixture(readFileSync(join(COMMITTED, `${name}.json`), 'utf8'));
    if (!fixture.ok) throw new Error(fixture.reason);
    const compared = compareFixture(fixture.value);
    if (!compared.ok) throw new Error(compared.reason);
    expect(Object.values(compared.value.worst)).toEqual(Object.values(compared.value.worst).map(() => 0));
    expect(compared.value.disagreement).toBeNull();
  });
});
