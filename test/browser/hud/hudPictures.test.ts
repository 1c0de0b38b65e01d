/** Each HUD state in both colour schemes at both sizes: its words, axe, and its picture. */
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import type { AxeResults, RunOptions } from 'axe-core';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { compareWithKept, difference, kept, TOLERANCE } from './golden';
import { describeInBrowser, openTestPage, problemsOf } from '../pages';
import { useTestFont } from './testFont';
import { untilDrawn } from '../waits';

/** State, and the text of its status slot: shape, word and provenance. */
const STATES: readonly (readonly [state: string, slot: string])[] = [
  ['noData', '◌NO DATA'],
  ['flight', '◇FLIGHTPRED'],
  ['contact', '▲CONTACTCONF 0.4 s'],
  ['toppling', '▲CONTACTCONF 0.4 s'],
  ['landed', '■LANDEDCONF 0.4 s'],
  ['tipped', '✖TIPPEDCONF 0.4 s'],
  ['stuck', '✖TIPPEDCONF 0.4 s'],
  ['crashed', '✖CRASHEDCONF 0.4 s'],
  ['predicted', '▲CONTACTPRED 0.3 s'],
  ['confirmed', '◇FLIGHTCONF 0.4 s'],
  ['stale', '▲CONTACTSTALE 2.6 s'],
  ['withdrawn', '▲CONTACTPRED 0.6 s'],
  ['off', '◇FLIGHTPRED OFF ×100'],
];
const SCHEMES = ['dark', 'light'] as const;
const SIZES = [
  { width: 1280, height: 720 },
  { width: 390, height: 844 },
] as const;
const AXE = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

interface HudWindow {
  hud: { show: (state: string) => void; showFleet: (size: number) => void };
  axe: { run: (context: unknown, options: RunOptions) => Promise<AxeResults> };
}

const show = (page: Page, state: string) =>
  page.evaluate((name) => (window as unknown as HudWindow).hud.show(name), state);

/** What axe objects to, one line each. */
async function faults(page: Page): Promise<string[]> {
  const { violations } = await page.evaluate(() =>
    (window as unknown as HudWindow).axe.run(document, { resultTypes: ['violations'] }),
  );
  return violations.flatMap(({ id, nodes }) => nodes.map((node) => `${id}: ${node.target.join(' ')}`));
}

describeInBrowser('HUD pictures', () => {
  let page: Page;
  beforeAll(async () => {
    page = await openTestPage('hud.html', { reducedMotion: 'reduce' });
    await page.waitForSelector('html[data-ready=true]');
    await useTestFont(page);
    await page.evaluate(AXE);
  });
  afterAll(() => page.context().close());

  for (const colorScheme of SCHEMES) {
    for (const viewport of SIZES) {
      const combination = `${colorScheme}-${String(viewport.width)}`;
      describe(combination, () => {
        beforeAll(async () => {
          await page.emulateMedia({ colorScheme });
          await page.setViewportSize(viewport);
          await untilDrawn(page);
        });

        it.each(STATES)('%s', async (state, slot) => {
          await show(page, state);
          expect(await page.textContent('.td-status')).toBe(slot);
          const landing = await page.locator('.td-landing').boundingBox();
          const status = await page.locator('.td-status').boundingBox();
          // The slot neither moves nor changes its size, whatever it says, and nothing runs out of the HUD.
          expect(status).toEqual(viewport.width === 390 ? slotAt390 : slotAt1280);
          expect(landing!.width).toBeLessThanOrEqual(viewport.width - 24);
          expect(await overflowing(page)).toEqual([]);
          expect(await faults(page)).toEqual([]);
          const picture = await page.locator('#landing').screenshot();
          expect(compareWithKept(`landing-${state}-${combination}`, picture)).toBe('');
        });

        it('fleet', async () => {
          await page.evaluate(() => (window as unknown as HudWindow).hud.showFleet(1000));
          await page.waitForSelector('.td-row:nth-child(12)');
          expect(await faults(page)).toEqual([]);
          const picture = await page.locator('#fleet').screenshot();
          expect(compareWithKept(`fleet-${combination}`, picture)).toBe('');
          expect(problemsOf(page)).toEqual([]);
        });
      });
    }
  }

  it('axe reports a text that is too faint', async () => {
    await show(page, 'contact');
    const style = await page.addStyleTag({ content: '.td-gates th { color: #8a8f94 }' });
    expect((await faults(page)).join()).toContain('color-contrast');
    await style.evaluate((element) => (element as HTMLStyleElement).remove());
  });

  it('the kept pictures differ between all states by more than the tolerance', () => {
    // Those that differ by a few letters alone are told apart by the text of the slot.
    const alike = new Set(['flight confirmed', 'predicted withdrawn', 'flight off', 'confirmed off']);
    const pictures = STATES.map(([state]) => [state, kept(`landing-${state}-dark-1280`)!] as const);
    for (const [a, first] of pictures) {
      for (const [b, second] of pictures) {
        if (a === b || alike.has(`${a} ${b}`) || alike.has(`${b} ${a}`)) continue;
        expect(difference(first, second), `${a} and ${b}`).toBeGreaterThan(TOLERANCE);
      }
    }
  });
});

const slotAt1280 = { x: 25, y: 55, width: 334, height: 46 };
const slotAt390 = { x: 21, y: 51, width: 342, height: 38 };

/** Texts that stick out of the HUD's box, by class. */
function overflowing(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const box = document.querySelector('.td-landing')!.getBoundingClientRect();
    const out: string[] = [];
    for (const element of document.querySelectorAll(
      '.td-landing :is(span, p, td, th, dd, dt, strong, kbd)',
    )) {
      if (element.closest('.td-unseen') !== null) continue;
      const { left, right, width } = element.getBoundingClientRect();
      if (width > 0 && (left < box.left || right > box.right))
        out.push(element.className || element.textContent);
    }
    return out;
  });
}
