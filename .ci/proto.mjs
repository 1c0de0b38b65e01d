// Generates the static codec from proto/.
//   node .ci/proto.mjs            into src/wire/generated
//   node .ci/proto.mjs FOLDER     into FOLDER, to compare
// Static, because protobufjs's reflection needs eval, which a content security policy forbids. Names keep their
// case, so that a decoded message and the game's JSON are read by the same code. A root of our own keeps these
// messages apart from another codec's with the same package names on the same page.
import { spawnSync } from 'node:child_process';
import { mkdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const OPTIONS = [
  ...['--target', 'static-module', '--wrap', 'esm', '--dts', '--root', 'touchdown', '--keep-case'],
  // Only encode and decode are used.
  ...['--no-create', '--no-verify', '--no-convert', '--no-delimited', '--no-typeurl', '--no-service'],
];

const root = fileURLToPath(new URL('..', import.meta.url));
const folder = resolve(process.argv[2] ?? join(root, 'src/wire/generated'));
mkdirSync(folder, { recursive: true });

const pbjs = createRequire(import.meta.url).resolve('protobufjs-cli/bin/pbjs');
const files = [
  '--path',
  join(root, 'proto'),
  '--out',
  join(folder, 'codec.js'),
  join(root, 'proto/stream.proto'),
];
const run = spawnSync(process.execPath, [pbjs, ...OPTIONS, ...files], { stdio: 'inherit' });
if (run.error) console.error(`proto: pbjs cannot be started: ${run.error.message}`);
process.exit(run.status ?? 1);
