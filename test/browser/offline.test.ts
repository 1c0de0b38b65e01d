/** The built page with its host gone: not a browser told to be offline, but nobody at the address any more. */
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { expect, it, onTestFinished } from 'vitest';
import { describeInBrowser, openUrl, problemsOf } from './pages';
import { serveFolder } from './staticServer';
import type { StaticServer } from './staticServer';

const SMALL = { viewport: { width: 960, height: 540 } };
const BUILT = fileURLToPath(new URL('../../dist/page', import.meta.url));

/** A deployment of the built page that a test may change and take down. */
async function deploy(): Promise<StaticServer & { readonly edit: (file: string, text: string) => void }> {
  const folder = mkdtempSync(join(tmpdir(), 'touchdown-page-'));
  cpSync(BUILT, folder, { recursive: true });
  const server = await serveFolder(folder);
  onTestFinished(async () => {
    await server.close();
    rmSync(folder, { recursive: true });
  });
  const edit = (file: string, text: string) => writeFileSync(join(folder, file), text);
  return { ...server, edit };
}

const inBuild = (file: string) => readFileSync(join(BUILT, file), 'utf8');

async function untilKept(page: Page): Promise<void> {
  await page.waitForSelector('html[data-offline=kept]', { timeout: 60_000 });
}

async function openPlots(page: Page): Promise<void> {
  await page.locator('summary', { hasText: 'Plots' }).click({ timeout: 30_000 });
  await page.waitForSelector('.plots .uplot canvas', { timeout: 30_000 });
}

const cachesOf = (page: Page) => page.evaluate(() => caches.keys());

describeInBrowser('the built page, its host gone', () => {
  it('fetches nothing more: plots opened for the first time', { timeout: 120_000 }, async () => {
    const server = await deploy();
    const page = await openUrl(`${server.url}?scenario=settle&slow=4`, SMALL);
    await untilKept(page);
    await server.close();
    await openPlots(page);
    expect(problemsOf(page)).toEqual([]);
  });

  it('opens again, at any link to it, and lands', { timeout: 120_000 }, async () => {
    const server = await deploy();
    const page = await openUrl(`${server.url}?scenario=settle&slow=4`, SMALL);
    await untilKept(page);
    await server.close();
    await page.reload();
    await page.waitForSelector('html[data-status=landed]', { timeout: 60_000 });
    await page.goto(`${server.url}index.html?scenario=topple&seed=4&slow=4`);
    await page.waitForSelector('html[data-status=tipped]', { timeout: 60_000 });
    await openPlots(page);
  });

  it('shows a new deployment at once, and forgets the old one', { timeout: 150_000 }, async () => {
    const server = await deploy();
    const page = await openUrl(`${server.url}?scenario=settle&slow=4`, SMALL);
    await untilKept(page);
    const [first] = await cachesOf(page);
    server.edit('index.html', inBuild('index.html').replace('<title>Touchdown', '<title>Touchdown again'));
    server.edit(
      'offline.js',
      inBuild('offline.js').replace(/OFFLINE_VERSION = "\w+"/, 'OFFLINE_VERSION = "again"'),
    );
    await page.reload();
    expect(await page.title()).toBe('Touchdown again');
    // The new script waits until no page of the old one is open.
    await page.waitForFunction(async () => (await navigator.serviceWorker.ready).waiting !== null, null, {
      timeout: 60_000,
    });
    const later = await page.context().newPage();
    await page.close();
    const openedAgain = async () => {
      await later.goto('about:blank');
      await later.waitForTimeout(1000);
      await later.goto(`${server.url}?scenario=settle`);
      return cachesOf(later);
    };
    await expect.poll(openedAgain, { timeout: 60_000 }).toEqual([`touchdown ${server.url} again`]);
    expect(first).not.toBe(`touchdown ${server.url} again`);
    await server.close();
    await later.reload();
    expect(await later.title()).toBe('Touchdown again');
  });

  it(
    'plays on where the browser keeps nothing, and says what it cannot fetch',
    { timeout: 120_000 },
    async () => {
      const server = await deploy();
      const page = await openUrl(`${server.url}?scenario=settle`, { ...SMALL, serviceWorkers: 'block' });
      await page.waitForSelector('html[data-status=landed]', { timeout: 60_000 });
      expect(problemsOf(page)).toEqual([]);
      await server.close();
      await page.locator('summary', { hasText: 'Plots' }).click({ timeout: 30_000 });
      await page.waitForFunction(
        () => document.querySelector('.plots')?.textContent.includes('could not be fetched'),
        null,
        { timeout: 30_000 },
      );
      expect(await cachesOf(page)).toEqual([]);
    },
  );
});
