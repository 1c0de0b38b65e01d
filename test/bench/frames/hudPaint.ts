/**
 * Cost of the HUDs per frame in the real browser: readout, and painting (script alone, then with its style and layout).
 * The page is that of the browser tests, built like the playground.
 */
import { resolve } from 'node:path';
import type { Browser } from 'playwright-core';
import { build } from 'vite';
import { serveFolder } from '../../browser/staticServer';
import { type Figure, figure } from '../measure';

/** The figure is their median. */
const ROUNDS = 15;
const PAGES = resolve('test/browser/pages');
const FOLDER = resolve('node_modules/.cache/touchdown/hudPage');

interface TimedWindow {
  hud: { showFleet: (size: number) => void; time: (rounds: number) => Record<string, number[]> };
}

/** Builds the page of HUD states and serves it. */
export async function serveHudPage(): Promise<{ url: string; close: () => Promise<void> }> {
  await build({
    configFile: false,
    root: PAGES,
    base: './',
    logLevel: 'warn',
    build: {
      target: 'es2022',
      outDir: FOLDER,
      emptyOutDir: true,
      modulePreload: false,
      rolldownOptions: { input: resolve(PAGES, 'hud.html'), output: { topLevelVar: false } },
    },
  });
  return serveFolder(FOLDER);
}

/** @param url of a folder with the page of HUD states, ending with a slash: serveHudPage gives one */
export async function hudPaintFigures(browser: Browser, url: string): Promise<Figure[]> {
  const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, locale: 'en-US' });
  try {
    const page = await context.newPage();
    await page.goto(`${url}hud.html`);
    await page.waitForSelector('html[data-ready=true]');
    await page.evaluate(() => (window as unknown as TimedWindow).hud.showFleet(1000));
    await page.waitForSelector('.td-row:nth-child(12)');
    const took = await page.evaluate((n) => (window as unknown as TimedWindow).hud.time(n), ROUNDS);
    return Object.entries(took).map(([name, rounds]) => inMicroseconds(name, rounds));
  } finally {
    await context.close();
  }
}

/** In µs: a figure in ms has too few decimals for some microseconds per frame. */
function inMicroseconds(name: string, rounds: readonly number[]): Figure {
  return figure(
    name,
    'µs',
    rounds.map((ms) => ms * 1000),
  );
}
