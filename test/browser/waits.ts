import type { Page } from 'playwright-core';
import { PNG } from 'pngjs';

/** For a test of anything but the picture: nothing is drawn, nothing kept for offline use, and no more frames than a test can tell apart. */
export const SMALL = {
  viewport: { width: 960, height: 540 },
  deviceScaleFactor: 0.5,
  framesPerSecond: 4,
  drawn: false,
  serviceWorkers: 'block',
} as const;

/** Frames enough for what the page does by itself in each of them, like steering. */
export const FLUENT = { ...SMALL, deviceScaleFactor: 0.25, framesPerSecond: 15 } as const;

/** For a test of what is kept for offline use. */
export const KEPT = { ...SMALL, serviceWorkers: 'allow' } as const;

/** As on a slow display, whose frames are further apart than the server's states. */
export const SLOW = { ...SMALL, framesPerSecond: 2 } as const;

/** Not once per frame, which on a slow display are far apart. */
export const PATIENT = { polling: 50 };

/** What the page shows of its game, for the first line of a failure. */
function shownBy(page: Page): Promise<string> {
  return page.evaluate(() => {
    const { status = 'no status', provenance = '', phase = '' } = document.documentElement.dataset;
    const tilt = document.querySelector('.td-landing [role=meter][aria-label=Tilt]');
    const words = ['banner', 'notice'].map(
      (id) => `${id} "${document.getElementById(id)?.textContent ?? ''}"`,
    );
    return [
      status,
      provenance,
      phase,
      `tilt ${tilt?.getAttribute('aria-valuenow') ?? 'unknown'}`,
      ...words,
    ].join(', ');
  });
}

/** @throws Error that says what was waited for and what the page shows instead */
async function explain(page: Page, wanted: string, waiting: Promise<unknown>): Promise<void> {
  try {
    await waiting;
  } catch (error) {
    const instead = page.isClosed() ? 'the page is closed' : `the page shows: ${await shownBy(page)}`;
    throw new Error(`waited for ${wanted}; ${instead}`, { cause: error });
  }
}

/** Until the own ship is shown in a state; the software renderer may take seconds a frame beside other work. */
export function untilStatus(page: Page, ...wanted: string[]): Promise<void> {
  const waiting = page.waitForFunction(
    (states) => states.includes(document.documentElement.dataset['status'] ?? ''),
    wanted,
    PATIENT,
  );
  return explain(page, `status ${wanted.join(' or ')}`, waiting);
}

export function untilProvenance(page: Page, wanted: string): Promise<void> {
  const waiting = page.waitForFunction(
    (state) => document.documentElement.dataset['provenance'] === state,
    wanted,
    PATIENT,
  );
  return explain(page, `provenance ${wanted}`, waiting);
}

export function untilPhase(page: Page, wanted: string): Promise<void> {
  const waiting = page.waitForFunction(
    (phase) => document.documentElement.dataset['phase'] === phase,
    wanted,
    PATIENT,
  );
  return explain(page, `phase ${wanted}`, waiting);
}

/** Until the display's tilt gauge reads less than `angle` degrees. */
export function untilTiltBelow(page: Page, angle: number): Promise<void> {
  const waiting = page.waitForFunction(
    (most) => {
      const meter = document.querySelector('.td-landing [role=meter][aria-label=Tilt]');
      return Number(meter?.getAttribute('aria-valuenow') ?? 90) < most;
    },
    angle,
    { polling: 'raf' },
  );
  return explain(page, `a tilt below ${angle}°`, waiting);
}

/** How many different colours the middle of the picture has, which no panel covers. */
export async function shadesOf(page: Page): Promise<number> {
  const png = PNG.sync.read(await page.locator('#stage').screenshot());
  const shades = new Set<number>();
  for (let y = Math.round(png.height * 0.14); y < png.height * 0.77; y += 4)
    for (let x = Math.round(png.width * 0.3); x < png.width * 0.7; x += 4)
      shades.add(png.data.readUInt32BE((y * png.width + x) * 4));
  return shades.size;
}

/** Until the banner says all of these at once, among others. */
export function untilBanner(page: Page, ...words: string[]): Promise<void> {
  const waiting = page.waitForFunction(
    (wanted) => {
      const said = document.getElementById('banner')?.textContent ?? '';
      return wanted.every((text) => said.includes(text));
    },
    words,
    PATIENT,
  );
  return explain(page, `a banner with "${words.join('" and "')}"`, waiting);
}

/** Until the page has laid out and drawn what was changed before. */
export async function untilDrawn(page: Page): Promise<void> {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}
