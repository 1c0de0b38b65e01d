/** The built page in windows of all sizes, with usual and large letters: nothing is cut off or covered. */
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { misfits } from '../hud/misfits';
import { describeInBrowser, openBuiltPage } from '../pages';
import type { PageOptions } from '../pages';
import { SMALL, untilDrawn } from '../waits';
import { WINDOW_SIZES } from '../windowSizes';

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

/** Faults of the page as it is, and with letters of 200 %. */
async function faultsOf(page: Page): Promise<string[]> {
  const faults = async () => [...(await misfits(page)), ...(await pageMisfits(page))];
  const found = await faults();
  await setLetters(page, LARGE_LETTERS);
  await untilDrawn(page);
  found.push(...(await faults()).map((fault) => `200 %: ${fault}`));
  await setLetters(page, USUAL_LETTERS);
  return found;
}

async function setLetters(page: Page, letters: typeof USUAL_LETTERS): Promise<void> {
  const cdp = await page.context().newCDPSession(page);
  await cdp.send('Page.setFontSizes', letters);
  await expect
    .poll(() => page.evaluate(() => getComputedStyle(document.documentElement).fontSize))
    .toBe(`${letters.fontSizes.standard}px`);
  await cdp.detach();
}

/** Gives the window another size, which the page has when this resolves. */
async function resize(page: Page, width: number, height: number): Promise<void> {
  await page.setViewportSize({ width, height });
  await untilDrawn(page);
}

/** A page that the tests of a block share. In slow motion it is still in the first seconds of the flight for the last of them. */
async function openSlowly(options: PageOptions): Promise<Page> {
  const page = await openBuiltPage('?slow=0.1', { ...SMALL, ...options });
  await page.waitForSelector('html[data-ready=true]');
  return page;
}

describeInBrowser('the built page by fingers, in any window', () => {
  let page: Page;
  beforeAll(async () => {
    page = await openSlowly({ hasTouch: true, isMobile: true });
  });
  afterAll(() => page.context().close());

  it.each(WINDOW_SIZES.filter(({ isTouch }) => isTouch))(
    '$width × $height: nothing is cut off, with letters of 100 % and of 200 %',
    async ({ width, height }) => {
      await resize(page, width, height);
      expect(await faultsOf(page)).toEqual([]);
    },
  );

  it.each([
    [1024, 768],
    [1366, 1024],
  ])('covers no thumb stick on a tablet of %i × %i, with the workshop open either', async (width, height) => {
    await resize(page, width, height);
    const covered = () =>
      page.locator('.thumb, .thumb-lever').evaluateAll((all) =>
        all
          .filter((thumb) => {
            const { left, top, width: across, height: down } = thumb.getBoundingClientRect();
            return !thumb.contains(document.elementFromPoint(left + across / 2, top + down / 2));
          })
          .map(({ textContent }) => textContent),
      );
    expect(await covered()).toEqual([]);
    const workshop = page.locator('summary', { hasText: 'Workshop' });
    await workshop.click();
    await page.waitForSelector('#dock .strip');
    await untilDrawn(page);
    expect(await covered()).toEqual([]);
    await workshop.click();
    await page.waitForSelector('#dock .strip', { state: 'hidden' });
  });
});

describeInBrowser('the built page in any window', () => {
  let page: Page;
  beforeAll(async () => {
    page = await openSlowly({});
  });
  afterAll(() => page.context().close());

  it.each(WINDOW_SIZES.filter(({ isTouch }) => !isTouch))(
    '$width × $height: nothing is cut off, with letters of 100 % and of 200 %',
    async ({ width, height }) => {
      await resize(page, width, height);
      expect(await faultsOf(page)).toEqual([]);
    },
  );

  it.each([
    ['a small laptop', 960, 540, USUAL_LETTERS],
    ['a tablet', 1024, 768, USUAL_LETTERS],
    ['a desk’s screen with letters of 200 %', 1920, 1080, LARGE_LETTERS],
    ['a laptop with letters of 200 %', 1280, 720, LARGE_LETTERS],
  ])('leaves the ship in sight in the window of %s', async (_window, width, height, letters) => {
    await setLetters(page, letters);
    await resize(page, width, height);
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
    await setLetters(page, USUAL_LETTERS);
  });

  it('shows speeds and throttle without scrolling on a laptop with letters of 200 %', async () => {
    await setLetters(page, LARGE_LETTERS);
    await resize(page, 1280, 720);
    const parts = [
      '.td-reading-vspd',
      '.td-reading-agl',
      '.td-tilt-value',
      '.td-lever-picture',
      '.td-lever-words',
    ];
    const bottoms = await Promise.all(
      parts.map(async (part) => {
        const { y, height } = (await page.locator(part).boundingBox())!;
        return y + height;
      }),
    );
    expect(Math.max(...bottoms)).toBeLessThanOrEqual(720);
    await setLetters(page, USUAL_LETTERS);
  });

  it.each([
    [960, 540],
    [1280, 720],
  ])('%i × %i: a long card ends above the instruments', async (width, height) => {
    await resize(page, width, height);
    const write = (text: string) =>
      page.evaluate((words) => {
        const card = document.getElementById('card')!;
        card.textContent = words;
        card.hidden = words === '';
      }, text);
    await write('A line of the score.\n'.repeat(60));
    const [card, foot] = await Promise.all(
      ['#card', '#foot'].map((part) => page.locator(part).boundingBox()),
    );
    expect(card!.height).toBeGreaterThan(100);
    expect(card!.y + card!.height).toBeLessThanOrEqual(foot!.y);
    await write('');
  });

  it('the beacon’s dial shares its row with the landing aids, without them with the attitude', async () => {
    const boxOf = async (part: string) => (await page.locator(part).boundingBox())!;
    for (const width of [1440, 768]) {
      await resize(page, width, 900);
      const aids = await boxOf('.td-aids');
      const dial = await boxOf('.td-approach');
      const panel = await boxOf('.td-flight > .td-panel');
      expect(dial.y, `${width} px`).toBeLessThan(aids.y + aids.height);
      // Up to the panel's padding.
      expect(panel.x + panel.width - (dial.x + dial.width), `${width} px`).toBeLessThan(16);
    }
    await resize(page, 1280, 800);
    await page.keyboard.press('1');
    await page.waitForSelector('.td-aids', { state: 'hidden' });
    await untilDrawn(page);
    const dial = await boxOf('.td-approach');
    const attitude = await boxOf('.td-attitude');
    const modes = await boxOf('.td-modes');
    expect(dial.y).toBeGreaterThan(modes.y + modes.height);
    expect(attitude.y).toBeLessThan(dial.y + dial.height);
    expect(attitude.y + attitude.height).toBeGreaterThan(dial.y);
    await page.keyboard.press('1');
    await page.waitForSelector('.td-aids');
  });

  it('the goal’s lines break between a control and the next, not between a word and its keys, and end with no dot', async () => {
    await page.getByLabel('Mission').selectOption('night');
    await page.waitForFunction(() => location.search.includes('scenario=night'));
    await resize(page, 960, 540);
    const keyRows = await page.locator('.goal-how').evaluate((how) => {
      const rows = (part: Element) =>
        new Set([...part.querySelectorAll('kbd')].map((key) => Math.round(key.getBoundingClientRect().top)));
      const items = [...how.querySelectorAll('.goal-item')];
      return { items: items.map((item) => [item.textContent, rows(item).size]), whole: rows(how).size };
    });
    expect(keyRows.items).toEqual([
      ...[
        ['Tilt WASD', 1],
        ['push IJKL', 1],
        ['thrust F V', 1],
      ],
      ...[
        ['cut X', 1],
        ['upright N', 1],
        ['autopilot Y', 1],
      ],
    ]);
    expect(keyRows.whole).toBeGreaterThan(1);
  });
});
