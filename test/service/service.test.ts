import { spawn } from 'node:child_process';
import { readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';
import { redisServer, servicePython } from '../../.ci/python.mjs';

/** The Python tests, each file in a process of its own; those that talk to Redis start one for themselves. */
const HERE = fileURLToPath(new URL('.', import.meta.url));
const files = readdirSync(HERE).filter((name) => /^test_\w+\.py$/.test(name));
const WITHOUT_REDIS = ['test_loading.py', 'test_simulation.py'];
const MINUTES = 60_000;

it.each(files)(
  '%s passes',
  async (file) => {
    if (!WITHOUT_REDIS.includes(file)) redisServer();
    const { code, words } = await unittest(file.replace('.py', ''));
    expect(code, words).toBe(0);
    // "Ran 0 tests" would pass as well.
    expect(words).toMatch(/Ran [1-9]\d* tests? in/);
    expect(words).not.toContain('skipped');
  },
  6 * MINUTES,
);

function unittest(module: string): Promise<{ code: number | null; words: string }> {
  return new Promise((resolve, reject) => {
    const { command, env } = servicePython();
    const child = spawn(command, ['-B', '-m', 'unittest', module], { cwd: HERE, env });
    const said: Buffer[] = [];
    child.stdout.on('data', (chunk: Buffer) => said.push(chunk));
    child.stderr.on('data', (chunk: Buffer) => said.push(chunk));
    child.on('error', reject);
    child.on('close', (code) => {
      resolve({ code, words: Buffer.concat(said).toString() });
    });
  });
}
