/** The simulation of the built page: a scenario's end, the same bits for everyone, and a pilot's inputs. */
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { hashRows, readShip, SHIP_STRIDE } from '../../../src/dynamics';
import { runScenario, SCENARIOS } from '../../../src/scenarios';
import { describeInBrowser, openBuiltPage, openUrl, problemsOf } from '../pages';
import { FLUENT, ON_INSTRUMENTS, PATIENT, SLOW, SMALL, untilStatus, untilTiltBelow } from '../waits';

/**
 * Tick and bits of the player's ship at the scenario's end. Not sped up: of more than four states between two frames of a slow display the
 * page reads only the newest, which may not be the expected one.
 */
async function endOfRun(page: Page, lastTick: number): Promise<string> {
  await page.waitForFunction(
    (tick) => document.documentElement.dataset['run']?.startsWith(`${tick}:`),
    lastTick,
    PATIENT,
  );
  return (await page.evaluate(() => document.documentElement.dataset['run'])) ?? '';
}

/** The same of a scenario on the dynamics alone, without a page: on the hills, where the page opens it. */
function scenarioRun(name: string): string {
  const scenario = SCENARIOS.find((candidate) => candidate.name === name)!;
  const run = runScenario({ ...scenario, terrain: 'hills' });
  if (!run.ok) throw new Error(run.reason);
  const { ships, world } = run.value;
  const last = ships.length - SHIP_STRIDE;
  const end = readShip(ships, last, world);
  const vectors = [end.relativePosition, end.relativeVelocity, end.attitude, end.angularVelocity].flat();
  return `${last / SHIP_STRIDE}:${String(hashRows(Float64Array.of(...vectors, end.fuel)))}`;
}

describeInBrowser('a run on the built page', () => {
  it('topples, and is righted by the keys that the hint names', async () => {
    const page = await openBuiltPage('?scenario=topple&slow=4', SMALL);
    await untilStatus(page, 'tipped');
    // One key or two together: they follow the camera.
    const caps = page.locator('.td-hold').first().locator('kbd:visible');
    await caps.first().waitFor();
    const keys = (await caps.allTextContents()).map((cap) => cap.toLowerCase());
    const [letGo] = /[\d.]+/.exec((await page.textContent('.td-until')) ?? '') ?? ['36'];
    expect(await page.textContent('.td-landing')).toContain('Use RCS rotation to right the ship');
    // In slow motion: the software renderer's frames are far apart, and the rotation must be stopped below the angle.
    await page.getByLabel('Speed').selectOption('0.1');
    for (const key of keys) await page.keyboard.down(key);
    await untilTiltBelow(page, Number(letGo));
    for (const key of keys) await page.keyboard.up(key);
    await page.keyboard.press('t');
    await page.getByLabel('Speed').selectOption('4');
    await untilTiltBelow(page, 15);
    await untilStatus(page, 'landed');
    expect(problemsOf(page)).toEqual([]);
  });

  it('shares a link that ends in the same bits', async () => {
    const page = await openBuiltPage('?scenario=settle&seed=7&net=fourG&slow=1.6', ON_INSTRUMENTS);
    // No speed of the list.
    expect(await page.getByLabel('Speed').evaluate((list: HTMLSelectElement) => list.value)).toBe('1.6');
    await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
    await page.getByRole('button', { name: 'Copy link' }).click();
    let link = '';
    // Pages of other tests have the same clipboard.
    await expect
      .poll(async () => (link = await page.evaluate(() => navigator.clipboard.readText())))
      .toContain('net=fourG');
    expect(new URL(link).search).toBe('?scenario=settle&net=fourG&seed=7&slow=1.6');
    const again = await openUrl(link, ON_INSTRUMENTS);
    const [run, shared] = await Promise.all([endOfRun(page, 8), endOfRun(again, 8)]);
    expect(shared).toBe(run);
  });

  it('shares a scenario with planned inputs: the same bits on a slow display too', async () => {
    const query = '?scenario=freighter-hold&net=satellite&seed=3&slow=2';
    const pages = await Promise.all(
      [FLUENT, SLOW].map((display) => openBuiltPage(query, { ...display, hasWebGL: false })),
    );
    const run = scenarioRun('freighter-hold');
    expect(await Promise.all(pages.map((page) => endOfRun(page, 15)))).toEqual([run, run]);
  });
});
