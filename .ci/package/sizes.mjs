// Size that each use of the package adds to a page: bundled for production and minified by esbuild, gzip level 9, in bytes.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { root, tool } from './tools.mjs';

const using = (...names) =>
  `export { ${names.join(', ')}, encodeControlsJson, updateLandingReadout, createFleetReadout, updateFleetReadout } from 'galaxy-touchdown';`;

/** The game's server sends no hello, so the lean use has no decoder of one. */
const LEAN = using('createLeanPredictor', 'decodeLeanFrameJson', 'createLeanLandingReadout');
const WHOLE = using('createPredictor', 'decodeFrameJson', 'decodeHelloJson', 'createLandingReadout');

/** Words of the features that a lean predictor does not have unless they are handed in. */
const FEATURES = [
  'restore-refused',
  'configure-refused',
  'policy-unknown',
  'learnedGround',
  'no such setting',
  'fast_frigate',
  'spin_axis',
];

/** `most` in kB (1,000 bytes); the table in README.md has the same rows. */
export const USES = [
  {
    name: 'lean predictor, JSON, readouts',
    most: 36,
    code: LEAN,
    without: [...FEATURES, 'createElement', 'discardUnknown', 'WebGL', 'now-in-milliseconds'],
  },
  {
    name: 'predictor, JSON, readouts',
    most: 62,
    code: WHOLE,
    without: ['createElement', 'discardUnknown', 'WebGL', 'now-in-milliseconds'],
  },
  {
    name: 'with the checks of development',
    most: 74,
    code: WHOLE,
    conditions: ['development'],
    without: ['createElement', 'discardUnknown', 'WebGL'],
  },
  {
    name: 'both HUDs',
    most: 9,
    code: `export { createCockpitLandingHud, createFleetHud } from 'galaxy-touchdown/hud';`,
    without: ['discardUnknown', 'angularVelocity', 'WebGL'],
  },
  { name: 'their style sheet', most: 5, file: 'hud.css', without: [] },
  {
    name: 'protobuf messages',
    most: 30,
    code: `export { decodeServerMessage, encodeClientMessage } from 'galaxy-touchdown/protobuf';`,
    without: ['createElement', 'WebGL'],
  },
  {
    name: 'scene (without three)',
    most: 34,
    code: `export { createSceneView } from 'galaxy-touchdown/scene';`,
    without: ['discardUnknown'],
  },
];

/** Imports of which nothing may remain in a bundle. */
const NOTHING = [
  [`import 'galaxy-touchdown';`, 0],
  [`import 'galaxy-touchdown/hud'; import 'galaxy-touchdown/scene';`, 0],
  [`export { NEUTRAL_CONTROLS } from 'galaxy-touchdown';`, 400],
  [`export { updateFleetReadout } from 'galaxy-touchdown';`, 3000],
];

async function bundle(folder, code, conditions = ['production']) {
  const { build } = createRequire(import.meta.url)(tool('esbuild'));
  const { outputFiles } = await build({
    stdin: { contents: code, resolveDir: folder },
    bundle: true,
    minify: true,
    write: false,
    format: 'esm',
    target: 'es2022',
    logLevel: 'error',
    conditions,
    external: ['three', 'three/*'],
  });
  return outputFiles[0].text;
}

async function minifiedStyles(file) {
  const { transform } = createRequire(import.meta.url)(tool('esbuild'));
  return (await transform(readFileSync(file, 'utf8'), { loader: 'css', minify: true })).code;
}

export const gzipped = (text) => gzipSync(text, { level: 9 }).length;

/** `{ name, most, size }` of each use, size in bytes. */
export async function measure(folder) {
  const rows = [];
  for (const { name, most, code, conditions, file, without } of USES) {
    const text = file
      ? await minifiedStyles(join(folder, 'node_modules/galaxy-touchdown', file))
      : await bundle(folder, code, conditions);
    const strange = without.find((word) => text.includes(word));
    if (strange !== undefined) throw new Error(`${name}: its bundle contains “${strange}”`);
    rows.push({ name, most, size: gzipped(text) });
  }
  return rows;
}

/** Share by which the table may be off, so that it need not follow every change. */
const SLACK = 0.05;

/** Row of README.md's table of sizes: `| name | 12.3 kB |`. */
function statedSize(readme, name) {
  const row = readme.split('\n').find((line) => line.startsWith(`| ${name} `));
  return row === undefined ? NaN : Number(/\| +([\d.]+) kB/.exec(row)?.[1]);
}

/** Throws if a use is too large, unused code remains, or README.md gives another size than measured. */
export async function checkSizes(folder) {
  for (const [code, most] of NOTHING) {
    const text = await bundle(folder, code);
    if (text.length > most)
      throw new Error(
        `${code}\nleaves ${text.length} bytes, expected at most ${most}:\n${text.slice(0, 400)}`,
      );
  }
  const readme = readFileSync(join(root, 'README.md'), 'utf8');
  const rows = await measure(folder);
  for (const { name, most, size } of rows) {
    if (size > most * 1000) throw new Error(`${name}: ${size} bytes gzipped, expected at most ${most} kB`);
    const told = statedSize(readme, name);
    if (!(Math.abs(told * 1000 - size) <= Math.max(500, SLACK * size)))
      throw new Error(`${name}: README.md says ${told} kB, measured ${(size / 1000).toFixed(1)} kB`);
  }
  return rows.map(({ name, size }) => `${name} ${(size / 1000).toFixed(1)} kB`).join(', ');
}
