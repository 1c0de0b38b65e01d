/**
 * npm run bench:frames: main-thread time of a frame of the built page, from the browser's tracing. A table, or with
 * --json one line of JSON per figure. "script" is the thread's CPU time, which other programs change little; "script-wall"
 * includes its waiting. Both include what the browser and its tracing take for a frame without a script, about 0.1 ms.
 *
 * The browser here draws in software, a few frames per second; a frame then has a large part of a second of the game to
 * process, in code that rarely runs. So each scene is measured twice: as it is ("drawn"), and with the triangles
 * left out but all other WebGL calls made, at the display's rate, like on a machine with a fast GPU. The HUDs' text is painted
 * directly: through the software GPU it would leave 5 to 20 frames per second, with caches cold at each. First the opening on
 * a cold cache, until the first picture and the first input. Last the HUDs alone, which take so little time that many
 * paintings are timed together.
 */
import { mkdirSync } from 'node:fs';
import { resolve } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { build } from 'vite';
import { findChromium, launchChromium, PAINT_DIRECTLY } from '../browser/chromium';
import { serveFolder } from '../browser/staticServer';
import { hudPaintFigures, serveHudPage } from './frames/hudPaint';
import { leaveOutTriangles } from '../browser/webgl';
import { openingFigures } from './frames/opening';
import { type FrameFigure, frameFigures, type TraceEvent } from './frames/trace';
import type { Figure } from './measure';

interface Show {
  readonly name: string;
  readonly query: string;
  readonly drawn: boolean;
}

const SHOWS: readonly Show[] = [
  { name: 'one-ship', query: '?scenario=opening', drawn: false },
  { name: 'ships-200', query: '?scenario=opening&fleet=199', drawn: false },
  { name: 'one-ship-drawn', query: '?scenario=opening', drawn: true },
  { name: 'ships-200-drawn', query: '?scenario=opening&fleet=199', drawn: true },
];
/** Wall seconds: of running before the trace, so that the page is compiled, and of the trace, from the top of the show. */
const WARM_UP = 12;
const TRACED = 12;
const WINDOW = { width: 1280, height: 720 };
const asJson = process.argv.includes('--json');

async function trace(browser: Browser, page: Page): Promise<TraceEvent[]> {
  await browser.startTracing(page, { categories: ['devtools.timeline'] });
  await page.keyboard.press('r');
  await page.waitForTimeout(TRACED * 1000);
  const told = await browser.stopTracing();
  return (JSON.parse(told.toString()) as { traceEvents: TraceEvent[] }).traceEvents;
}

async function measure(browser: Browser, url: string, { name, query, drawn }: Show): Promise<FrameFigure[]> {
  const context = await browser.newContext({ viewport: WINDOW, locale: 'en-US' });
  const page = await context.newPage();
  if (!drawn) await page.addInitScript(leaveOutTriangles);
  await page.goto(url + query);
  await page.waitForSelector('html[data-ready=true]', { state: 'attached', timeout: 120_000 });
  await page.waitForTimeout(WARM_UP * 1000);
  const figures = frameFigures(name, await trace(browser, page));
  await context.close();
  return figures;
}

function print(figure: FrameFigure): void {
  if (asJson) console.log(JSON.stringify(figure));
  else {
    const { name, frames, p50, p95, max } = figure;
    const columns = [p50, p95, max].map((value) => value.toFixed(2).padStart(9));
    console.log(`${name.padEnd(27)} ${columns.join(' ')} ms  ${frames} frames`);
  }
}

function printFigure(figure: Figure): void {
  const { name, unit, median, min, max } = figure;
  if (asJson) console.log(JSON.stringify(figure));
  else
    console.log(
      `${name.padEnd(27)} ${median.toFixed(1).padStart(9)} ${unit} (${String(min)} … ${String(max)})`,
    );
}

async function main(): Promise<void> {
  const program = await findChromium();
  if (program === null) throw new Error('no Chromium to measure in: set CHROMIUM to one');
  const folder = resolve('node_modules/.cache/touchdown/framesPage');
  mkdirSync(folder, { recursive: true });
  await build({ logLevel: 'warn', build: { outDir: folder, emptyOutDir: true } });
  const server = await serveFolder(folder);
  const huds = await serveHudPage();
  const browser = await launchChromium(program, PAINT_DIRECTLY);
  if (!asJson)
    console.log(`${''.padEnd(27)} ${['p50', 'p95', 'max'].map((word) => word.padStart(9)).join(' ')}`);
  try {
    (await openingFigures(browser, server.url)).forEach(printFigure);
    for (const show of SHOWS) (await measure(browser, server.url, show)).forEach(print);
    (await hudPaintFigures(browser, huds.url)).forEach(printFigure);
  } finally {
    await browser.close();
    await server.close();
    await huds.close();
  }
}

await main();
