/** The Python server as a child process: cases in, results out. */
import { spawn, spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { findPython, type Python } from '../../.ci/python.mjs';
import { caseToJson, type ExactCase } from './cases/exactCase';

/** The folder that holds the package `touchdown_service`. */
export const SERVER_HOME = fileURLToPath(new URL('../../src/service', import.meta.url));

/** Scenarios and trajectories of the service's tests. */
export const SERVICE_TESTS = fileURLToPath(new URL('../service', import.meta.url));

const python = findPython();

/** Whether there is a Python that is new enough for the server (3.10). */
export const HAS_PYTHON = python !== undefined;

/** In CI nothing is skipped: a missing python3 fails the tests. */
export const MAY_SKIP = process.env['CI'] === undefined || process.env['CI'] === '';

/** The Python server's result of a case. */
export interface PythonResult {
  readonly name: string;
  readonly substeps: number;
  /** SHA-256 of all rows, hexadecimal. */
  readonly hash: string;
}

/** Plays the cases in one child process; results in order. Rejects with the child's error output if it fails. */
export async function replayInPython(
  cases: readonly ExactCase[],
  home: string = SERVER_HOME,
): Promise<PythonResult[]> {
  const lines = await run('touchdown_service.comparison.replay', cases.map(caseToJson), { home });
  return lines.map((line) => {
    const [name = '', substeps = '', hash = ''] = line.split(' ');
    return { name, substeps: Number(substeps), hash };
  });
}

/** A row computed by Python: bytes in hexadecimal. */
export interface PythonRow {
  readonly tick: number;
  readonly substep: number;
  readonly bytes: string;
}

/** Every row of one case. */
export async function rowsInPython(exact: ExactCase, home: string = SERVER_HOME): Promise<PythonRow[]> {
  const lines = await run('touchdown_service.comparison.replay', [caseToJson(exact)], {
    home,
    options: ['--rows'],
  });
  return lines.map((line) => {
    const [tick = '', substep = '', bytes = ''] = line.split(' ');
    return { tick: Number(tick), substep: Number(substep), bytes };
  });
}

/** Runs `python3 -m touchdown_service.comparison.fixtures`, which writes every scenario as a fixture into `folder`. */
export function writeFixtures(folder: string): void {
  const { command, env } = python!;
  const given = [
    '-m',
    'touchdown_service.comparison.fixtures',
    join(SERVICE_TESTS, 'scenarios.json'),
    folder,
  ];
  const { status, stderr } = spawnSync(command, given, { cwd: SERVER_HOME, env, encoding: 'utf8' });
  if (status !== 0) throw new Error(`touchdown_service.comparison.fixtures failed: ${stderr}`);
}

/** A terrain's name, a body's name, and a unit direction in the body's axes. */
export type SurveyPoint = readonly [string, string, number, number, number];

/** Terrain heights, including those of the given maps, as the bits of doubles in hexadecimal, most significant byte first. */
export function surveyInPython(
  points: readonly SurveyPoint[],
  home: string = SERVER_HOME,
  maps: readonly unknown[] = [],
): Promise<string[]> {
  return run('touchdown_service.comparison.survey', [...maps, ...points], { home });
}

/** Of the server's package in `home`. What is compiled of a copy stays in its folder, and goes with it. */
function environmentIn(home: string): Python {
  const { command, env } = python!;
  return home === SERVER_HOME
    ? python!
    : { command, env: { ...env, PYTHONPATH: home, PYTHONPYCACHEPREFIX: '' } };
}

/** Runs a module of the server with `input`, one line of JSON per item. Returns the lines of its output. */
function run(
  module: string,
  input: readonly unknown[],
  { home, options = [] }: { readonly home: string; readonly options?: readonly string[] },
): Promise<string[]> {
  return new Promise((resolve, reject) => {
    const { command, env } = environmentIn(home);
    const child = spawn(command, ['-m', module, ...options], { cwd: home, env });
    const out: Buffer[] = [];
    const err: Buffer[] = [];
    child.stdout.on('data', (chunk: Buffer) => out.push(chunk));
    child.stderr.on('data', (chunk: Buffer) => err.push(chunk));
    child.on('error', reject);
    child.on('close', (code) => {
      if (code === 0) resolve(Buffer.concat(out).toString().trimEnd().split('\n'));
      else reject(new Error(`${module} failed (${code}): ${Buffer.concat(err).toString()}`));
    });
    child.stdin.on('error', reject);
    child.stdin.end(input.map((item) => `${JSON.stringify(item)}\n`).join(''));
  });
}
