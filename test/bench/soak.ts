/**
 * npm run soak -- [minutes]: the built page, left alone with a fleet of 200 ships, 30 minutes by default. Prints the heap
 * of the page and of the worker that plays the server, each after a forced collection, and the growth from beginning to end.
 * Fails if the growth exceeds MAX_GROWTH. Triangles are skipped and all other WebGL calls made, for a higher frame rate.
 */
import { mkdirSync } from 'node:fs';
import { resolve } from 'node:path';
import type { CDPSession } from 'playwright-core';
import { build } from 'vite';
import { findChromium, launchChromium } from '../browser/chromium';
import { serveFolder } from '../browser/staticServer';
import { leaveOutTriangles } from '../browser/webgl';
import { createHeapReader, type HeapReader } from './frames/heapReader';

const FLEET = 199;
/** s from the first picture to the first reading: by then code is compiled, and plots and history have their full length. */
const WARM_UP = 60;
/** MB. */
const MAX_GROWTH = 20;
const READ_EVERY = 60;

const minutes = Number(process.argv[2] ?? 30);
if (!(minutes > 0)) throw new Error(`minutes: expected a number above 0, got ${process.argv[2] ?? ''}`);

async function soak(reader: HeapReader, wait: (seconds: number) => Promise<void>): Promise<number> {
  await wait(WARM_UP);
  const began = await reader.read();
  print(0, began);
  const total = minutes * 60;
  for (let passed = 0; passed < total;) {
    const step = Math.min(READ_EVERY, total - passed);
    await wait(step);
    passed += step;
    print(passed / 60, await reader.read());
  }
  const ended = await reader.read();
  return ended.page + ended.workers - began.page - began.workers;
}

function print(at: number, { page, workers, frames }: Awaited<ReturnType<HeapReader['read']>>): void {
  const columns = [at.toFixed(1), page.toFixed(1), workers.toFixed(1), String(frames)];
  console.log(columns.map((text) => text.padStart(10)).join(' '));
}

async function main(): Promise<void> {
  const program = await findChromium();
  if (program === null) throw new Error('no Chromium to measure in: set CHROMIUM to one');
  const folder = resolve('node_modules/.cache/touchdown/soakPage');
  mkdirSync(folder, { recursive: true });
  await build({ logLevel: 'warn', build: { outDir: folder, emptyOutDir: true } });
  const server = await serveFolder(folder);
  const browser = await launchChromium(program);
  try {
    const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, locale: 'en-US' });
    const page = await context.newPage();
    await page.addInitScript(leaveOutTriangles);
    const session: CDPSession = await context.newCDPSession(page);
    const reader = await createHeapReader(session, page);
    await page.goto(`${server.url}?scenario=opening&fleet=${FLEET}`);
    await page.waitForSelector('html[data-ready=true]', { state: 'attached', timeout: 120_000 });
    console.log(['minutes', 'page MB', 'worker MB', 'frames'].map((word) => word.padStart(10)).join(' '));
    const growth = await soak(reader, (seconds) => page.waitForTimeout(seconds * 1000));
    console.log(`growth ${growth.toFixed(1)} MB in ${minutes} minutes, at most ${MAX_GROWTH} allowed`);
    if (growth > MAX_GROWTH) process.exitCode = 1;
  } finally {
    await browser.close();
    await server.close();
  }
}

await main();
