/** The built page in unusual windows: another screen, large letters, forced colours, a host with Trusted Types. */
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { misfits } from '../hud/misfits';
import { describeInBrowser, openBuiltPage, problemsOf } from '../pages';
import { CONTENT_SECURITY_POLICY } from '../staticServer';
import { SMALL, untilDrawn, untilStatus } from '../waits';
import { WINDOW_SIZES, windowOf } from '../windowSizes';

/** Pixels across of a picture that nobody looks at. */
const PIXELS = 240;
const USUAL_LETTERS = { fontSizes: { standard: 16, fixed: 13 } };
const LARGE_LETTERS = { fontSizes: { standard: 32, fixed: 26 } };

/** Parts of the page that are cut off, wider than the window, or cover something that must be visible. */
function pageMisfits(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const out: string[] = [];
    const boxOf = (id: string) => {
      const part = document.getElementById(id)!;
      return part.checkVisibility() ? part.getBoundingClientRect() : null;
    };
    for (const id of ['goal', 'banner', 'notice', 'card', 'pads', 'panel', 'foot', 'flight', 'hud']) {
      const box = boxOf(id);
      if (box === null || box.width === 0) continue;
      if (box.left < -0.5 || box.right > innerWidth + 0.5) out.push(`${id} is wider than the window`);
      const part = document.getElementById(id)!;
      if (part.scrollWidth > part.clientWidth + 1) out.push(`${id} is cut off at its side`);
    }
    const [goal, pads, picture] = ['goal', 'pads', 'picture'].map(boxOf);
    if (goal && pads && goal.bottom > pads.top) out.push('goal and pads overlap');
    if (pads && picture && pads.height > 0.6 * picture.height) out.push('pads cover the picture');
    if (goal && goal.bottom > innerHeight) out.push('the goal is below the fold');
    if (document.documentElement.scrollWidth > innerWidth) out.push('the page scrolls sideways');
    return out;
  });
}

describeInBrowser('the built page in any window', () => {
  /** Faults of the page as it is, and with letters of 200 %. */
  async function faultsOf(page: Page): Promise<string[]> {
    const faults = async () => [...(await misfits(page)), ...(await pageMisfits(page))];
    const found = await faults();
    const cdp = await page.context().newCDPSession(page);
    await cdp.send('Page.setFontSizes', LARGE_LETTERS);
    await expect
      .poll(() => page.evaluate(() => getComputedStyle(document.documentElement).fontSize))
      .toBe('32px');
    await untilDrawn(page);
    found.push(...(await faults()).map((fault) => `200 %: ${fault}`));
    await cdp.send('Page.setFontSizes', USUAL_LETTERS);
    return found;
  }

  it.each(WINDOW_SIZES.filter(({ isTouch }) => isTouch))(
    '$width × $height: nothing is cut off, with letters of 100 % and of 200 %',
    async (size) => {
      const page = await openBuiltPage('', { ...SMALL, ...windowOf(size, PIXELS) });
      await page.waitForSelector('html[data-ready=true]');
      expect(await faultsOf(page)).toEqual([]);
    },
  );

  it('a window that grows: nothing is cut off at any size, with letters of 100 % and of 200 %', async () => {
    const sizes = WINDOW_SIZES.filter(({ isTouch }) => !isTouch);
    const page = await openBuiltPage('', { ...SMALL, ...windowOf(sizes[0]!, PIXELS) });
    await page.waitForSelector('html[data-ready=true]');
    const found: string[] = [];
    for (const { width, height } of sizes) {
      await page.setViewportSize({ width, height });
      await untilDrawn(page);
      found.push(...(await faultsOf(page)).map((fault) => `${width} × ${height}: ${fault}`));
    }
    expect(found).toEqual([]);
  });

  it('the goal’s lines break between a control and the next, not between a word and its keys', async () => {
    const page = await openBuiltPage('?scenario=night', SMALL);
    await page.waitForSelector('html[data-ready=true]');
    const keyRows = await page.locator('.goal-how').evaluate((how) => {
      const rows = (part: Element) =>
        new Set([...part.querySelectorAll('kbd')].map((key) => Math.round(key.getBoundingClientRect().top)));
      return { parts: [...how.children].map((part) => rows(part).size), whole: rows(how).size };
    });
    expect(keyRows.parts).toEqual([1, 1, 1, 1, 1, 1]);
    expect(keyRows.whole).toBeGreaterThan(1);
  });

  it('the beacon’s dial shares its row with the landing aids, without them with the attitude', async () => {
    const page = await openBuiltPage('', { ...SMALL, viewport: { width: 1440, height: 900 } });
    await page.waitForSelector('html[data-ready=true]');
    const boxOf = async (part: string) => (await page.locator(part).boundingBox())!;
    for (const width of [1440, 768]) {
      await page.setViewportSize({ width, height: 900 });
      await untilDrawn(page);
      const aids = await boxOf('.td-aids');
      const dial = await boxOf('.td-approach');
      const panel = await boxOf('.td-flight > .td-panel');
      expect(dial.y, `${width} px`).toBeLessThan(aids.y + aids.height);
      // Up to the panel's padding.
      expect(panel.x + panel.width - (dial.x + dial.width), `${width} px`).toBeLessThan(16);
    }
    await page.setViewportSize({ width: 1280, height: 800 });
    await page.keyboard.press('1');
    await page.waitForSelector('.td-aids', { state: 'hidden' });
    await untilDrawn(page);
    const dial = await boxOf('.td-approach');
    const attitude = await boxOf('.td-attitude');
    const modes = await boxOf('.td-modes');
    expect(dial.y).toBeGreaterThan(modes.y + modes.height);
    expect(attitude.y).toBeLessThan(dial.y + dial.height);
    expect(attitude.y + attitude.height).toBeGreaterThan(dial.y);
  });

  it('keeps the ship in sight with figures and plots open in a low window', async () => {
    const page = await openBuiltPage('?scenario=settle', {
      ...SMALL,
      viewport: { width: 1366, height: 650 },
    });
    await page.waitForSelector('html[data-ready=true]');
    for (const title of ['Figures', 'Plots']) await page.locator('summary', { hasText: title }).click();
    await page.waitForSelector('.plots .uplot');
    const foot = (await page.locator('#foot').boundingBox())!;
    const top = (await page.locator('#top').boundingBox())!;
    expect(foot.y - (top.y + top.height)).toBeGreaterThan(0.3 * 650);
  });

  it.each([
    ['a small laptop', 960, 540, USUAL_LETTERS],
    ['a tablet', 1024, 768, USUAL_LETTERS],
    ['a desk’s screen with letters of 200 %', 1920, 1080, LARGE_LETTERS],
    ['a laptop with letters of 200 %', 1280, 720, LARGE_LETTERS],
  ])('leaves the ship in sight in the window of %s', async (_window, width, height, letters) => {
    const page = await openBuiltPage('', { ...SMALL, viewport: { width, height } });
    const cdp = await page.context().newCDPSession(page);
    await cdp.send('Page.setFontSizes', letters);
    await page.waitForSelector('html[data-ready=true]');
    await untilDrawn(page);
    const covered = await page.evaluate(() => {
      const { left, top, width, height } = document.getElementById('picture')!.getBoundingClientRect();
      return [0.4, 0.5, 0.6].map(
        (down) => document.elementFromPoint(left + width / 2, top + down * height)?.id,
      );
    });
    expect(covered).toEqual(['scene-view', 'scene-view', 'scene-view']);
    const [panel, foot] = await Promise.all(
      ['#panel', '#foot'].map((part) => page.locator(part).boundingBox()),
    );
    // Where the page is one column, the foot has no box of its own.
    expect(panel!.y + panel!.height).toBeLessThanOrEqual(foot?.y ?? Infinity);
  });

  it.each([
    [1024, 768],
    [1366, 1024],
  ])('covers no thumb stick on a tablet of %i × %i, with the workshop open either', async (width, height) => {
    const page = await openBuiltPage('', { ...SMALL, ...windowOf({ width, height, isTouch: true }, PIXELS) });
    await page.waitForSelector('html[data-ready=true]');
    const covered = () =>
      page.locator('.thumb, .thumb-lever').evaluateAll((all) =>
        all
          .filter((thumb) => {
            const { left, top, width: across, height: down } = thumb.getBoundingClientRect();
            return !thumb.contains(document.elementFromPoint(left + across / 2, top + down / 2));
          })
          .map(({ textContent }) => textContent),
      );
    await untilDrawn(page);
    expect(await covered()).toEqual([]);
    await page.locator('summary', { hasText: 'Workshop' }).click();
    await page.waitForSelector('#dock .strip');
    await untilDrawn(page);
    expect(await covered()).toEqual([]);
  });

  it('draws as finely as the screen that it is moved to', async () => {
    const page = await openBuiltPage('?scenario=settle', { ...SMALL, deviceScaleFactor: 1 });
    await page.waitForSelector('html[data-ready=true]');
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
    expect(problemsOf(page)).toEqual([]);
  });

  it('keeps every sign in forced colours: each state has its shape, and is distinguished from the others without colour', async () => {
    const page = await openBuiltPage('?scenario=topple&slow=4', SMALL);
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
