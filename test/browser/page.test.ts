import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import type { Page } from 'playwright-core';
import { expect, inject, it } from 'vitest';
import { hashRows, readShip, SHIP_STRIDE } from '../../src/dynamics';
import { rehearse, SCENARIOS } from '../../src/scenarios';
import { describeInBrowser, openBuiltPage, openUrl, problemsOf, theBrowser } from './pages';
import { shadesOf, SMALL, untilProvenance, untilStatus, untilTiltBelow } from './waits';

const axeSource = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

/** Tick and bits of the own ship at the scenario's end. */
async function endOfRun(page: Page, lastTick: number): Promise<string> {
  await page.waitForFunction(
    (tick) => document.documentElement.dataset['run']?.startsWith(`${tick}:`),
    lastTick,
    {
      timeout: 45_000,
    },
  );
  return (await page.evaluate(() => document.documentElement.dataset['run'])) ?? '';
}

/** The same of a scenario on the dynamics alone, without a page: on the hills, where the page opens it. */
function rehearsedRun(name: string): string {
  const scenario = SCENARIOS.find((candidate) => candidate.name === name)!;
  const rehearsed = rehearse({ ...scenario, terrain: 'hills' });
  if (!rehearsed.ok) throw new Error(rehearsed.reason);
  const { ships, world } = rehearsed.value;
  const last = ships.length - SHIP_STRIDE;
  const end = readShip(ships, last, world);
  const vectors = [end.relativePosition, end.relativeVelocity, end.attitude, end.angularVelocity].flat();
  return `${last / SHIP_STRIDE}:${String(hashRows(Float64Array.of(...vectors, end.fuel)))}`;
}

describeInBrowser('the built page', () => {
  it('opens on a landing: picture, both displays, nothing wrong', { timeout: 120_000 }, async () => {
    const page = await openBuiltPage();
    await page.waitForSelector('html[data-ready=true]', { timeout: 45_000 });
    await untilStatus(page, 'landed');
    expect(await page.textContent('.td-landing')).toContain('LANDED');
    expect(await page.textContent('.td-fleet')).toContain('LANDED');
    expect(await page.evaluate(() => document.querySelector('canvas')?.getContext('webgl2') !== null)).toBe(
      true,
    );
    expect(await shadesOf(page)).toBeGreaterThan(500);
    await page.waitForFunction(() => document.getElementById('twin')?.textContent.includes('landed'), null, {
      timeout: 15_000,
    });
    expect(problemsOf(page)).toEqual([]);
  });

  it.each([
    ['dark', 1280, 720],
    ['light', 390, 844],
  ] as const)(
    'has nothing for axe to find (%s, %i × %i)',
    { timeout: 120_000 },
    async (colorScheme, width, height) => {
      const page = await openBuiltPage('?scenario=settle', { viewport: { width, height }, colorScheme });
      await page.waitForSelector('html[data-ready=true]', { timeout: 45_000 });
      const wide = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
      expect(wide).toBeLessThanOrEqual(0);
      for (const title of ['Figures', 'Recording', 'World'])
        await page.locator('summary', { hasText: title }).click({ timeout: 30_000 });
      // Through the debugger's door: the page's own policy forbids scripts from elsewhere, rightly.
      await page.evaluate(axeSource);
      const found = await page.evaluate(async () => {
        const axe = (
          globalThis as unknown as { axe: { run: (options: object) => Promise<{ violations: unknown[] }> } }
        ).axe;
        const { violations } = await axe.run({ runOnly: ['wcag2a', 'wcag2aa', 'wcag21aa', 'wcag22aa'] });
        return violations.map((violation) => {
          const { id, nodes } = violation as {
            id: string;
            nodes: { target: unknown; failureSummary: string }[];
          };
          return `${id}: ${nodes.map(({ target }) => String(target)).join(' ')} ${nodes[0]?.failureSummary ?? ''}`;
        });
      });
      expect(found).toEqual([]);
    },
  );

  it('flies by keyboard alone', { timeout: 120_000 }, async () => {
    const page = await openBuiltPage('?scenario=settle', SMALL);
    await untilStatus(page, 'landed');
    await page.keyboard.press('z');
    await untilStatus(page, 'flight');
    await page.keyboard.press('x');
    await untilStatus(page, 'contact', 'landed');
    await untilStatus(page, 'landed', 'crashed');
    // Help is opened, read and closed by keys; flight keys rest while it is open.
    await page.keyboard.press('?');
    await page.waitForSelector('dialog[open]');
    expect(await page.textContent('dialog')).toContain('Pitch forward');
    await page.keyboard.press('Escape');
    await page.waitForSelector('dialog', { state: 'hidden' });
    await page.keyboard.press(']');
    await page.waitForFunction(() => location.search.includes('scenario=bounce'));
    expect(problemsOf(page)).toEqual([]);
  });

  it('topples, and is righted by the key that the hint names', { timeout: 150_000 }, async () => {
    const page = await openBuiltPage('?scenario=topple', SMALL);
    await untilStatus(page, 'tipped');
    const cap = page.locator('.td-hold kbd').first();
    await cap.waitFor({ timeout: 20_000 });
    const key = ((await cap.textContent()) ?? '').toLowerCase();
    const [letGo] = /[\d.]+/.exec((await page.textContent('.td-until')) ?? '') ?? ['36'];
    expect(await page.textContent('.td-landing')).toContain('Use RCS rotation to right the ship');
    // Slowly: the software renderer's frames are far apart, and the swing must be caught below the angle.
    await page.getByLabel('Slow motion').selectOption('0.1');
    await page.getByLabel('Slow motion').blur();
    await page.keyboard.down(key);
    await untilTiltBelow(page, Number(letGo));
    await page.keyboard.up(key);
    await page.keyboard.press('t');
    await untilTiltBelow(page, 15);
    await page.getByLabel('Slow motion').selectOption('1');
    await untilStatus(page, 'landed');
    expect(problemsOf(page)).toEqual([]);
  });

  it('shares a link that ends in the same bits', { timeout: 120_000 }, async () => {
    const page = await openBuiltPage('?scenario=settle&seed=7&net=fourG', SMALL);
    await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
    const run = await endOfRun(page, 8);
    await page.getByRole('button', { name: 'Copy link' }).click({ timeout: 30_000 });
    const link = await page.evaluate(() => navigator.clipboard.readText());
    expect(new URL(link).search).toBe('?scenario=settle&net=fourG&seed=7');
    await page.context().close();
    const again = await openUrl(link, SMALL);
    expect(await endOfRun(again, 8)).toBe(run);
  });

  it(
    'shares a scenario that flies by itself: the same bits on a slow display too',
    { timeout: 150_000 },
    async () => {
      const query = '?scenario=freighter-hold&net=satellite&seed=3&slow=2';
      const page = await openBuiltPage(query, SMALL);
      const run = await endOfRun(page, 15);
      expect(run).toBe(rehearsedRun('freighter-hold'));
      await page.context().close();
      const context = await (await theBrowser()).newContext({ ...SMALL, locale: 'en-US' });
      const slow = await context.newPage();
      await slow.addInitScript(() => {
        const soon = window.requestAnimationFrame.bind(window);
        window.requestAnimationFrame = (draw) => window.setTimeout(() => soon(draw), 250);
      });
      await slow.goto(inject('builtPage') + query);
      expect(await endOfRun(slow, 15)).toBe(run);
      await context.close();
    },
  );

  it(
    'replays what it recorded, both ways, with the first divergence marked',
    { timeout: 120_000 },
    async () => {
      const page = await openBuiltPage('?scenario=settle', SMALL);
      await untilStatus(page, 'landed');
      await page.getByRole('button', { name: 'Kick the ship' }).click({ timeout: 30_000 });
      await untilStatus(page, 'flight');
      await untilStatus(page, 'landed', 'tipped');
      await page.locator('summary', { hasText: 'Recording' }).click({ timeout: 30_000 });
      await page.getByRole('button', { name: 'Replay' }).click({ timeout: 30_000 });
      await page.waitForSelector('.scrubber .mark', { state: 'visible' });
      expect(await page.textContent('#dock')).toMatch(/First divergence at tick \d+/);
      await page.locator('.scrubber input').fill('0.2');
      await untilStatus(page, 'flight');
      const end = await page.locator('.scrubber input').getAttribute('max');
      await page.locator('.scrubber input').fill(end ?? '');
      await untilStatus(page, 'landed', 'tipped');
      await page.getByRole('button', { name: 'Back to the game' }).click({ timeout: 30_000 });
      await untilProvenance(page, 'confirmed');
      expect(problemsOf(page)).toEqual([]);
    },
  );

  it('survives a minute hidden and a lost connection', { timeout: 150_000 }, async () => {
    // At four times the speed a quarter of a minute is a minute to server and predictor.
    const page = await openBuiltPage('?scenario=settle&slow=4', SMALL);
    await untilStatus(page, 'landed');
    await page.getByRole('button', { name: 'Hide for a minute' }).click({ timeout: 30_000 });
    await page.waitForTimeout(15_000);
    await page.getByRole('button', { name: /Back now/ }).click({ timeout: 30_000 });
    await untilProvenance(page, 'confirmed');
    await untilStatus(page, 'landed');

    await page.getByRole('button', { name: 'Drop the connection' }).click({ timeout: 30_000 });
    await untilProvenance(page, 'stale');
    expect(await page.textContent('#banner')).toContain('Connection lost');
    await page.getByRole('button', { name: 'Connect again' }).click({ timeout: 30_000 });
    await untilProvenance(page, 'confirmed');
    expect(await page.textContent('#banner')).toBe('');
    expect(problemsOf(page)).toEqual([]);
  });

  it('works with the network off once loaded', { timeout: 120_000 }, async () => {
    const page = await openBuiltPage('?scenario=settle&slow=4', SMALL);
    await untilStatus(page, 'landed');
    await page.context().setOffline(true);
    await page.keyboard.press(']');
    await page.waitForFunction(() => location.search.includes('scenario=bounce'));
    await untilStatus(page, 'flight', 'contact');
    await untilStatus(page, 'landed');
    expect(problemsOf(page)).toEqual([]);
  });
});
