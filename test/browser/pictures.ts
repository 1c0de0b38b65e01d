/**
 * npm run pictures: builds the page, opens it in the browser of the tests and takes the README's pictures into public/pictures.
 * JPEG, because grain and dust make a PNG ten times as large.
 */
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import type { Browser } from 'playwright-core';
import { build } from 'vite';
import { findChromium, launchChromium } from './chromium';
import { serveFolder } from './staticServer';

interface Picture {
  readonly name: string;
  readonly query: string;
  /** Game seconds since the world began. */
  readonly at: number;
  readonly panels: boolean;
}

const PICTURES: readonly Picture[] = [
  { name: 'opening', query: 'scenario=opening', at: 14, panels: true },
  { name: 'touch', query: 'scenario=bounce', at: 0.9, panels: false },
  { name: 'slide', query: 'scenario=slide-mars', at: 1.9, panels: false },
  { name: 'tipped', query: 'scenario=topple', at: 8, panels: true },
  { name: 'freighter', query: 'scenario=freighter-hold', at: 2.5, panels: false },
  { name: 'phobos', query: 'scenario=settle-phobos', at: 12, panels: false },
  { name: 'earth', query: 'scenario=settle-earth&ship=fast_frigate', at: 6, panels: false },
];

async function take(browser: Browser, url: string, picture: Picture, folder: string): Promise<void> {
  const context = await browser.newContext({
    viewport: { width: 1280, height: 720 },
    colorScheme: 'dark',
    locale: 'en-US',
  });
  const page = await context.newPage();
  // Slow, so that a software renderer stops near the requested moment.
  const slow = picture.at > 6 ? 1 : 0.1;
  await page.goto(`${url}?${picture.query}&picture=fine&slow=${slow}&freeze=${picture.at}`);
  // The page handles keys from the first report on.
  await page.waitForSelector('html[data-status]', { timeout: 120_000 });
  if (!picture.panels) await page.keyboard.press('h');
  await page.waitForSelector('html[data-frozen=true]', { timeout: 400_000 });
  const path = join(folder, `${picture.name}.jpg`);
  await page.screenshot({ path, type: 'jpeg', quality: 80, timeout: 180_000 });
  console.log(`${picture.name}: ${(await page.getAttribute('html', 'data-status')) ?? ''}`);
  await context.close();
}

async function main(): Promise<void> {
  const wished = process.argv.slice(2);
  const program = await findChromium();
  if (program === null) throw new Error('no Chromium to take pictures with: set CHROMIUM to one');
  await build({ logLevel: 'warn' });
  const folder = 'public/pictures';
  mkdirSync(folder, { recursive: true });
  const server = await serveFolder('dist/page');
  const browser = await launchChromium(program);
  try {
    for (const picture of PICTURES)
      if (wished.length === 0 || wished.includes(picture.name))
        await take(browser, server.url, picture, folder);
  } finally {
    await browser.close();
    await server.close();
  }
}

await main();
