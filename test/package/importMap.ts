/**
 * Loads every door of the built package in a real browser: an import map, no bundler, no shims.
 *   node test/run.mjs test/package/importMap.ts FOLDER    with the package in FOLDER
 */
import { existsSync, readFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import { findChromium, launchChromium } from '../browser/chromium';

const HOST = 'http://page.test/';
const TYPES: Record<string, string> = { '.js': 'text/javascript', '.css': 'text/css', '.html': 'text/html' };
const DOORS = ['index', 'protobuf', 'hud', 'scene', 'game'];

const folder = process.argv[2]!;
const doors = DOORS.filter((door) => existsSync(join(folder, `${door}.js`)));
const nameOf = (door: string) => (door === 'index' ? 'galaxy-touchdown' : `galaxy-touchdown/${door}`);

const imports = {
  ...Object.fromEntries(doors.map((door) => [nameOf(door), `/package/${door}.js`])),
  three: '/three/three.module.js',
};
const page = `<!doctype html>
<link rel="stylesheet" href="/package/hud.css">
<link rel="icon" href="data:,">
<script type="importmap">${JSON.stringify({ imports })}</script>
<body><script type="module">
${doors.map((door, i) => `import * as d${String(i)} from '${nameOf(door)}';`).join('\n')}
const predictor = d0.createPredictor({ ownShipId: 'a' });
const hud = d${String(doors.indexOf('hud'))}.createCockpitLandingHud(document, document.body);
hud.paint(d0.updateLandingReadout(d0.createLandingReadout(), predictor.view(0)));
const bytes = d${String(doors.indexOf('protobuf'))}.encodeClientMessage({ kind: 'ping', id: 7 });
document.title = [${doors.map((_, i) => `Object.keys(d${String(i)}).length`).join()}, bytes.length].join();
</script></body>`;

/** The file that a path of the page means. */
function contentOf(path: string): Buffer | string | null {
  if (path === '') return page;
  const file = path.startsWith('three/')
    ? join('node_modules/three/build', path.slice('three/'.length))
    : join(folder, path.slice('package/'.length));
  return existsSync(file) ? readFileSync(file) : null;
}

const program = await findChromium();
if (program === null) throw new Error('no Chromium: install one, or name one in CHROMIUM');
const browser = await launchChromium(program);
try {
  const tab = await browser.newPage();
  const problems: string[] = [];
  tab.on('pageerror', (error) => problems.push(error.message));
  tab.on('console', (message) => {
    if (message.type() === 'error') problems.push(message.text());
  });
  await tab.route(`${HOST}**`, async (route) => {
    const path = new URL(route.request().url()).pathname.slice(1);
    const body = contentOf(path);
    const contentType = TYPES[extname(path) || '.html'] ?? 'application/octet-stream';
    await route.fulfill(body === null ? { status: 404 } : { body, contentType });
  });
  await tab.goto(HOST);
  const title = await tab.title();
  const words = (await tab.locator('.td-status').count()) === 1 ? await tab.textContent('.td-status') : '';
  if (problems.length > 0 || !/^\d+(,\d+)+$/.test(title) || words !== '◌NO DATA')
    throw new Error(`the page with an import map: ${problems.join('; ') || `${title} ${String(words)}`}`);
  console.log(`an import map in Chromium ${browser.version()} without a bundler: ${doors.join(', ')}`);
} finally {
  await browser.close();
}
