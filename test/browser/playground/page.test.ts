import type { Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, beforeEach, expect, it } from 'vitest';
import { axeFaults } from '../axe';
import { describeInBrowser, openBuiltPage, problemsOf } from '../pages';
import { SMALL, untilDrawn, untilStatus } from '../waits';

describeInBrowser('the built page with a ship at rest', () => {
  let page: Page;
  beforeAll(async () => {
    page = await openBuiltPage('?scenario=settle&slow=4', SMALL);
  });
  beforeEach(() => untilStatus(page, 'landed'));
  afterEach(async () => {
    await page.context().setOffline(false);
    await page.getByLabel('Mission', { exact: true }).selectOption('settle');
  });
  afterAll(() => page.context().close());

  // First: nothing may be loaded later.
  it('works without network once loaded', async () => {
    await page.context().setOffline(true);
    const settled = await page.evaluate(() => document.documentElement.dataset['run']);
    await page.keyboard.press(']');
    await page.waitForFunction(() => location.search.includes('scenario=bounce'));
    // Not by its flight, which a slow display may not show: the ship has states of the new world.
    await page.waitForFunction((before) => document.documentElement.dataset['run'] !== before, settled);
    await untilStatus(page, 'landed');
    expect(problemsOf(page)).toEqual([]);
  });

  it('flies by keyboard alone', async () => {
    await page.keyboard.press('z');
    await untilStatus(page, 'flight');
    await page.keyboard.press('x');
    await untilStatus(page, 'contact', 'landed');
    await untilStatus(page, 'landed', 'crashed');
    // Help is opened, read and closed by keys; flight keys rest while it is open.
    await page.keyboard.press('?');
    await page.waitForSelector('dialog[open]');
    expect(await page.textContent('dialog')).toContain('Tilt away');
    await page.keyboard.press('Escape');
    await page.waitForSelector('dialog', { state: 'hidden' });
    await page.keyboard.press(']');
    await page.waitForFunction(() => location.search.includes('scenario=bounce'));
    expect(problemsOf(page)).toEqual([]);
  });

  it('passes axe, dark and wide, light and narrow', async () => {
    for (const title of ['Figures', 'Recording', 'World'])
      await page.locator('summary', { hasText: title }).click();
    for (const [colorScheme, width, height] of [
      ['dark', 1280, 720],
      ['light', 390, 844],
    ] as const) {
      await page.emulateMedia({ colorScheme });
      await page.setViewportSize({ width, height });
      await untilDrawn(page);
      const wide = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
      expect(wide, colorScheme).toBeLessThanOrEqual(0);
      expect(await axeFaults(page), colorScheme).toEqual([]);
    }
  });
});
