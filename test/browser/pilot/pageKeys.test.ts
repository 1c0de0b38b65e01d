/** Keys on the built page that a browser loses sight of, and keys of other layouts. */
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, beforeEach, expect, it } from 'vitest';
import { describeInBrowser, openBuiltPage, problemsOf } from '../pages';
import { ON_INSTRUMENTS, untilBanner, untilStatus } from '../waits';

const throttleOf = (page: Page) => page.locator('.td-lever').getAttribute('aria-valuenow').then(Number);

const stroke = (page: Page, code: string, key: string, type = 'keydown') =>
  page.evaluate(
    ([name, at, printed]) =>
      document.body.dispatchEvent(new KeyboardEvent(name!, { code: at!, key: printed!, bubbles: true })),
    [type, code, key],
  );

/** Waits until the lever has not moved for some frames: if its key were still held, it would reach its end. */
async function untilLeverRests(page: Page): Promise<number> {
  let before = NaN;
  await expect
    .poll(
      async () => {
        const now = await throttleOf(page);
        const rests = now === before;
        before = now;
        return rests;
      },
      { interval: 1500 },
    )
    .toBe(true);
  return before;
}

/** Ways in which a page misses a key's release. */
const LOSSES: Readonly<Record<string, () => void>> = {
  'Command goes down': () =>
    void document.body.dispatchEvent(
      new KeyboardEvent('keydown', { code: 'MetaLeft', key: 'Meta', bubbles: true }),
    ),
  'the window loses the focus': () => void window.dispatchEvent(new Event('blur')),
  'the tab is hidden': () => {
    Object.defineProperty(document, 'visibilityState', { value: 'hidden', configurable: true });
    document.dispatchEvent(new Event('visibilitychange'));
    Object.defineProperty(document, 'visibilityState', { value: 'visible', configurable: true });
  },
  'the page is left': () => void window.dispatchEvent(new Event('pagehide')),
  'the page is frozen': () => void document.dispatchEvent(new Event('freeze')),
  'a text field gets the focus': () => document.querySelector<HTMLInputElement>('input[type=text]')!.focus(),
};

/** What is printed on the places of F, X and Z, where P is, and what it prints there. */
const LAYOUTS = [
  ['QWERTY', 'f', 'x', 'z', 'KeyP', 'p'],
  ['QWERTZ', 'f', 'x', 'y', 'KeyP', 'p'],
  ['AZERTY', 'f', 'x', 'w', 'KeyP', 'p'],
  ['Dvorak', 'u', 'q', ';', 'KeyR', 'p'],
  ['Colemak', 't', 'x', 'z', 'KeyR', 'p'],
  ['Cyrillic', 'а', 'ч', 'я', 'KeyP', 'з'],
] as const;

describeInBrowser('keys on the built page', () => {
  let page: Page;
  beforeAll(async () => {
    page = await openBuiltPage('?scenario=launch', ON_INSTRUMENTS);
  });
  beforeEach(async () => {
    await page.getByRole('button', { name: 'Restart', exact: true }).click();
    await untilStatus(page, 'landed');
  });
  afterAll(() => page.context().close());

  it('flies with the focus anywhere but in a text field, and releases keys when it loses the focus', async () => {
    const full = () => expect.poll(() => throttleOf(page)).toBe(100);
    const cut = async () => {
      await page.keyboard.press('x');
      await expect.poll(() => throttleOf(page)).toBe(0);
    };
    await page.getByLabel('Mission').focus();
    await page.keyboard.press('z');
    await full();
    expect(await page.getByLabel('Mission').inputValue()).toBe('launch');
    await cut();
    await page.getByLabel('Footprint').focus();
    await page.keyboard.press('z');
    await full();
    await cut();
    // A Cyrillic keyboard: the key's position counts.
    await stroke(page, 'KeyZ', 'я');
    await full();
    await cut();
    // Command is pressed while a key is held: macOS never reports the key's release.
    await page.keyboard.down('f');
    await expect.poll(() => throttleOf(page)).toBeGreaterThan(2);
    await stroke(page, 'MetaLeft', 'Meta');
    // If it were still held, the lever would reach its end.
    await page.waitForFunction(() => {
      const now = document.querySelector('.td-lever')!.getAttribute('aria-valuenow');
      const kept = window as unknown as { lever?: string | null; frames?: number };
      kept.frames = kept.lever === now ? (kept.frames ?? 0) + 1 : 0;
      kept.lever = now;
      return kept.frames > 5;
    });
    expect(await throttleOf(page)).toBeLessThan(100);
    expect(problemsOf(page)).toEqual([]);
  });

  it('held keys are released whenever the browser stops reporting them', async () => {
    await page.locator('summary', { hasText: 'World' }).click();
    for (const [how, lose] of Object.entries(LOSSES)) {
      await page.locator('#scene-view').focus();
      await stroke(page, 'KeyX', 'x');
      await stroke(page, 'KeyX', 'x', 'keyup');
      await expect.poll(() => throttleOf(page)).toBe(0);
      await stroke(page, 'KeyF', 'f');
      await expect.poll(() => throttleOf(page)).toBeGreaterThan(1);
      await page.evaluate(lose);
      expect(await untilLeverRests(page), how).toBeLessThan(100);
    }
    expect(problemsOf(page)).toEqual([]);
  });

  it('fly by place and command by letter on six layouts, changed while the page is open', async () => {
    const tap = async (code: string, key: string) => {
      await stroke(page, code, key);
      await stroke(page, code, key, 'keyup');
    };
    for (const [name, more, cut, full, pause, p] of LAYOUTS) {
      await tap('KeyZ', full);
      await expect.poll(() => throttleOf(page), { message: name }).toBe(100);
      await tap('KeyX', cut);
      await expect.poll(() => throttleOf(page), { message: name }).toBe(0);
      await tap('KeyF', more);
      await expect.poll(() => throttleOf(page), { message: name }).toBeGreaterThan(0);
      await tap(pause, p);
      await untilBanner(page, 'Paused');
      await tap(pause, p);
      await expect.poll(() => page.textContent('#banner'), { message: name }).not.toContain('Paused');
    }
    expect(problemsOf(page)).toEqual([]);
  });
});
