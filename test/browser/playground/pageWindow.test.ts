/** The built page on unusual displays: low, moved to another screen, in forced colours, and on a host with Trusted Types. */
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { describeInBrowser, openBuiltPage, problemsOf } from '../pages';
import { CONTENT_SECURITY_POLICY } from '../staticServer';
import { SMALL, untilStatus } from '../waits';

describeInBrowser('the built page with a ship at rest', () => {
  let page: Page;
  beforeAll(async () => {
    page = await openBuiltPage('?scenario=settle&slow=4', { ...SMALL, deviceScaleFactor: 1 });
    await page.waitForSelector('html[data-ready=true]');
  });
  afterAll(() => page.context().close());

  it('keeps the ship in sight with figures and plots open in a low window', async () => {
    await page.setViewportSize({ width: 1366, height: 650 });
    const toggle = async () => {
      for (const title of ['Figures', 'Plots']) await page.locator('summary', { hasText: title }).click();
    };
    await toggle();
    await page.waitForSelector('.plots .uplot');
    const foot = (await page.locator('#foot').boundingBox())!;
    // Of what is seen: the room of goal and card itself reaches down to the instruments.
    const above = await page
      .locator('#top > *')
      .evaluateAll((parts) => Math.max(...parts.map((part) => part.getBoundingClientRect().bottom)));
    expect(foot.y - above).toBeGreaterThan(0.3 * 650);
    await toggle();
  });

  it('draws as finely as the screen that it is moved to', async () => {
    const widthOf = () =>
      page.locator('#scene-view').evaluate((canvas) => (canvas as HTMLCanvasElement).width);
    const scaleOf = () =>
      page.locator('#scene-view').evaluate((canvas) => (canvas as HTMLCanvasElement).clientWidth);
    await page.setViewportSize({ width: 500, height: 400 });
    await expect.poll(widthOf).toBe(await scaleOf());
    const cdp = await page.context().newCDPSession(page);
    const screen = { width: 500, height: 400, mobile: false };
    await cdp.send('Emulation.setDeviceMetricsOverride', { ...screen, deviceScaleFactor: 2 });
    await expect.poll(widthOf).toBe(2 * (await scaleOf()));
    await cdp.detach();
    expect(problemsOf(page)).toEqual([]);
  });

  it('keeps every sign in forced colours: each state has its shape, and is distinguished from the others without colour', async () => {
    await page.getByLabel('Mission').selectOption('topple');
    await page.emulateMedia({ forcedColors: 'active' });
    const signs = new Set<string>();
    const read = async (state: string) => {
      await untilStatus(page, state);
      const shown = await page.locator('.td-landing .td-status').evaluate((slot) => {
        const shape = slot.querySelector('.td-shape')!;
        const { color } = getComputedStyle(shape);
        const { backgroundColor, borderTopWidth } = getComputedStyle(slot);
        return {
          text: shape.textContent,
          isSeen: color !== backgroundColor,
          border: parseFloat(borderTopWidth),
        };
      });
      expect(shown.isSeen, state).toBe(true);
      expect(shown.border, state).toBeGreaterThan(0);
      signs.add(shown.text);
    };
    await read('tipped');
    await page.getByLabel('Mission').selectOption('settle');
    await read('landed');
    const ground = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    // Opaque, or each text has a box of its own on the panel.
    const panels = await page
      .locator('.td-panel, #panel, #dock')
      .evaluateAll((parts) => parts.map((part) => getComputedStyle(part).backgroundColor));
    expect(new Set(panels)).toEqual(new Set([ground]));
    await page.getByLabel('Mission').selectOption('launch');
    await page.keyboard.press('z');
    await read('flight');
    expect(signs.size).toBe(3);
    // Also where a fill means on or off: lever, ball and pressed modes.
    const fills = await page
      .locator('.td-lever-fill, .td-zenith')
      .evaluateAll((parts) => parts.map((part) => getComputedStyle(part).fill));
    expect(fills.every((fill) => fill !== ground && fill !== 'none')).toBe(true);
  });
});

describeInBrowser('the built page on a strict host', () => {
  it('runs on a host that requires Trusted Types for scripts', async () => {
    const strict = `${CONTENT_SECURITY_POLICY}; require-trusted-types-for 'script'`;
    const prepare = (page: Page) =>
      page.context().route(/\/(\?.*)?$/, async (route) => {
        const response = await route.fetch();
        const headers = { ...response.headers(), 'content-security-policy': strict };
        await route.fulfill({ response, headers });
      });
    const page = await openBuiltPage('?scenario=settle&slow=4', {
      ...SMALL,
      serviceWorkers: 'block',
      prepare,
    });
    await untilStatus(page, 'landed');
    expect(problemsOf(page)).toEqual([]);
  });
});
