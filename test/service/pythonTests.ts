/** The Python tests of python/, each file in its own process; those that need Redis start one. */
import { spawn } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { expect } from 'vitest';
import { redisServer, servicePython } from '../../.ci/python.mjs';
import { MAY_SKIP } from '../exact/python';

export const HERE = fileURLToPath(new URL('python/', import.meta.url));

/** Whether a test's requirement is missing and the test may be skipped; in CI none may. */
export function isMissing(what: 'python' | 'redis'): boolean {
  if (!MAY_SKIP) return false;
  try {
    servicePython();
    if (what === 'redis') redisServer();
    return false;
  } catch (error) {
    console.warn(`skipped: ${error instanceof Error ? error.message : String(error)}`);
    return true;
  }
}

/** Runs a module's tests; expects that there are some, that none is skipped and all pass. */
export async function expectUnittest(module: string): Promise<void> {
  const { code, words } = await unittest(module);
  expect(code, `${whatFailed(words)}\n${words}`).toBe(0);
  // "Ran 0 tests" would pass as well.
  expect(words).toMatch(/Ran [1-9]\d* tests? in/);
  expect(words).not.toContain('skipped');
}

/** The names of unittest's failures and what each raised, in one line. */
function whatFailed(words: string): string {
  const found = words.match(/^(FAIL|ERROR): .+|^\w*(Error|Exception|Interrupt)\b.*/gm) ?? [];
  return found.join('; ');
}

function unittest(module: string): Promise<{ code: number | null; words: string }> {
  return new Promise((resolve, reject) => {
    const { command, env } = servicePython();
    const child = spawn(command, ['-m', 'unittest', module], { cwd: HERE, env });
    const said: Buffer[] = [];
    child.stdout.on('data', (chunk: Buffer) => said.push(chunk));
    child.stderr.on('data', (chunk: Buffer) => said.push(chunk));
    child.on('error', reject);
    child.on('close', (code) => {
      resolve({ code, words: Buffer.concat(said).toString() });
    });
  });
}
