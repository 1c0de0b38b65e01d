/** The built page from a static host: it opens, draws, obeys the policy, is small, and shows a landing. */
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import type { Page } from 'playwright-core';
import { PNG } from 'pngjs';
import { afterAll, beforeAll, expect, inject, it } from 'vitest';
import { describeInBrowser, openBuiltPage, problemsOf } from '../pages';
import { shadesOf, untilStatus } from '../waits';

/** Largest size of an opened page's code, bytes with gzip, without terrain and models. */
const HEAVIEST = 300_000;
/** Files that the page fetches only on demand. */
const ON_DEMAND =
  /(help|plotting|replaying|sound|dock|settings|tabLink|bestRuns|flightLink|realServer|frameJson)-[\w-]+\.(js|css)$/;

/** Number of different colours in the scene, on a grid of every 16th pixel. */
async function coloursOf(page: Page): Promise<number> {
  await page.locator('#scene-view').evaluate((canvas) => {
    document.body.style.visibility = 'hidden';
    canvas.style.visibility = 'visible';
  });
  const { width, height, data } = PNG.sync.read(await page.locator('#scene-view').screenshot());
  await page.evaluate(() => (document.body.style.visibility = ''));
  const colours = new Set<number>();
  for (let y = 0; y < height; y += 16) {
    for (let x = 0; x < width; x += 16) colours.add(data.readUInt32BE((y * width + x) * 4));
  }
  return colours.size;
}

describeInBrowser('the built page', () => {
  let page: Page;
  beforeAll(async () => {
    // In slow motion: in the first mission the ship does not land before the last test.
    page = await openBuiltPage('?slow=0.1', { framesPerSecond: 1, deviceScaleFactor: 0.5 });
  });
  afterAll(() => page.context().close());

  it('opens under the strict policy, below the root of its host, and draws a scene', async () => {
    expect(await page.title()).toBe('Touchdown');
    // A cleared canvas has one colour, a sky without ground few.
    await expect.poll(() => coloursOf(page)).toBeGreaterThan(50);
    const hasWebGL2 = await page
      .locator('#scene-view')
      .evaluate((canvas) => (canvas as HTMLCanvasElement).getContext('webgl2') !== null);
    expect(hasWebGL2).toBe(true);
    expect(problemsOf(page)).toEqual([]);
  });

  // Once the page has its first picture and time to spare, its service worker fetches all of it again, plots too, to have it
  // without a network: twice the size, but no reader waits for it. It is not counted here.
  it(`weighs at most ${HEAVIEST / 1000} kB, apart from plots, replays and help, which load on demand`, async () => {
    await page.waitForSelector('html[data-ready=true]');
    const fetched = await page.evaluate(() =>
      performance.getEntriesByType('resource').map(({ name }) => new URL(name).pathname.split('/').at(-1)!),
    );
    expect(fetched.length).toBeGreaterThan(2);
    expect(fetched.filter((name) => ON_DEMAND.test(name))).toEqual([]);
    const folder = inject('builtFolder');
    const code = readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((name) =>
      /\.(html|js|css)$/.test(name),
    );
    const atOnce = code.filter((name) => !ON_DEMAND.test(name));
    expect(atOnce.length).toBeLessThan(code.length);
    const bytes = atOnce.map((name) => gzipSync(readFileSync(join(folder, name)), { level: 9 }).length);
    expect(bytes.reduce((sum, one) => sum + one, 0)).toBeLessThanOrEqual(HEAVIEST);
  });

  it('shows a landing: picture, displays, no error', async () => {
    await page.getByLabel('Mission', { exact: true }).selectOption('opening');
    await page.locator('summary', { hasText: 'Workshop' }).click();
    await page.getByLabel('Speed', { exact: true }).selectOption('4');
    await untilStatus(page, 'landed');
    expect(await page.textContent('.td-landing')).toContain('LANDED');
    expect(await page.textContent('.td-fleet')).toContain('LANDED');
    expect(await page.evaluate(() => document.querySelector('canvas')?.getContext('webgl2') !== null)).toBe(
      true,
    );
    expect(await shadesOf(page)).toBeGreaterThan(500);
    await page.waitForFunction(() =>
      document.getElementById('textAlternative')?.textContent.includes('landed'),
    );
    expect(problemsOf(page)).toEqual([]);
  });
});
