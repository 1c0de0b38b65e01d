import type { Page } from 'playwright-core';
import { PNG } from 'pngjs';

/** Options for tests of anything but the picture: nothing is drawn, nothing is stored for offline use, and only a few frames. */
export const SMALL = {
  viewport: { width: 960, height: 540 },
  deviceScaleFactor: 0.5,
  framesPerSecond: 4,
  drawn: false,
  serviceWorkers: 'block',
} as const;

/** The same with enough frames for work done per frame, like steering. */
export const FLUENT = { ...SMALL, deviceScaleFactor: 0.25, framesPerSecond: 15 } as const;

/** Options for tests of neither picture nor camera: the page has no scene. */
export const ON_INSTRUMENTS = { ...SMALL, hasWebGL: false } as const;

/** Options for tests of what is stored for offline use. */
export const KEPT = { ...SMALL, serviceWorkers: 'allow' } as const;

/** A slow display, whose frames are further apart than the server's states. */
export const SLOW = { ...SMALL, framesPerSecond: 2 } as const;

/** Not per frame: on a slow display frames are far apart. */
export const PATIENT = { polling: 50 };

/** The page's state of the game, for the first line of a failure. */
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

/** @throws Error that names what was waited for and what the page shows instead */
async function explain(page: Page, wanted: string, waiting: Promise<unknown>): Promise<void> {
  try {
    await waiting;
  } catch (error) {
    const instead = page.isClosed() ? 'the page is closed' : `the page shows: ${await shownBy(page)}`;
    throw new Error(`waited for ${wanted}; ${instead}`, { cause: error });
  }
}

/** Waits until the player's ship is shown in a state; under load the software renderer may take seconds per frame. */
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

/** Waits until the tilt gauge reads less than `angle` degrees. */
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

/** Number of different colours in the middle of the picture, which no panel covers. */
export async function shadesOf(page: Page): Promise<number> {
  const png = PNG.sync.read(await page.locator('#scene-view').screenshot());
  const shades = new Set<number>();
  for (let y = Math.round(png.height * 0.14); y < png.height * 0.77; y += 4)
    for (let x = Math.round(png.width * 0.3); x < png.width * 0.7; x += 4)
      shades.add(png.data.readUInt32BE((y * png.width + x) * 4));
  return shades.size;
}

/** Waits until the banner shows all of these. */
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

/** Waits until the page has laid out and drawn earlier changes. */
export async function untilDrawn(page: Page): Promise<void> {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}
