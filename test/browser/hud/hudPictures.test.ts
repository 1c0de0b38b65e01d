/** Each HUD state in both colour schemes at both sizes: its words, axe, and its picture. */
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { axeFaults, OF_COLOUR } from '../axe';
import { compareWithGolden, difference, goldenPicture, TOLERANCE } from './golden';
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

interface HudWindow {
  hud: { show: (state: string) => void; showFleet: (size: number) => void };
}

const show = (page: Page, state: string) =>
  page.evaluate((name) => (window as unknown as HudWindow).hud.show(name), state);

describeInBrowser('HUD pictures', () => {
  let page: Page;
  beforeAll(async () => {
    page = await openTestPage('hud.html', { reducedMotion: 'reduce' });
    await page.waitForSelector('html[data-ready=true]');
    await useTestFont(page);
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
          // The slot keeps its place and size with any text, and nothing overflows the HUD.
          expect(status).toEqual(viewport.width === 390 ? slotAt390 : slotAt1280);
          expect(landing!.width).toBeLessThanOrEqual(viewport.width - 24);
          expect(await overflowing(page)).toEqual([]);
          // Another scheme changes colours alone. The document and its fleet are checked by the fleet's test.
          const rules = colorScheme === SCHEMES[0] ? undefined : OF_COLOUR;
          expect(await axeFaults(page, { within: '#landing', rules })).toEqual([]);
          const picture = await page.locator('#landing').screenshot();
          expect(compareWithGolden(`landing-${state}-${combination}`, picture)).toBe('');
        });

        it('fleet', async () => {
          await page.evaluate(() => (window as unknown as HudWindow).hud.showFleet(1000));
          await page.waitForSelector('.td-row:nth-child(12)');
          expect(await axeFaults(page)).toEqual([]);
          const picture = await page.locator('#fleet').screenshot();
          expect(compareWithGolden(`fleet-${combination}`, picture)).toBe('');
          expect(problemsOf(page)).toEqual([]);
        });
      });
    }
  }

  describe('the markup equals the golden one, even where a picture’s tolerance hides a difference', () => {
    beforeAll(() => page.setViewportSize(SIZES[0]));

    it.each(['flight', 'contact', 'landed', 'tipped', 'crashed'])('%s', async (state) => {
      await show(page, state);
      await untilDrawn(page);
      await expect(await markupOf(page, '#landing')).toMatchFileSnapshot(`markup/${state}.txt`);
    });

    it('fleet', async () => {
      await page.evaluate(() => (window as unknown as HudWindow).hud.showFleet(20));
      await untilDrawn(page);
      await expect(await markupOf(page, '#fleet')).toMatchFileSnapshot('markup/fleet.txt');
    });
  });

  it('axe reports a text that is too faint', async () => {
    await show(page, 'contact');
    const style = await page.addStyleTag({ content: '.td-gates th { color: #8a8f94 }' });
    expect((await axeFaults(page)).join()).toContain('color-contrast');
    await style.evaluate((element) => (element as HTMLStyleElement).remove());
  });

  it('the golden pictures differ between all states by more than the tolerance', () => {
    // Those that differ only by a few letters are distinguished by the text of the slot.
    const alike = new Set(['flight confirmed', 'predicted withdrawn', 'flight off', 'confirmed off']);
    const pictures = STATES.map(([state]) => [state, goldenPicture(`landing-${state}-dark-1280`)!] as const);
    for (const [i, [a, first]] of pictures.entries()) {
      for (const [b, second] of pictures.slice(i + 1)) {
        if (alike.has(`${a} ${b}`) || alike.has(`${b} ${a}`)) continue;
        expect(difference(first, second), `${a} and ${b}`).toBeGreaterThan(TOLERANCE);
      }
    }
  });
});

const slotAt1280 = { x: 25, y: 55, width: 334, height: 46 };
const slotAt390 = { x: 21, y: 51, width: 342, height: 38 };

/**
 * Elements with their attributes, and texts, one per line; without the side that an animation is on, which alternates, and whether the
 * parts scroll, which hudFits.test.ts holds.
 */
function markupOf(page: Page, selector: string): Promise<string> {
  return page.locator(selector).evaluate((host) => {
    const lines: string[] = [];
    const write = (node: Node, indent: string) => {
      if (node.nodeType === 3 && node.nodeValue !== '') lines.push(`${indent}“${node.nodeValue ?? ''}”`);
      // Hidden and announced texts belong to an earlier state.
      if (!(node instanceof Element) || node.matches('[hidden], [role=status], [role=alert]')) return;
      const attributes = [...node.attributes]
        .filter(({ name }) => name !== 'data-pulse' && !(name !== 'class' && node.matches('.td-parts')))
        .map(({ name, value }) => `${name}="${value}"`)
        .sort();
      lines.push(indent + [node.localName, ...attributes].join(' '));
      for (const child of node.childNodes) write(child, `${indent}  `);
    };
    for (const child of host.childNodes) write(child, '');
    return `${lines.join('\n')}\n`;
  });
}

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
