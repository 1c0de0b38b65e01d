// Packs dist/package, installs the tarball into projects of each kind that users have, and runs them.
//   node .ci/package/check.mjs
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { checkEsbuild, checkNode, checkVite, checkWebpack } from './programs.mjs';
import { checkSizes } from './sizes.mjs';
import { inProject, installTools, pack, PACKAGE, root, run, tool } from './tools.mjs';
import { checkTypes } from './typescript.mjs';

function checkPublint() {
  run(process.execPath, [tool('publint/src/cli.js'), '--strict', PACKAGE], root);
  return 'publint: nothing to say';
}

function checkAttw(tarball) {
  run(process.execPath, [tool('@arethetypeswrong/cli/dist/index.js'), tarball], root);
  return 'are the types wrong: no';
}

/** In a browser, with an import map and no bundler. */
function checkImportMap(folder) {
  const entry = ['test/run.mjs', 'test/package/importMap.ts', join(folder, 'node_modules/galaxy-touchdown')];
  return run(process.execPath, entry, root).trim().split('\n').at(-1);
}

/** Loads the production core in node and compares its results with the default one's. */
function checkProduction(folder) {
  run(process.execPath, ['--conditions=production', 'main.mjs'], folder);
  const entry = ['test/run.mjs', 'test/package/production.ts', join(folder, 'node_modules/galaxy-touchdown')];
  return run(process.execPath, entry, root).trim().split('\n').at(-1);
}

const temporary = mkdtempSync(join(tmpdir(), 'touchdown-pack-'));
try {
  installTools();
  const tarball = pack(temporary);
  const say = (text) => console.log(`package: ${text}`);
  say(checkPublint());
  say(checkAttw(tarball));
  await inProject(tarball, async (folder) => {
    for (const check of [
      checkNode,
      checkProduction,
      checkEsbuild,
      checkWebpack,
      checkVite,
      checkSizes,
      checkImportMap,
      checkTypes,
    ])
      say(await check(folder));
  });
} catch (error) {
  console.error(`package: ${error.message}`);
  process.exitCode = 1;
} finally {
  rmSync(temporary, { recursive: true });
}
