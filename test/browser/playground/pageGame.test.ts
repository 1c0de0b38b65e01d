/** The page as a game: goal and keys from the start, a landing and its score. */
import { expect, it } from 'vitest';
import { describeInBrowser, openBuiltPage, problemsOf } from '../pages';
import { FLUENT, untilPhase } from '../waits';

describeInBrowser('the game on the built page', () => {
  it('names the goal and the keys, lands, and shows the score and the next mission', async () => {
    const page = await openBuiltPage('?slow=4', FLUENT);
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
    for (const line of ['Hardest touch', 'Distance', 'Tilt', 'Fuel', 'Time', 'full points up to 1\u00a0m/s'])
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
});
