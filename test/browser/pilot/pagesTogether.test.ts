/** Two tabs of one browser on one world. */
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { describeInBrowser, openBuiltPage } from '../pages';
import { ON_INSTRUMENTS, untilStatus } from '../waits';

/** Names and states of the fleet display's rows, as "Bob CONTACT". */
const fleetOf = (page: Page) =>
  page
    .locator('.td-row')
    .evaluateAll((rows) =>
      rows.map(
        (row) =>
          `${row.querySelector('.td-name')?.textContent ?? ''} ${row.querySelector('.td-word')?.textContent ?? ''}`,
      ),
    );

interface Listening {
  said: Set<string>;
}

/** Keeps every text of the fleet display; runs before the page's own scripts. */
function listen(): void {
  const said = new Set<string>();
  Object.assign(window, { said });
  const note = () => {
    for (const row of document.querySelectorAll('.td-row')) {
      const [name, word] = ['.td-name', '.td-word'].map((part) => row.querySelector(part)?.textContent ?? '');
      said.add(`${name!} ${word!}`);
    }
  };
  new MutationObserver(note).observe(document, { childList: true, characterData: true, subtree: true });
}

const saidTo = (page: Page) => page.evaluate(() => [...(window as unknown as Listening).said]);
const hushed = (page: Page) => page.evaluate(() => (window as unknown as Listening).said.clear());
const heightOf = async (page: Page) =>
  parseFloat((await page.locator('.td-reading-agl .td-value').textContent()) ?? '');

/** Takes off, cuts the engine some metres up, and falls until it rests; the other tab sees each part of it. */
async function hop(pilot: Page, name: string, watcher: Page): Promise<void> {
  await hushed(watcher);
  await pilot.keyboard.press('z');
  await expect.poll(() => heightOf(pilot)).toBeGreaterThan(2);
  await pilot.keyboard.press('x');
  await untilStatus(pilot, 'landed', 'tipped', 'crashed');
  await expect.poll(() => saidTo(watcher)).toContain(`${name} CONTACT`);
  expect(await saidTo(watcher)).toContain(`${name} FLIGHT`);
}

describeInBrowser('two tabs on one world', () => {
  it('see each other by name, fly their own ships, and see each other bounce', async () => {
    // Over twice the Moon's gravity: a flight of seconds.
    const prepare = (page: Page) => page.addInitScript(listen);
    const host = await openBuiltPage('?scenario=settle&body=Mars&name=Ann', { ...ON_INSTRUMENTS, prepare });
    await untilStatus(host, 'landed');
    await host.context().grantPermissions(['clipboard-read', 'clipboard-write']);
    await host.getByRole('button', { name: 'Fly together' }).click();
    let link = '';
    // Pages of other tests have the same clipboard.
    await expect
      .poll(async () => (link = await host.evaluate(() => navigator.clipboard.readText())))
      .toMatch(/\?server=tab:\w+$/);
    const guest = await host.context().newPage();
    await guest.addInitScript(listen);
    await guest.goto(`${link}&name=Bob`);
    await untilStatus(guest, 'landed', 'tipped');
    await expect.poll(() => fleetOf(host)).toContainEqual(expect.stringMatching(/^Bob /));
    await expect.poll(() => fleetOf(guest)).toContainEqual(expect.stringMatching(/^Ann /));

    await hop(guest, 'Bob', host);
    expect(await host.getAttribute('html', 'data-status')).toBe('landed');
    await hop(host, 'Ann', guest);
    // Closing a tab removes its ship.
    await guest.close({ runBeforeUnload: true });
    await expect.poll(() => fleetOf(host)).toEqual([expect.stringMatching(/^Ann /)]);
  });
});
