// Uses dist/lib as the game's client would: a strict program against its types, and an import of its code in node.
import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('..', import.meta.url));
const folder = join(root, 'node_modules/.cache/touchdown/consumer');

const CONFIG = {
  compilerOptions: {
    ...{ target: 'es2022', module: 'esnext', moduleResolution: 'bundler', lib: ['es2023', 'dom'], types: [] },
    ...{ strict: true, exactOptionalPropertyTypes: true, noEmit: true, skipLibCheck: false },
    paths: { touchdown: [join(root, 'dist/lib/types/index.d.ts')] },
  },
  files: ['consumer.ts'],
};

function fail(message) {
  console.error(`library: ${message}`);
  process.exit(1);
}

const { exports } = JSON.parse(readFileSync(join(root, 'dist/lib/package.json'), 'utf8'));
const code = await import(new URL(`../dist/lib/${exports['.'].default}`, import.meta.url).href);
const names = Object.keys(code).sort();
if (names.length === 0) fail('dist/lib exports nothing');

const styles = readFileSync(join(root, 'dist/lib', exports['./touchdown.css']), 'utf8');
if (!styles.includes('prefers-reduced-motion')) fail('the displays’ style sheet is not in dist/lib');

mkdirSync(folder, { recursive: true });
const uses = names.map((name) => `used(touchdown.${name}, true);`).join('\n');
const program = `import * as touchdown from 'touchdown';
function used<T>(value: T, isTyped: 0 extends 1 & T ? never : true): void { void [value, isTyped]; }
`;
writeFileSync(join(folder, 'consumer.ts'), `${program}${uses}\n`);
writeFileSync(join(folder, 'tsconfig.json'), JSON.stringify(CONFIG));
const tsc = join(root, 'node_modules/typescript/bin/tsc');
const run = spawnSync(process.execPath, [tsc, '-p', folder], { encoding: 'utf8' });
rmSync(folder, { recursive: true });
// An export whose type got lost is `any`, and `used` refuses it.
if (run.status !== 0) fail(`its types do not serve a program that uses every export:\n${run.stdout}`);
console.log(`library: ${names.length} exports, each with its type`);
