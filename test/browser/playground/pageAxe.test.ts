/** axe over the built page in each of its states. */
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { LESSONS } from '../../../src/scenarios';
import { axeFaults } from '../axe';
import { describeInBrowser, openBuiltPage } from '../pages';
import { ON_INSTRUMENTS, SMALL, untilBanner, untilStatus } from '../waits';

const chooseMission = async (page: Page, name: string) => {
  await page.getByLabel('Mission').selectOption(name);
  await page.waitForFunction((wanted) => location.search.includes(`scenario=${wanted}`), name);
};

describeInBrowser('axe finds nothing on the built page', () => {
  it('in the first mission, each lesson, the workshop with every part open, and the dialog of keys', async () => {
    const page = await openBuiltPage('', SMALL);
    await page.waitForSelector('html[data-ready=true]');
    const found: string[] = [];
    const check = async (state: string) =>
      found.push(...(await axeFaults(page)).map((fault) => `${state}: ${fault}`));
    await check('first mission');
    for (const { scenario } of LESSONS) {
      await chooseMission(page, scenario.name);
      await check(scenario.name);
    }
    await page.locator('summary', { hasText: 'Workshop' }).click();
    for (const title of ['World', 'Figures', 'Plots', 'Recording'])
      await page.locator('summary', { hasText: title }).click();
    await page.waitForSelector('.plots .uplot');
    await page.getByLabel('Network', { exact: true }).selectOption('custom');
    for (const overlay of ['Server ghost', 'Error segment', 'Contact normal', 'Footprint', 'Forces'])
      await page.getByLabel(overlay, { exact: true }).check();
    await check('workshop');
    await page.getByRole('button', { name: 'Pause', exact: true }).first().click();
    await check('paused');
    await page.getByRole('button', { name: 'Keys', exact: true }).click();
    await page.waitForSelector('dialog[open]');
    await check('keys');
    expect(found).toEqual([]);
  });

  it('landed with a score, tipped, crashed, in a replay, and where a link is shown', async () => {
    const page = await openBuiltPage('?scenario=first-landing&slow=4', ON_INSTRUMENTS);
    const found: string[] = [];
    const check = async (state: string) =>
      found.push(...(await axeFaults(page)).map((fault) => `${state}: ${fault}`));
    await page.waitForFunction(() => /: -?\d+ of 1000/.test(document.getElementById('card')!.textContent));
    await check('landed');
    await page.evaluate(() => Object.defineProperty(navigator, 'clipboard', { value: undefined }));
    await page.getByRole('button', { name: 'Copy race link' }).click();
    await page.waitForSelector('.notice-link');
    await check('link');
    await chooseMission(page, 'topple');
    await untilStatus(page, 'tipped');
    await check('tipped');
    await page.locator('summary', { hasText: 'Workshop' }).click();
    await page.locator('summary', { hasText: 'Recording' }).click();
    await page.getByRole('button', { name: 'Replay' }).click();
    await untilBanner(page, 'Replay');
    await check('replay');
    await page.getByRole('button', { name: 'Back to the game' }).click();
    await chooseMission(page, 'crash');
    await untilStatus(page, 'crashed');
    await page.waitForSelector('#card:not([hidden])');
    await check('crashed');
    expect(found).toEqual([]);
  });

  it('with a server that does not answer, on a phone', async () => {
    const phone = {
      ...ON_INSTRUMENTS,
      viewport: { width: 390, height: 844 },
      hasTouch: true,
      isMobile: true,
    };
    const page = await openBuiltPage('?server=ws://127.0.0.1:9/', phone);
    await untilBanner(page, 'Nothing answers');
    expect(await axeFaults(page)).toEqual([]);
    // Commands that a server does not take are not offered.
    for (const name of ['Restart', 'Pause', 'Fly together'])
      expect(await page.getByRole('button', { name, exact: true }).isDisabled(), name).toBe(true);
    await page.locator('summary', { hasText: 'Workshop' }).click();
    for (const label of ['Mission', 'Network', 'Speed'])
      expect(await page.getByLabel(label, { exact: true }).isDisabled(), label).toBe(true);
    // The dialog opens at its beginning, on a phone too, and again.
    for (const time of ['first', 'second']) {
      await page.getByRole('button', { name: 'Keys', exact: true }).tap();
      const dialog = page.locator('dialog[open]');
      expect(await dialog.evaluate((element) => element.scrollTop), time).toBe(0);
      expect(await dialog.locator('h2').evaluate((title) => title === document.activeElement)).toBe(true);
      expect(await dialog.evaluate((element) => Object.assign(element, { scrollTop: 500 }).scrollTop)).toBe(
        500,
      );
      await page.keyboard.press('Escape');
    }
  });
});
