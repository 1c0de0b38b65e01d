/** The Python server as a child process: cases in, what its substeps came to out. */
import { spawn, spawnSync } from 'node:child_process';
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';
import { caseToJson, type ExactCase } from './exactCase';

/** The folder that holds the package `server`. */
export const SERVER_HOME = dirname(dirname(fileURLToPath(import.meta.url)));

const PYTHON = process.env['PYTHON'] ?? 'python3';

/** "Python 3.11.7", or null where there is none that is new enough for the server (3.10). */
export function pythonVersion(): string | null {
  const program = 'import sys; print("Python %d.%d.%d" % sys.version_info[:3]); sys.exit(sys.version_info < (3, 10))';
  const run = spawnSync(PYTHON, ['-c', program], { encoding: 'utf8' });
  return run.status === 0 ? run.stdout.trim() : null;
}

/** In CI nothing is skipped: there a missing python3 makes the tests fail. */
export const MAY_SKIP = process.env['CI'] === undefined || process.env['CI'] === '';

/** What the Python server made of a case. */
export interface PythonResult {
  readonly name: string;
  readonly substeps: number;
  /** SHA-256 of all rows, hexadecimal. */
  readonly hash: string;
}

/** Plays the cases in one child; results in their order. Rejects with the child's own words when it fails. */
export async function replayInPython(
  cases: readonly ExactCase[],
  home: string = SERVER_HOME,
): Promise<PythonResult[]> {
  const lines = await run(cases, [], home);
  return lines.map((line) => {
    const [name = '', substeps = '', hash = ''] = line.split(' ');
    return { name, substeps: Number(substeps), hash };
  });
}

/** A row as Python computed it: bytes in hexadecimal. */
export interface PythonRow {
  readonly tick: number;
  readonly substep: number;
  readonly bytes: string;
}

/** Every row of one case. */
export async function rowsInPython(exact: ExactCase, home: string = SERVER_HOME): Promise<PythonRow[]> {
  const lines = await run([exact], ['--rows'], home);
  return lines.map((line) => {
    const [tick = '', substep = '', bytes = ''] = line.split(' ');
    return { tick: Number(tick), substep: Number(substep), bytes };
  });
}

/** Runs `python3 -m server.fixtures`, which writes every rehearsal as a fixture into `folder`. */
export function writeFixtures(folder: string): void {
  const { status, stderr } = spawnSync(PYTHON, ['-m', 'server.fixtures', folder], {
    cwd: SERVER_HOME,
    encoding: 'utf8',
  });
  if (status !== 0) throw new Error(`server.fixtures failed: ${stderr}`);
}

function run(cases: readonly ExactCase[], options: readonly string[], home: string): Promise<string[]> {
  return new Promise((resolve, reject) => {
    // -B: no __pycache__ beside the sources.
    const child = spawn(PYTHON, ['-B', '-m', 'server.replay', ...options], { cwd: home });
    const out: Buffer[] = [];
    const err: Buffer[] = [];
    child.stdout.on('data', (chunk: Buffer) => out.push(chunk));
    child.stderr.on('data', (chunk: Buffer) => err.push(chunk));
    child.on('error', reject);
    child.on('close', (code) => {
      if (code === 0) resolve(Buffer.concat(out).toString().trimEnd().split('\n'));
      else reject(new Error(`server.replay failed (${code}): ${Buffer.concat(err).toString()}`));
    });
    child.stdin.on('error', reject);
    for (const exact of cases) child.stdin.write(`${JSON.stringify(caseToJson(exact))}\n`);
    child.stdin.end();
  });
}
