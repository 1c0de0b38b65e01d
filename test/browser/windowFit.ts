/** What is cut off or covered in a window of the page, and how to change the window. */
import type { Page } from 'playwright-core';
import { expect } from 'vitest';
import { misfits } from './hud/misfits';
import { untilDrawn } from './waits';

export const USUAL_LETTERS = { fontSizes: { standard: 16, fixed: 13 } };
export const LARGE_LETTERS = { fontSizes: { standard: 32, fixed: 26 } };

/** Parts of the page that are cut off, wider than the window, or cover something that must be visible. */
function pageMisfits(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const out: string[] = [];
    const boxOf = (id: string) => {
      const part = document.getElementById(id)!;
      return part.checkVisibility() ? part.getBoundingClientRect() : null;
    };
    for (const id of ['goal', 'banner', 'notice', 'card', 'pads', 'panel', 'foot', 'flight', 'hud']) {
      const box = boxOf(id);
      if (box === null || box.width === 0) continue;
      if (box.left < -0.5 || box.right > innerWidth + 0.5) out.push(`${id} is wider than the window`);
      const part = document.getElementById(id)!;
      if (part.scrollWidth > part.clientWidth + 1) out.push(`${id} is cut off at its side`);
    }
    const [goal, pads, picture] = ['goal', 'pads', 'picture'].map(boxOf);
    if (goal && pads && goal.bottom > pads.top) out.push('goal and pads overlap');
    if (pads && picture && pads.height > 0.6 * picture.height) out.push('pads cover the picture');
    if (goal && goal.bottom > innerHeight) out.push('the goal is below the fold');
    if (document.documentElement.scrollWidth > innerWidth) out.push('the page scrolls sideways');
    return out;
  });
}

/** Faults of the page as it is, and with letters of 200 %. */
export async function faultsOf(page: Page): Promise<string[]> {
  const faults = async () => [...(await misfits(page)), ...(await pageMisfits(page))];
  const found = await faults();
  await setLetters(page, LARGE_LETTERS);
  await untilDrawn(page);
  found.push(...(await faults()).map((fault) => `200 %: ${fault}`));
  await setLetters(page, USUAL_LETTERS);
  return found;
}

export async function setLetters(page: Page, letters: typeof USUAL_LETTERS): Promise<void> {
  const cdp = await page.context().newCDPSession(page);
  await cdp.send('Page.setFontSizes', letters);
  await expect
    .poll(() => page.evaluate(() => getComputedStyle(document.documentElement).fontSize))
    .toBe(`${letters.fontSizes.standard}px`);
  await cdp.detach();
}

/** Gives the window another size, which the page has when this resolves. */
export async function resize(page: Page, width: number, height: number): Promise<void> {
  await page.setViewportSize({ width, height });
  await untilDrawn(page);
}

/** Shows the card of a flight that has ended, with so many lines; without it for 0. */
export async function showCard(page: Page, lines: number): Promise<void> {
  await page.evaluate((count) => {
    const card = document.getElementById('card')!;
    card.textContent = 'A line of the score.\n'.repeat(count);
    card.hidden = count === 0;
    document.documentElement.dataset['phase'] = count === 0 ? 'flying' : 'done';
  }, lines);
  await untilDrawn(page);
}

/** Height between the lower edge of one part and the upper edge of another, as a share of the picture's height. */
export function freeShare(page: Page, above: string, below: string): Promise<number> {
  return page.evaluate(
    (parts) => {
      const [over, under, picture] = parts.map((part) =>
        document.querySelector(part)!.getBoundingClientRect(),
      );
      return (under!.top - over!.bottom) / picture!.height;
    },
    [above, below, '#picture'],
  );
}
