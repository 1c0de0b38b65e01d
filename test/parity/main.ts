import { readdirSync, readFileSync, statSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parityLine } from './parityLine';

// npm run parity -- FILE…: compares the dynamics with each file's trajectory. Without FILE: every fixture of the repository.
// Exit 1 if one is out of tolerance, disagrees, or cannot be read; the others still run.

const FIXTURES = join(dirname(fileURLToPath(import.meta.url)), 'fixtures');

function filesOf(path: string): string[] {
  if (!statSync(path).isDirectory()) return [path];
  return readdirSync(path)
    .filter((name) => /\.jsonl?$/.test(name))
    .sort()
    .map((name) => join(path, name));
}

/** The path relative to the working directory, if that is shorter. */
function shortest(path: string): string {
  const seen = relative(process.cwd(), path);
  return seen.length < path.length ? seen : path;
}

function check(path: string): boolean {
  try {
    const { line, passed } = parityLine(shortest(path), readFileSync(path, 'utf8'));
    (passed ? console.log : console.error)(line);
    return passed;
  } catch (error) {
    console.error(
      `${shortest(path)}: cannot be read: ${error instanceof Error ? error.message : String(error)}`,
    );
    return false;
  }
}

function expand(path: string): string[] {
  try {
    return filesOf(path);
  } catch {
    return [path];
  }
}

const given = process.argv.slice(2);
const files = (given.length > 0 ? given : [FIXTURES]).flatMap(expand);
const failed = files.filter((file) => !check(file));
console.log(`${files.length - failed.length} of ${files.length} files agree`);
process.exitCode = failed.length === 0 && files.length > 0 ? 0 : 1;
