/** The whole law in scalar C, where a compiler is installed: the baseline of the law's speed, in two versions. */
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, renameSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { timingOfTick } from '../../src/dynamics';
import type { Timer } from './measure';
import type { Subject } from './subjects';
import { type Landing, runReference } from './cReference/landing';

const SOURCES = fileURLToPath(new URL('./cReference/', import.meta.url));
const CACHE = fileURLToPath(new URL('../../node_modules/.cache/touchdown/', import.meta.url));
/** No fused multiply-add: the bits are part of the law. */
const FLAGS = [
  '-std=c11',
  '-D_POSIX_C_SOURCE=199309L',
  '-O3',
  '-ffp-contract=off',
  '-Wall',
  '-Wextra',
  '-Werror',
];

const COMPILERS = [process.env['CC'] ?? 'cc', 'cc', 'gcc', 'clang'];

/**
 * Two versions of the law in C: `straightforward` follows the text of DYNAMICS.md and computes every quantity anew at each end of a substep;
 * `tuned` is structured like the TypeScript: it skips quantities that a state does not need and computes shared ones once.
 */
export const REFERENCES = ['straightforward', 'tuned'] as const;
export type Reference = (typeof REFERENCES)[number];

/** Times the substep of `subject`'s first ship in C, `times` substeps a round; null without a compiler. */
export function timerInC(subject: Subject, reference: Reference, times: number): Timer | null {
  const program = compileReference(reference);
  if (program === null) return null;
  const landings = [landingOf(subject)];
  return (rounds) => runReference(program, ['time', String(rounds), String(times)], landings).map(Number);
}

/** A subject as a landing of `ticks` ticks of one substep, 10 ms each, as the subjects are stepped. */
export function landingOf({ world, ships, bodies }: Subject, ticks = 1): Landing {
  const timing = timingOfTick(0.01, 0.01);
  return { ticks, timing, world, terrain: { name: 'flat' }, ships, bodies, inputs: [] };
}

/** The path of the compiled reference, compiled again when its source changed; null without a compiler. @throws when it does not compile. */
export function compileReference(
  reference: Reference,
  compilers: readonly string[] = COMPILERS,
): string | null {
  const compiler = compilers.find((name) => spawnSync(name, ['--version']).status === 0);
  if (compiler === undefined) return null;
  const files = readdirSync(SOURCES).filter((name) => /\.[ch]$/.test(name));
  const hash = createHash('sha256').update(`${compiler} ${FLAGS.join(' ')}`);
  for (const name of files) hash.update(readFileSync(join(SOURCES, name)));
  const path = join(CACHE, `c-${reference}-${hash.digest('hex').slice(0, 12)}`);
  if (existsSync(path)) return path;
  mkdirSync(CACHE, { recursive: true });
  const made = `${path}-${String(process.pid)}`;
  const units = ['main.c', 'tick.c', `${reference}.c`].map((name) => join(SOURCES, name));
  const run = spawnSync(compiler, [...FLAGS, '-o', made, ...units, '-lm'], { encoding: 'utf8' });
  if (run.status !== 0) throw new Error(`${compiler}: ${run.stderr}`);
  renameSync(made, path);
  return path;
}
