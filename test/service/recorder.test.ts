import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { servicePython } from '../../.ci/python.mjs';
import { compareFixture, readFixture } from '../../src/scenarios';
import { HERE, isMissing } from './pythonTests';

it.skipIf(isMissing('redis'))(
  'a landing recorded from a running service replays without any difference',
  async () => {
    const folder = mkdtempSync(join(tmpdir(), 'recorded-'));
    const { command, env } = servicePython();
    try {
      const file = join(folder, 'landing.json');
      const child = spawn(command, ['record_landing.py', file], { cwd: HERE, env, stdio: 'inherit' });
      const code = await new Promise((resolve) => child.on('close', resolve));
      expect(code).toBe(0);
      const fixture = readFixture(readFileSync(file, 'utf8'));
      if (!fixture.ok) throw new Error(fixture.reason);
      const compared = compareFixture(fixture.value);
      if (!compared.ok) throw new Error(compared.reason);
      expect(compared.value.disagreement).toBeNull();
      expect(Object.values(compared.value.worst)).toEqual(Object.values(compared.value.worst).map(() => 0));
      expect(fixture.value.events.map(({ event }) => event)).toContain('ship.contact');
      expect(fixture.value.inputs.length).toBeGreaterThan(3);
    } finally {
      rmSync(folder, { recursive: true });
    }
  },
  120_000,
);
