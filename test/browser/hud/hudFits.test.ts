/** Each HUD state at its place in the playground: nothing is clipped, nothing overlaps. */
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { misfits } from './misfits';
import { describeInBrowser, openTestPage, problemsOf } from '../pages';
import { useTestFont } from './testFont';

const STATES = [
  'noData',
  'flight',
  'contact',
  'toppling',
  'landed',
  'tipped',
  'twoKeys',
  'stuck',
  'helped',
  'lighter',
  'crashed',
  'predicted',
  'confirmed',
  'stale',
  'withdrawn',
  'off',
  'wide',
];
const SIZES = [
  { width: 1280, height: 720 },
  { width: 390, height: 844 },
] as const;

/** Added to each letter: DejaVu Sans Bold, the widest of the fonts a machine may have, against the test's Open Sans. */
const WIDE = '0.11em';

interface FitWindow {
  show: (state: string, ships: number) => void;
}

async function show(page: Page, state: string, ships = 20): Promise<void> {
  await page.evaluate(([name, size]) => (window as unknown as FitWindow).show(name, size), [
    state,
    ships,
  ] as const);
  // Sizes are observed: observers run after the frame.
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

describeInBrowser('the HUDs on the playground', () => {
  let page: Page;
  beforeAll(async () => {
    page = await openTestPage('hudOnPage.html', { reducedMotion: 'reduce' });
    await page.waitForSelector('html[data-ready=true]');
    await useTestFont(page);
  });
  afterAll(() => page.context().close());

  for (const viewport of SIZES)
    describe(`at ${String(viewport.width)} × ${String(viewport.height)}`, () => {
      beforeAll(() => page.setViewportSize(viewport));

      it.each(STATES)('fit without clipping, in a narrow font and in a wide one: %s', async (state) => {
        for (const spacing of ['normal', WIDE]) {
          await page.evaluate(
            (wide) => document.documentElement.style.setProperty('letter-spacing', wide),
            spacing,
          );
          for (const ships of [1, 20]) {
            await show(page, state, ships);
            expect(await misfits(page), `${String(ships)} ships, letters ${spacing} apart`).toEqual([]);
          }
        }
        expect(problemsOf(page)).toEqual([]);
      });
    });

  it('scroll by keyboard where the window is too low, with status and tilt fixed', async () => {
    await page.setViewportSize({ width: 1280, height: 720 });
    await show(page, 'tipped');
    const places = () =>
      page.evaluate(() =>
        ['.td-status', '.td-tilt'].map((part) =>
          JSON.stringify(document.querySelector(part)!.getBoundingClientRect()),
        ),
      );
    const before = await places();
    const parts = page.locator('.td-parts');
    expect(await parts.getAttribute('tabindex')).toBeNull();
    await page.setViewportSize({ width: 1280, height: 480 });
    await show(page, 'tipped');
    expect(await places()).toEqual(before);
    expect(await parts.getAttribute('tabindex')).toBe('0');
    const card = page.locator('.td-card dd').last();
    const isInSight = () =>
      card.evaluate(
        (dd) => dd.getBoundingClientRect().bottom <= dd.closest('.td-hud')!.getBoundingClientRect().bottom,
      );
    expect(await isInSight()).toBe(false);
    await parts.focus();
    await page.keyboard.press('End');
    await expect.poll(isInSight).toBe(true);
    expect(await places()).toEqual(before);
    // With less content there is nothing to scroll, and no Tab stop.
    await show(page, 'landed');
    await page.setViewportSize({ width: 1280, height: 720 });
    await show(page, 'landed');
    expect(await parts.getAttribute('tabindex')).toBeNull();
  });

  it('are found when they do not fit', async () => {
    await page.setViewportSize({ width: 1280, height: 720 });
    await show(page, 'tipped');
    const low = await page.addStyleTag({ content: '#hud .td-landing { max-height: 400px }' });
    expect((await misfits(page)).join()).toMatch(/higher than its room: \.td-parts/);
    await low.evaluate((style) => (style as HTMLStyleElement).remove());
    const narrow = await page.addStyleTag({ content: '.td-reading .td-value { translate: -112px 0 }' });
    expect((await misfits(page)).join()).toMatch(/one over the other/);
    await narrow.evaluate((style) => (style as HTMLStyleElement).remove());
    expect(await misfits(page)).toEqual([]);
  });
});
