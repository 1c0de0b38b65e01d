/** The built page on hosts that are gone, hang, fail, answer wrongly, or have another build: each a real server of this test. */
import { createHash } from 'node:crypto';
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { expect, inject, it, onTestFinished } from 'vitest';
import { describeInBrowser, openUrl, problemsOf } from '../pages';
import type { PageOptions } from '../pages';
import { serveFolder } from '../staticServer';
import type { Fault, StaticServer } from '../staticServer';
import { KEPT, SMALL } from '../waits';

/** What is stored is the same without a scene, which takes half of each load. */
const KEPT_WITHOUT_SCENE = { ...KEPT, hasWebGL: false };

const BUILT = inject('builtFolder');

interface Deployment extends StaticServer {
  /** How the host misbehaves from now on. */
  fault: Fault;
  /** Deploys a build whose document differs: another title, and `edit` of its text. */
  deployAgain(edit?: (html: string) => string): void;
  /** Takes a file away. */
  remove(file: string): void;
}

/** A deployment of the built page that a test may change and take down. */
async function deploy(fault: Fault = () => false): Promise<Deployment> {
  const folder = mkdtempSync(join(tmpdir(), 'touchdown-page-'));
  cpSync(BUILT, folder, { recursive: true });
  const faulty = { fault };
  const server = await serveFolder(folder, (file, response) => faulty.fault(file, response));
  onTestFinished(async () => {
    await server.close();
    rmSync(folder, { recursive: true });
  });
  const read = (file: string) => readFileSync(join(folder, file), 'utf8');
  return Object.assign(faulty, server, {
    deployAgain(edit = (html: string) => html) {
      const old = read('index.html');
      const html = edit(old.replace('<title>Touchdown', '<title>Touchdown again'));
      const hash = (text: string) => createHash('sha256').update(text).digest('base64');
      writeFileSync(join(folder, 'index.html'), html);
      const script = read('offline.js').replace(hash(old), hash(html));
      writeFileSync(
        join(folder, 'offline.js'),
        script.replace(/OFFLINE_VERSION = "\w+"/, 'OFFLINE_VERSION = "again"'),
      );
    },
    remove: (file: string) => rmSync(join(folder, file)),
  });
}

async function untilStored(page: Page): Promise<void> {
  await page.waitForSelector('html[data-offline=ready]');
}

async function openPlots(page: Page): Promise<void> {
  await page.locator('summary', { hasText: 'Plots' }).click();
  await page.waitForSelector('.plots .uplot canvas');
}

/** Opens the page and waits until the browser has stored all of it. */
async function openAndKeep(server: Deployment, options: PageOptions = KEPT_WITHOUT_SCENE): Promise<Page> {
  const page = await openUrl(`${server.url}?scenario=settle&slow=4`, options);
  await untilStored(page);
  return page;
}

/** Waits until the page runs: its program is loaded and the world in its worker answers. */
async function untilRunning(page: Page): Promise<void> {
  await page.waitForSelector('html[data-status]');
}

interface InstallationWindow {
  /** Final state of the worker that the page registered first: 'installed' or 'redundant'. */
  installed: Promise<ServiceWorkerState>;
}

/** Runs in the page before its own scripts. */
function noteInstallation(): void {
  const { serviceWorker } = navigator;
  const register = serviceWorker.register.bind(serviceWorker);
  const installed = new Promise<ServiceWorkerState>((resolve) => {
    serviceWorker.register = async (...given) => {
      const registration = await register(...given);
      const worker = registration.installing;
      worker?.addEventListener('statechange', () => resolve(worker.state), { once: true });
      return registration;
    };
  });
  Object.assign(window, { installed });
}

const cachesOf = (page: Page) => page.evaluate(() => caches.keys());
const workersOf = (page: Page) =>
  page.evaluate(async () => {
    const registration = await navigator.serviceWorker.getRegistration();
    const { installing = null, waiting = null, active = null } = registration ?? {};
    return Object.entries({ installing, waiting, active }).flatMap(([name, worker]) =>
      worker ? [name] : [],
    );
  });
const isOffline = async (page: Page) =>
  page.evaluate(async () => (await navigator.serviceWorker.getRegistrations()).length > 0);

describeInBrowser('the built page without its host', () => {
  it('opens at any link to it, lands, and fetches nothing more when plots are first opened', async () => {
    const server = await deploy();
    const page = await openAndKeep(server, KEPT);
    await server.close();
    await page.goto(`${server.url}index.html?scenario=settle&seed=4&slow=4`);
    await page.waitForSelector('html[data-status=landed]');
    await openPlots(page);
    expect(problemsOf(page)).toEqual([]);
  });

  it('runs where the browser stores nothing, and names what it cannot fetch', async () => {
    const server = await deploy();
    const page = await openUrl(`${server.url}?scenario=settle&slow=4`, SMALL);
    await page.waitForSelector('html[data-status=landed]');
    expect(problemsOf(page)).toEqual([]);
    await server.close();
    await page.locator('summary', { hasText: 'Plots' }).click();
    await page.locator('.plots', { hasText: /could not be|did not load/ }).waitFor();
    expect(await cachesOf(page)).toEqual([]);
  });
});

describeInBrowser('the built page with a failing host', () => {
  it('shows the stored page when the host accepts and never answers, or answers 5xx', async () => {
    const server = await deploy();
    const page = await openAndKeep(server);
    server.fault = () => true;
    await page.goto(`${server.url}?scenario=settle`, { waitUntil: 'commit' });
    // Without the page's own limit the browser waits for longer than this test may take.
    await untilRunning(page);
    server.fault = (_, response) => {
      response.writeHead(503, { 'Content-Type': 'text/html' }).end('<h1>Down for maintenance</h1>');
      return true;
    };
    await page.goto(`${server.url}?scenario=slide`);
    await untilRunning(page);
  });

  it('stores nothing from a host that answers a script with a document, and stores the page once the host works', async () => {
    const server = await deploy();
    server.fault = (file, response) => {
      // The page gets the real script; the worker, which requests all files to store them, gets a document.
      if (!file.startsWith('assets/plotting')) return false;
      response.writeHead(200, { 'Content-Type': 'text/html' }).end('<p>Sign in</p>');
      return true;
    };
    // Observed from the start: a failed worker leaves no registration.
    const prepare = (opened: Page) => opened.addInitScript(noteInstallation);
    const page = await openUrl(`${server.url}?scenario=settle`, { ...KEPT_WITHOUT_SCENE, prepare });
    await untilRunning(page);
    const settled = page.evaluate(() => (window as unknown as InstallationWindow).installed);
    expect(await settled).toBe('redundant');
    expect(await cachesOf(page)).toEqual([]);
    server.fault = () => false;
    await page.reload();
    await untilStored(page);
  });

  it('fetches again what the browser evicted', async () => {
    const server = await deploy();
    const page = await openAndKeep(server);
    const storedFiles = () =>
      page.evaluate(async () => (await (await caches.open((await caches.keys())[0]!)).keys()).length);
    const all = await storedFiles();
    await page.evaluate(async () => {
      const cache = await caches.open((await caches.keys())[0]!);
      for (const request of await cache.keys()) if (request.url.endsWith('.js')) await cache.delete(request);
    });
    expect(await storedFiles()).toBeLessThan(all);
    await page.reload();
    await expect.poll(storedFiles).toBe(all);
  });

  it('lets the host switch it off for good: without offline.js nothing stays stored', async () => {
    const server = await deploy();
    const page = await openAndKeep(server);
    server.remove('offline.js');
    await page.reload();
    await expect.poll(() => cachesOf(page)).toEqual([]);
    expect(await isOffline(page)).toBe(false);
  });
});

describeInBrowser('the built page after a new deployment', () => {
  it('shows the new build on the second load at the latest, whole and without a network', async () => {
    const server = await deploy();
    const page = await openAndKeep(server);
    server.deployAgain();
    await page.reload();
    await expect.poll(() => cachesOf(page)).toContain(`touchdown ${server.url} again`);
    await expect.poll(() => workersOf(page)).toEqual(['active']);
    await server.close();
    await page.reload();
    expect(await page.title()).toBe('Touchdown again');
    await untilRunning(page);
  });

  it('shows the old build, complete, while a script of the new one cannot be fetched', async () => {
    const server = await deploy();
    const page = await openAndKeep(server);
    server.deployAgain((html) => html.replace(/assets\/index-[\w-]+\.js/, 'assets/index-gone.js'));
    await page.reload();
    expect(await page.title()).toBe('Touchdown');
    await untilRunning(page);
  });
});
