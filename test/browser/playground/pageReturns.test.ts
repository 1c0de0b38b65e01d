/** The built page after interruptions: replaying a recording, after a hidden tab, after a lost connection. */
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, beforeEach, expect, it } from 'vitest';
import { describeInBrowser, openBuiltPage, problemsOf } from '../pages';
import { FLUENT, SMALL, untilBanner, untilProvenance, untilStatus } from '../waits';

describeInBrowser('the built page', () => {
  it('replays what it recorded, forward and backward, with the first divergence marked', async () => {
    const page = await openBuiltPage('?scenario=settle&slow=2', FLUENT);
    await untilStatus(page, 'landed');
    // In slow motion: the flight takes seconds of game time, as long as a slow display's frames.
    await page.getByLabel('Speed').selectOption('0.25');
    await page.getByRole('button', { name: 'Kick the ship' }).click();
    await untilStatus(page, 'flight');
    await page.getByLabel('Speed').selectOption('2');
    await untilStatus(page, 'landed', 'tipped');
    await page.locator('summary', { hasText: 'Recording' }).click();
    await page.getByRole('button', { name: 'Replay' }).click();
    await page.waitForSelector('.scrubber .mark', { state: 'visible' });
    expect(await page.textContent('#dock')).toMatch(/First divergence at tick \d+/);
    const scrubber = page.locator('.scrubber input');
    const end = Number(await scrubber.getAttribute('max'));
    // Backward to the kick: in its first moments a slow display has no ship yet.
    let at = end;
    const before = async () => {
      at -= 0.1;
      await scrubber.fill(at.toFixed(2));
      return page.evaluate(() => document.documentElement.dataset['status']);
    };
    await expect.poll(before, { interval: 100 }).toBe('flight');
    await scrubber.fill(end.toFixed(2));
    await untilStatus(page, 'landed', 'tipped');
    await page.getByRole('button', { name: 'Back to the game' }).click();
    await untilProvenance(page, 'confirmed');
    expect(problemsOf(page)).toEqual([]);
  });
});

describeInBrowser('the built page with a ship at rest', () => {
  let page: Page;
  beforeAll(async () => {
    // Four times the speed: a quarter of a minute is a minute for server and predictor.
    page = await openBuiltPage('?scenario=settle&slow=4', SMALL);
  });
  beforeEach(async () => {
    await page.getByLabel('Speed').selectOption('4');
    await untilStatus(page, 'landed');
  });
  afterAll(() => page.context().close());

  it('leaves the game alone while a recording plays: flight keys do nothing, and P pauses the replay', async () => {
    await page.locator('summary', { hasText: 'Recording' }).click();
    await page.getByRole('button', { name: 'Replay' }).click();
    await untilBanner(page, 'Replay');
    await page.locator('#scene-view').focus();
    await page.keyboard.press('z');
    await page.keyboard.press('p');
    await page.getByRole('button', { name: 'Play', exact: true }).waitFor();
    await page.keyboard.press(',');
    // The link is to the recording, whatever is chosen now.
    await page.getByLabel('Speed').selectOption('0.25');
    await page.evaluate(() => Object.defineProperty(navigator, 'clipboard', { value: undefined }));
    await page.getByRole('button', { name: 'Copy link' }).click();
    expect(new URL(await page.locator('.notice-link').inputValue()).search).toBe('?scenario=settle&slow=4');
    await page.getByRole('button', { name: 'Back to the game' }).click();
    await untilProvenance(page, 'confirmed');
    await untilStatus(page, 'landed');
    expect(await page.locator('.td-lever').getAttribute('aria-valuenow')).toBe('0');
    expect(await page.getByRole('button', { name: 'Pause', exact: true }).first().isVisible()).toBe(true);
    expect(problemsOf(page)).toEqual([]);
  });

  it('repeats the flight without prediction, also for a ship at rest, until the button is pressed again', async () => {
    await page.getByLabel('Speed').selectOption('0.25');
    const compare = page.getByRole('button', { name: 'See the same without prediction' });
    expect(await compare.getAttribute('aria-pressed')).toBe('false');
    await compare.click();
    await untilStatus(page, 'flight');
    expect(await compare.getAttribute('aria-pressed')).toBe('true');
    expect(await page.getByLabel('Client').inputValue()).toBe('last');
    await page.getByLabel('Speed').selectOption('4');
    await untilStatus(page, 'landed');
    await compare.click();
    expect(await compare.getAttribute('aria-pressed')).toBe('false');
    expect(await page.getByLabel('Client').inputValue()).toBe('predicted');
  });

  it('survives a minute hidden and a lost connection', async () => {
    await page.getByRole('button', { name: 'Hide for a minute' }).click();
    await page.getByRole('button', { name: /Back now \((4[0-5]|[1-3]?\d) s\)/ }).click();
    await untilProvenance(page, 'confirmed');
    await untilStatus(page, 'landed');

    await page.getByRole('button', { name: 'Drop the connection' }).click();
    await untilProvenance(page, 'stale');
    await untilBanner(page, 'Connection lost');
    await page.getByRole('button', { name: 'Reconnect' }).click();
    await untilProvenance(page, 'confirmed');
    await expect.poll(() => page.textContent('#banner')).toBe('');
    expect(problemsOf(page)).toEqual([]);
  });
});
