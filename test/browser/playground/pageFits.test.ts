/** The built page in windows of all sizes, with usual and large letters: nothing is cut off or covered. */
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { misfits } from '../hud/misfits';
import { describeInBrowser, openBuiltPage } from '../pages';
import type { PageOptions } from '../pages';
import { SMALL, untilDrawn } from '../waits';
import { WINDOW_SIZES } from '../windowSizes';
import {
  faultsOf,
  freeShare,
  LARGE_LETTERS,
  resize,
  setLetters,
  showCard,
  USUAL_LETTERS,
} from '../windowFit';

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
    [320, 568],
    [390, 844],
  ])('%i × %i: a long card after the flight ends above the ship', async (width, height) => {
    await resize(page, width, height);
    await showCard(page, 60);
    expect((await page.locator('#card').boundingBox())!.height).toBeGreaterThan(100);
    expect(await freeShare(page, '#card', '.thumb-middle')).toBeGreaterThanOrEqual(0.2);
    await showCard(page, 0);
  });

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
  ])(
    '%i × %i: a long card after the flight ends above the ship, and that above the instruments',
    async (width, height) => {
      await resize(page, width, height);
      await showCard(page, 60);
      expect((await page.locator('#card').boundingBox())!.height).toBeGreaterThan(100);
      expect(await freeShare(page, '#card', '#foot')).toBeGreaterThanOrEqual(0.2);
      await showCard(page, 0);
    },
  );

  it('leaves the ship in sight with the workshop open on a small laptop, with its figures too', async () => {
    await resize(page, 960, 540);
    const workshop = page.locator('summary', { hasText: 'Workshop' });
    await workshop.click();
    await page.waitForSelector('#dock .strip');
    const expectRoom = async () => {
      await untilDrawn(page);
      expect(await freeShare(page, '#goal', '#foot')).toBeGreaterThanOrEqual(0.2);
      expect(await misfits(page)).toEqual([]);
    };
    await expectRoom();
    expect(await freeShare(page, '#panel', '#flight')).toBeGreaterThanOrEqual(0);
    const figures = page.locator('summary', { hasText: 'Figures' });
    await figures.click();
    await expectRoom();
    expect(await freeShare(page, '#panel', '#dock')).toBeGreaterThanOrEqual(0);
    await figures.click();
    await workshop.click();
    await page.waitForSelector('#dock .strip', { state: 'hidden' });
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
