/**
 * Before the browser tests: finds a Chromium and starts one per core (all pages of one draw in a single thread), builds the page
 * and serves it, and starts a development server for the pages of test/browser/pages. Without a Chromium the tests are skipped and counted.
 */
import { execFile } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { availableParallelism, tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { createServer } from 'vite';
import type { ViteDevServer } from 'vite';
import type { TestProject } from 'vitest/node';
import { mutation } from '../mutants/plugins.mjs';
import { findChromium, serveChromium } from './chromium';
import { serveFolder } from './staticServer';

declare module 'vitest' {
  interface ProvidedContext {
    /** Addresses of the browsers that the test files share; empty if the browser tests are skipped. */
    chromium: readonly string[];
    /** Address of the built page under the strict content security policy, ending with a slash. */
    builtPage: string;
    /** Path of the folder that it is served from. */
    builtFolder: string;
    /** Address of the development server whose root is the repository, ending with a slash. */
    devServer: string;
  }
}

const ROOT = fileURLToPath(new URL('../..', import.meta.url));

const OPENS_BUILT_PAGE = /\b(openBuiltPage|builtPage|builtFolder)\b/;

/** Builds the page as `npm run build` does, in a separate process: vitest's NODE_ENV would make it a test build. */
async function buildPage(...args: string[]): Promise<void> {
  const env = { ...process.env };
  for (const key of Object.keys(env)) if (/^(NODE_ENV|VITEST.*)$/.test(key)) Reflect.deleteProperty(env, key);
  try {
    await promisify(execFile)(process.execPath, args, { cwd: ROOT, env });
  } catch (error) {
    const { stdout, stderr } = error as { stdout: string; stderr: string };
    throw new Error(`the page does not build:\n${stdout}${stderr}`, { cause: error });
  }
}

/** Where the page is built to, and how. Each runner of test/mutants has a folder of its own. */
function builtPage(): { folder: string; build: () => Promise<void>; remove: () => void } {
  if (process.env['TOUCHDOWN_MUTANT'] === undefined) {
    const build = () => buildPage('.ci/build.mjs', 'page');
    return { folder: `${ROOT}dist/page`, build, remove: () => undefined };
  }
  const folder = mkdtempSync(join(tmpdir(), 'touchdown-page-'));
  const build = () => buildPage('test/mutants/buildPage.mjs', folder);
  return { folder, build, remove: () => rmSync(folder, { recursive: true }) };
}

function startDevServer(): Promise<ViteDevServer> {
  return createServer({
    configFile: false,
    root: ROOT,
    publicDir: 'public',
    plugins: mutation(),
    logLevel: 'error',
    cacheDir: 'node_modules/.cache/touchdown/dev-server',
    // If these were found one by one, each would reload the page under a running test.
    optimizeDeps: { include: ['three', 'gl-matrix', 'protobufjs/minimal', 'uplot'], entries: [] },
    server: { host: '127.0.0.1', port: 0, hmr: false, watch: null },
    appType: 'mpa',
  }).then((server) => server.listen());
}

/** Prints the number of skipped tests; where nothing may be skipped it throws. */
function skipped(project: TestProject): () => void {
  return () => {
    const modules = project.vitest.state.getTestModules().filter((module) => module.project === project);
    const count = modules.flatMap((module) => [...module.children.allTests('skipped')]).length;
    console.log(`browser tests: ${count} skipped, no Chromium found (install one, or name one in CHROMIUM)`);
  };
}

export default async function setup(project: TestProject): Promise<() => void | Promise<void>> {
  const program = await findChromium();
  if (program === null) {
    if (process.env['CI'] || process.env['TOUCHDOWN_NO_SKIP']) {
      throw new Error(
        'no Chromium found, and nothing may be skipped here: install one, or name one in CHROMIUM',
      );
    }
    project.provide('chromium', []);
    project.provide('builtPage', '');
    project.provide('builtFolder', '');
    project.provide('devServer', '');
    return skipped(project);
  }
  const page = builtPage();
  const [built, dev, ...browsers] = await Promise.all([
    page.build().then(() => serveFolder(page.folder)),
    startDevServer(),
    ...Array.from({ length: availableParallelism() }, () => serveChromium(program)),
  ]);
  project.provide(
    'chromium',
    browsers.map((browser) => browser.wsEndpoint()),
  );
  project.provide('builtPage', built.url);
  project.provide('builtFolder', page.folder);
  project.provide('devServer', dev.resolvedUrls?.local[0] ?? '');
  // The source may have changed since the last run.
  project.onTestsRerun(async (files) => {
    for (const { moduleGraph } of Object.values(dev.environments)) moduleGraph.invalidateAll();
    if (files.some(({ moduleId }) => OPENS_BUILT_PAGE.test(readFileSync(moduleId, 'utf8'))))
      await page.build();
  });
  return async () => {
    await Promise.all([built, dev, ...browsers].map((running) => running.close()));
    page.remove();
  };
}
