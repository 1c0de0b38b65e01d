/** The fleet HUD in a real browser: its order, its rows while scrolling, names as text. */
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, beforeEach, expect, it } from 'vitest';
import { describeInBrowser, openTestPage, problemsOf } from '../pages';

interface HudWindow {
  hud: { showFleet: (size: number) => void };
}

let page: Page;

const showFleet = (size: number) =>
  page.evaluate((count) => (window as unknown as HudWindow).hud.showFleet(count), size);

describeInBrowser('the fleet HUD', () => {
  beforeAll(async () => {
    page = await openTestPage('hud.html', { reducedMotion: 'reduce' });
    await page.waitForSelector('html[data-ready=true]');
  });
  beforeEach(async () => {
    await showFleet(0);
    await page.waitForSelector('.td-row', { state: 'detached' });
  });
  afterAll(() => page.context().close());

  it('shows counts in its header and puts TIPPED first, then CONTACT', async () => {
    await showFleet(20);
    expect(await page.locator('.td-count:visible').allTextContents()).toEqual([
      '2 tipped',
      '2 in contact',
      '2 crashed',
      '6 in flight',
      '8 landed',
    ]);
    await page.waitForSelector('.td-row:nth-child(5)');
    const words = await page.locator('.td-row .td-word').allTextContents();
    expect(words.slice(0, 5)).toEqual(['TIPPED', 'TIPPED', 'CONTACT', 'CONTACT', 'CRASHED']);
  });

  it('scrolls through 1,000 ships with at most 30 row elements', async () => {
    await showFleet(1000);
    await page.waitForSelector('.td-row:nth-child(12)');
    const seen = new Set<string>();
    const height = await page.locator('.td-rows').evaluate((list) => list.getBoundingClientRect().height);
    expect(height).toBe(28_000);
    for (let top = 0; top <= height; top += 280) {
      const rows = await page.locator('.td-scroller').evaluate(async (scroller, to) => {
        scroller.scrollTop = to;
        await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
        const { top: from, bottom } = scroller.getBoundingClientRect();
        return [...scroller.querySelectorAll('.td-row')].map((row) => {
          const box = row.getBoundingClientRect();
          const name = row.querySelector('.td-name')!.textContent;
          return {
            name,
            place: row.getAttribute('aria-posinset'),
            inSight: box.bottom > from && box.top < bottom,
          };
        });
      }, top);
      expect(rows.length).toBeLessThanOrEqual(30);
      for (const { name, place, inSight } of rows) if (inSight) seen.add(`${place!} ${name}`);
    }
    // Every ship came into view, each at one position.
    expect(seen.size).toBe(1000);
    // Rows of 1.75 rem: with text twice as large the hundredth ends twice as far down.
    const atTop = await page.locator('.td-scroller').evaluate(async (scroller) => {
      document.documentElement.style.fontSize = '32px';
      scroller.scrollTop = 100 * 56;
      await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
      const { top } = scroller.getBoundingClientRect();
      const rows = [...scroller.querySelectorAll('.td-row')];
      const first = rows.find((row) => row.getBoundingClientRect().bottom > top + 1)!;
      document.documentElement.style.fontSize = '';
      return first.getAttribute('aria-posinset');
    });
    expect(atTop).toBe('101');
  });

  it('has at most 30 row elements and never a gap while it scrolls by key, by wheel or in jumps', async () => {
    await showFleet(1000);
    await page.waitForSelector('.td-row:nth-child(12)');
    // Counted at every change of the list, not only at rest, and checked in every frame.
    await page.evaluate(() => {
      const list = document.querySelector('.td-rows')!;
      const watched = { most: list.children.length, changes: 0, frames: 0, scrolls: 0, gaps: [] as string[] };
      Object.assign(window, { watched });
      const count = (): void => {
        watched.changes += 1;
        watched.most = Math.max(watched.most, list.querySelectorAll('.td-row').length);
      };
      new MutationObserver(count).observe(list, { childList: true, subtree: true, attributes: true });
      const scroller = document.querySelector('.td-scroller')!;
      scroller.addEventListener('scroll', () => (watched.scrolls += 1));
      const look = (): void => {
        watched.frames += 1;
        count();
        // After the frame's scroll events: every position in the visible part of the list has its row.
        const { top, height } = scroller.getBoundingClientRect();
        const covered = [...list.children].map((row) => row.getBoundingClientRect());
        for (let y = top + 1; y < top + height; y += 14)
          if (!covered.some((row) => row.top <= y && row.bottom >= y))
            watched.gaps.push(`${String(Math.round(y - top))} px at ${String(scroller.scrollTop)}`);
        requestAnimationFrame(look);
      };
      requestAnimationFrame(look);
    });
    const scroller = page.locator('.td-scroller');
    const place = (which: 'first' | 'last') =>
      page.locator('.td-row')[which]().getAttribute('aria-posinset').then(Number);
    await scroller.focus();
    await page.keyboard.press('End');
    await expect.poll(() => place('last')).toBe(1000);
    await page.keyboard.press('Home');
    await expect.poll(() => place('first')).toBe(1);
    for (let i = 0; i < 12; i++) await page.keyboard.press('PageDown');
    await expect.poll(() => place('first')).toBeGreaterThan(100);
    for (let i = 0; i < 20; i++) await page.keyboard.press('ArrowDown');
    const box = (await scroller.boundingBox())!;
    await page.mouse.move(box.x + 50, box.y + 50);
    for (let i = 0; i < 10; i++) await page.mouse.wheel(0, i % 3 === 2 ? -4000 : 6000);
    await page.evaluate(async () => {
      const list = document.querySelector('.td-scroller')!;
      for (const to of [0, 28_000, 13, 27_000, 14_001, 28_000, 0, 7777]) {
        list.scrollTop = to;
        await new Promise(requestAnimationFrame);
      }
    });
    // Smooth scrolling may not be finished.
    await expect.poll(() => place('first')).toBe(Math.floor(7777 / 28) + 1);
    interface Watched {
      watched: { most: number; changes: number; frames: number; scrolls: number; gaps: string[] };
    }
    const watched = await page.evaluate(() => (window as unknown as Watched).watched);
    expect(watched.most).toBeGreaterThan(12);
    expect(watched.most).toBeLessThanOrEqual(30);
    expect(watched.scrolls).toBeGreaterThan(15);
    expect(watched.frames).toBeGreaterThan(15);
    expect(watched.changes).toBeGreaterThan(30);
    expect(watched.gaps).toEqual([]);
  });

  it('shows names as text, never as markup', async () => {
    await showFleet(4);
    await page.waitForSelector('.td-row:nth-child(4)');
    expect(await page.locator('.td-name').allTextContents()).toContain('<b>Aurora</b> & sons');
    expect(await page.locator('.td-name b').count()).toBe(0);
  });

  it('shrinks with its fleet', async () => {
    await showFleet(1000);
    await page.waitForSelector('.td-row:nth-child(12)');
    await page.locator('.td-scroller').evaluate((scroller) => (scroller.scrollTop = 20_000));
    await showFleet(3);
    await expect.poll(() => page.locator('.td-row').count()).toBe(3);
    expect(await page.locator('.td-row').first().isVisible()).toBe(true);
    await showFleet(0);
    await expect.poll(() => page.locator('.td-row').count()).toBe(0);
    expect(problemsOf(page)).toEqual([]);
  });
});
