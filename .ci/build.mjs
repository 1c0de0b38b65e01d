// Builds what is published:
//   node .ci/build.mjs page       dist/page: the playground, for any static host
//   node .ci/build.mjs package    dist/package: the library, to be packed and published
//   node .ci/build.mjs            both
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

const root = fileURLToPath(new URL('..', import.meta.url));

async function buildPage() {
  await build({ configFile: join(root, 'vite.config.ts'), logLevel: 'warn' });
}

async function buildPackage() {
  const library = await import('./package/build.mjs');
  await library.buildPackage();
}

const BUILDS = { page: [buildPage], package: [buildPackage] };
const requested = process.argv[2];
const builds = requested === undefined ? [buildPage, buildPackage] : BUILDS[requested];
if (!builds) {
  console.error('usage: node .ci/build.mjs [page | package]');
  process.exit(2);
}
process.chdir(root);
try {
  for (const one of builds) await one();
} catch (error) {
  console.error(`build: ${error.message}`);
  process.exit(1);
}
