/** Every command that README.md shows is one that `.ci/run` runs. */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { ROOT } from '../source';

const read = (path: string) => readFileSync(join(ROOT, path), 'utf8');
const { scripts } = JSON.parse(read('package.json')) as { scripts: Record<string, string> };

/** Commands that CI runs inside a program of its own, and that program. */
const INSIDE: Readonly<Record<string, string>> = {
  'npm start': 'node .ci/checkStart.mjs\n',
  'npm run example': 'node .ci/checkStart.mjs run example',
  'npm pack ./dist/package': 'node .ci/package/check.mjs',
};

/** The commands of the `sh` blocks, without comments and arguments. */
function commandsOf(text: string): string[] {
  const blocks = [...text.matchAll(/^```sh\n([^]*?)^```/gm)].map((match) => match[1]!);
  const lines = blocks.flatMap((block) => block.split('\n'));
  return lines
    .map((line) =>
      line
        .replace(/\s+#.*$/, '')
        .replace(/ -- .*$/, '')
        .trim(),
    )
    .filter((line) => line !== '');
}

/** The commands of `.ci/run`, including the scripts that its scripts run. */
function runByCi(): string {
  const run = read('.ci/run').replaceAll('npm run --silent', 'npm run');
  const called = [...run.matchAll(/npm run ([\w:]+)/g)].map((match) => scripts[match[1]!] ?? '');
  return [run, ...called].join('\n');
}

it.each(commandsOf(read('README.md')))('CI runs `%s`', (command) => {
  const script = /^npm run ([\w:]+)$/.exec(command)?.[1];
  if (script !== undefined) expect(Object.keys(scripts)).toContain(script);
  expect(runByCi()).toContain(INSIDE[command] ?? command);
});

it('finds the commands of a README', () => {
  expect(commandsOf(read('README.md')).length).toBeGreaterThan(8);
  expect(commandsOf('```sh\nnpm run a -- b  # c\n```\n')).toEqual(['npm run a']);
});
