import type { Page } from 'playwright-core';
import { PNG } from 'pngjs';

/** A picture that the software renderer has little work with: few pixels, and no more frames than a test can tell apart. */
export const SMALL = { viewport: { width: 960, height: 540 }, deviceScaleFactor: 0.5, framesPerSecond: 2 };

/** As many frames as the renderer gives, of few pixels. */
export const FLUENT = { viewport: { width: 960, height: 540 }, deviceScaleFactor: 0.5 };

/** Not once per frame, which on a slow display are far apart. */
export const PATIENT = { timeout: 60_000, polling: 50 };

/** Until the own ship is shown in a state; the software renderer may take seconds a frame beside other work. */
export async function untilStatus(page: Page, ...wanted: string[]): Promise<void> {
  await page.waitForFunction(
    (states) => states.includes(document.documentElement.dataset['status'] ?? ''),
    wanted,
    PATIENT,
  );
}

export async function untilProvenance(page: Page, wanted: string): Promise<void> {
  await page.waitForFunction(
    (state) => document.documentElement.dataset['provenance'] === state,
    wanted,
    PATIENT,
  );
}

/** Until the display's tilt gauge reads less than `angle` degrees. */
export async function untilTiltBelow(page: Page, angle: number): Promise<void> {
  await page.waitForFunction(
    (most) => {
      const meter = document.querySelector('.td-landing [role=meter][aria-label=Tilt]');
      return Number(meter?.getAttribute('aria-valuenow') ?? 90) < most;
    },
    angle,
    { timeout: 60_000, polling: 'raf' },
  );
}

/** How many different colours the middle of the picture has, which no panel covers. */
export async function shadesOf(page: Page): Promise<number> {
  const png = PNG.sync.read(await page.locator('#stage').screenshot({ timeout: 60_000 }));
  const shades = new Set<number>();
  for (let y = Math.round(png.height * 0.14); y < png.height * 0.77; y += 4)
    for (let x = Math.round(png.width * 0.3); x < png.width * 0.7; x += 4)
      shades.add(png.data.readUInt32BE((y * png.width + x) * 4));
  return shades.size;
}

/** Until the banner says these words, among others. */
export async function untilBanner(page: Page, words: string): Promise<void> {
  await page.waitForFunction(
    (wanted) => document.getElementById('banner')?.textContent.includes(wanted),
    words,
    PATIENT,
  );
}

/** Until the page has laid out and drawn what was changed before. */
export async function untilDrawn(page: Page): Promise<void> {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}
