/** The page as a game: goal and keys from the start, a landing and its score, keys that keep working. */
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { describeInBrowser, openBuiltPage, problemsOf } from '../pages';
import { FLUENT, SMALL, untilPhase } from '../waits';

function throttleOf(page: Page): Promise<number> {
  return page.locator('.td-lever').getAttribute('aria-valuenow').then(Number);
}

describeInBrowser('the game on the built page', () => {
  it('names the goal and the keys, lands, and shows the score and the next mission', async () => {
    const page = await openBuiltPage('', FLUENT);
    await page.waitForSelector('html[data-ready=true]');
    const goal = await page.textContent('#goal');
    expect(goal).toContain('Land by the beacon, softer than 2 m/s.');
    expect(goal).toContain('You fly: F more thrust, V less, X cut the engine.');
    await page.keyboard.press('y');
    await page.waitForFunction(() =>
      document.querySelector('.td-modes')?.textContent.includes('Autopiloton'),
    );
    await untilPhase(page, 'done');
    await page.waitForFunction(() =>
      /Landed.*: \d+ of 1000/.test(document.getElementById('card')!.textContent),
    );
    const card = (await page.textContent('#card')) ?? '';
    for (const line of ['Hardest touch', 'Distance', 'Tilt', 'Fuel', 'Time', 'full points up to 1 m/s'])
      expect(card).toContain(line);
    expect(await page.evaluate(() => localStorage.getItem('touchdown.best.first-landing'))).toMatch(
      /^[\w-]+$/,
    );
    // Without a clipboard the link is shown.
    await page.evaluate(() => {
      Object.defineProperty(navigator, 'clipboard', { value: undefined });
    });
    await page.getByRole('button', { name: 'Copy race link' }).click();
    const link = await page.locator('.notice-link').inputValue();
    expect(link).toMatch(/\?scenario=first-landing&run=[\w-]+$/);
    await page.getByRole('button', { name: 'Close' }).click();
    await page.locator('#scene-view').focus();
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => location.search.includes('scenario=sidestep'));
    expect(problemsOf(page)).toEqual([]);

    await page.goto(link);
    await page.waitForSelector('#notice:not([hidden])');
    expect(await page.textContent('#notice')).toMatch(/Race a friend: \d+ points in \d+ s/);
  });

  it('flies with the focus anywhere but in a text field, and releases keys when it loses the focus', async () => {
    const page = await openBuiltPage('?scenario=launch', SMALL);
    await page.waitForSelector('html[data-ready=true]');
    const full = () => expect.poll(() => throttleOf(page)).toBe(100);
    const cut = async () => {
      await page.keyboard.press('x');
      await expect.poll(() => throttleOf(page)).toBe(0);
    };
    await page.getByLabel('Mission').focus();
    await page.keyboard.press('z');
    await full();
    expect(await page.getByLabel('Mission').inputValue()).toBe('launch');
    await cut();
    await page.getByLabel('Footprint').focus();
    await page.keyboard.press('z');
    await full();
    await cut();
    // A Cyrillic keyboard: the key's position counts.
    const stroke = (code: string, key: string, type = 'keydown') =>
      page.evaluate(
        ([name, at, printed]) =>
          document.body.dispatchEvent(new KeyboardEvent(name!, { code: at!, key: printed!, bubbles: true })),
        [type, code, key],
      );
    await stroke('KeyZ', 'я');
    await full();
    await cut();
    // Command is pressed while a key is held: macOS never reports the key's release.
    await page.keyboard.down('f');
    await expect.poll(() => throttleOf(page)).toBeGreaterThan(2);
    await stroke('MetaLeft', 'Meta');
    // If it were still held, the lever would reach its end.
    await page.waitForFunction(() => {
      const now = document.querySelector('.td-lever')!.getAttribute('aria-valuenow');
      const kept = window as unknown as { lever?: string | null; frames?: number };
      kept.frames = kept.lever === now ? (kept.frames ?? 0) + 1 : 0;
      kept.lever = now;
      return kept.frames > 5;
    });
    expect(await throttleOf(page)).toBeLessThan(100);
    expect(problemsOf(page)).toEqual([]);
  });
});
