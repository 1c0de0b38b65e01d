/** Each HUD state where the playground has it: nothing cut off, nothing over anything else. */
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { describeInBrowser, openTestPage, problemsOf } from './pages';
import { useTestFont } from './testFont';

const STATES = [
  'noData',
  'flight',
  'contact',
  'toppling',
  'landed',
  'tipped',
  'twoKeys',
  'stuck',
  'helped',
  'lighter',
  'crashed',
  'predicted',
  'confirmed',
  'stale',
  'withdrawn',
  'off',
  'wide',
];
const SIZES = [
  { width: 1280, height: 720 },
  { width: 390, height: 844 },
] as const;

/** Added to each letter: DejaVu Sans Bold, the widest of the fonts a machine may have, against the test's Open Sans. */
const WIDE = '0.11em';

interface FitWindow {
  show: (state: string, ships: number) => void;
}

async function show(page: Page, state: string, ships = 20): Promise<void> {
  await page.evaluate(([name, size]) => (window as unknown as FitWindow).show(name, size), [
    state,
    ships,
  ] as const);
  // Sizes are watched: the watchers speak after the frame.
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

/** What is cut off, sticks out of its panel, the window or an ancestor that clips, or lies over another text. */
function misfits(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const out: string[] = [];
    const texts: { readonly text: string; readonly ink: DOMRect; readonly element: Element }[] = [];
    const say = (fault: string, element: Element, text = element.textContent) =>
      out.push(`${fault}: .${element.getAttribute('class') ?? ''} ${text.slice(0, 40)}`);
    const within = (box: DOMRect, room: DOMRect) =>
      box.left >= room.left - 0.5 &&
      box.right <= room.right + 0.5 &&
      box.top >= room.top - 0.5 &&
      box.bottom <= room.bottom + 0.5;
    const clips = (element: Element) => {
      const { display, overflowX, overflowY, contain } = getComputedStyle(element);
      if (display === 'contents') return false;
      return overflowX !== 'visible' || overflowY !== 'visible' || contain !== 'none';
    };
    const isCut = (box: DOMRect, element: Element, panel: Element) => {
      for (let up: Element | null = element; up !== null && up !== panel.parentElement; up = up.parentElement)
        if ((up === panel || clips(up)) && !within(box, up.getBoundingClientRect())) return true;
      return false;
    };
    /** Where the letters are: a line's box is as tall as the font says, and neighbours' boxes may well meet. */
    const inkOf = (line: DOMRect, element: Element) => {
      const size = parseFloat(getComputedStyle(element).fontSize);
      return new DOMRect(line.left, line.top + line.height / 2 - 0.36 * size, line.width, 0.72 * size);
    };

    const root = document.documentElement;
    // On a small screen the page itself scrolls: down, never sideways.
    const room = new DOMRect(0, -scrollY, innerWidth, Math.max(innerHeight, root.scrollHeight));
    if (root.scrollWidth > innerWidth) say('scrolls sideways', root, '');
    for (const panel of document.querySelectorAll('.hud')) {
      if (!within(panel.getBoundingClientRect(), room)) say('outside the window', panel, '');
      for (const element of panel.querySelectorAll<HTMLElement | SVGElement>('*')) {
        if (element.closest('.hud-unseen, .hud-rows, .hud-shape, .hud-tick, .hud-arrow') !== null) continue;
        if (!element.checkVisibility({ visibilityProperty: true })) continue;
        const box = element.getBoundingClientRect();
        if (element.children.length === 0 && isCut(box, element.parentElement!, panel)) say('cut', element);
        if (clips(element) && !element.classList.contains('hud-scroller')) {
          if (element.scrollWidth > element.clientWidth + 1) say('wider than its room', element);
          if (element.scrollHeight > element.clientHeight + 1) say('higher than its room', element);
        }
        for (const node of element.childNodes) {
          const text = node.nodeType === Node.TEXT_NODE ? node.textContent!.trim() : '';
          if (text === '') continue;
          const range = document.createRange();
          range.selectNodeContents(node);
          for (const line of range.getClientRects()) {
            const ink = inkOf(line, element);
            texts.push({ text, ink, element });
            if (isCut(ink, element, panel)) say('cut', element);
          }
        }
      }
    }
    texts.forEach((a, i) => {
      for (const b of texts.slice(i + 1)) {
        const across = Math.min(a.ink.right, b.ink.right) - Math.max(a.ink.left, b.ink.left);
        const down = Math.min(a.ink.bottom, b.ink.bottom) - Math.max(a.ink.top, b.ink.top);
        if (across > 0.5 && down > 0.5) out.push(`one over the other: ${a.text} and ${b.text}`);
      }
    });
    const [first, second] = [...document.querySelectorAll('.hud')].map((hud) => hud.getBoundingClientRect());
    if (second!.top < first!.bottom) out.push('the fleet lies over the landing HUD');
    return [...new Set(out)];
  });
}

describeInBrowser('the HUDs on the playground', () => {
  let page: Page;
  beforeAll(async () => {
    page = await openTestPage('hudOnPage.html', { reducedMotion: 'reduce' });
    await page.waitForSelector('html[data-ready=true]');
    await useTestFont(page);
  });
  afterAll(() => page.context().close());

  for (const viewport of SIZES)
    describe(`at ${String(viewport.width)} × ${String(viewport.height)}`, () => {
      beforeAll(() => page.setViewportSize(viewport));

      it.each(STATES)('fit whole, in a narrow font and in a wide one: %s', async (state) => {
        for (const spacing of ['normal', WIDE]) {
          await page.evaluate(
            (wide) => document.documentElement.style.setProperty('letter-spacing', wide),
            spacing,
          );
          for (const ships of [1, 20]) {
            await show(page, state, ships);
            expect(await misfits(page), `${String(ships)} ships, letters ${spacing} apart`).toEqual([]);
          }
        }
        expect(problemsOf(page)).toEqual([]);
      });
    });

  it('scroll by keyboard where the window is too low, status and tilt standing still', async () => {
    await page.setViewportSize({ width: 1280, height: 720 });
    await show(page, 'tipped');
    const places = () =>
      page.evaluate(() =>
        ['.hud-status', '.hud-tilt'].map((part) =>
          JSON.stringify(document.querySelector(part)!.getBoundingClientRect()),
        ),
      );
    const before = await places();
    const parts = page.locator('.hud-parts');
    expect(await parts.getAttribute('tabindex')).toBeNull();
    await page.setViewportSize({ width: 1280, height: 480 });
    await show(page, 'tipped');
    expect(await places()).toEqual(before);
    expect(await parts.getAttribute('tabindex')).toBe('0');
    const card = page.locator('.hud-card dd').last();
    const isInSight = () =>
      card.evaluate(
        (dd) => dd.getBoundingClientRect().bottom <= dd.closest('.hud')!.getBoundingClientRect().bottom,
      );
    expect(await isInSight()).toBe(false);
    await parts.focus();
    await page.keyboard.press('End');
    await expect.poll(isInSight).toBe(true);
    expect(await places()).toEqual(before);
    // With less in it there is nothing to scroll, and no stop for Tab.
    await show(page, 'landed');
    await page.setViewportSize({ width: 1280, height: 720 });
    await show(page, 'landed');
    expect(await parts.getAttribute('tabindex')).toBeNull();
  });

  it('would be found not to fit', async () => {
    await page.setViewportSize({ width: 1280, height: 720 });
    await show(page, 'tipped');
    const low = await page.addStyleTag({ content: '#hud .hud-landing { max-height: 400px }' });
    expect((await misfits(page)).join()).toMatch(/higher than its room: \.hud-parts/);
    await low.evaluate((style) => (style as HTMLStyleElement).remove());
    const narrow = await page.addStyleTag({ content: '.hud-reading .hud-value { translate: -112px 0 }' });
    expect((await misfits(page)).join()).toMatch(/one over the other/);
    await narrow.evaluate((style) => (style as HTMLStyleElement).remove());
    expect(await misfits(page)).toEqual([]);
  });
});
