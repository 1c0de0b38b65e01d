/** The landing HUD in a real browser: its DOM changes, and its output for screen readers. */
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { createLandingReadout, type TipMargin } from '../../../src/readout';
import { describeInBrowser, openTestPage, problemsOf } from '../pages';

interface HudWindow {
  hud: {
    show: (state: string) => void;
    again: (times: number) => void;
    rebind: (action: string, label: string) => void;
    landing: { dispose: () => void; paint: (readout: object) => void };
    fleet: { dispose: () => void };
  };
}

let page: Page;

const show = (...states: string[]) =>
  page.evaluate((names) => {
    for (const name of names) (window as unknown as HudWindow).hud.show(name);
  }, states);

async function open(reducedMotion: 'reduce' | 'no-preference' = 'reduce'): Promise<void> {
  page = await openTestPage('hud.html', { reducedMotion });
  await page.waitForSelector('html[data-ready=true]');
}

describeInBrowser('the landing HUD', () => {
  beforeAll(() => open());
  afterAll(() => page.context().close());

  it('prints the design’s words in each state', async () => {
    await show('tipped');
    expect(await page.textContent('.td-hint')).toBe('Use RCS rotation to right the ship');
    expect(await page.locator('.td-hint').isVisible()).toBe(true);
    await show('landed');
    expect(await page.locator('.td-landed').textContent()).toBe('Landed');
    expect(await page.locator('.td-hint').isVisible()).toBe(false);
    await show('flight');
    expect(await page.locator('.td-descent').innerText()).toBe(
      'VSPD\n↓ 12.3 m/s\nHSPD\n7.2 m/s\nTTI\n5.2 s\nAGL\n85.8 m',
    );
    await show('withdrawn');
    expect(await page.textContent('.td-withdrawn')).toBe('LANDED withdrawn');
  });

  it('paints the design’s colours', async () => {
    const look = async (state: string) => {
      await show(state);
      return page.locator('.td-status').evaluate((slot) => {
        const { color, backgroundColor } = getComputedStyle(slot);
        return `${color} on ${backgroundColor}`;
      });
    };
    // #ffd24a text; white on #b3261e; cyan.
    expect(await look('contact')).toMatch(/^rgb\(255, 210, 74\) on rgb\(11, 16, 23\)$/);
    expect(await look('tipped')).toBe('rgb(255, 255, 255) on rgb(179, 38, 30)');
    expect(await look('landed')).toBe('rgb(127, 228, 255) on rgb(11, 16, 23)');
    expect(await look('flight')).toBe('rgb(255, 255, 255) on rgb(11, 16, 23)');
    const opacity = await page.locator('.td-landing > .td-panel').evaluate((hud) => {
      return Number(/([\d.]+)\)$/.exec(getComputedStyle(hud).backgroundColor)?.[1]);
    });
    expect(opacity).toBeGreaterThanOrEqual(0.75);
  });

  it('makes the tilt the largest number in contact and tipped, and the descent in flight', async () => {
    const largest = async (state: string) => {
      await show(state);
      return page.evaluate(() => {
        const numbers = [
          ...document.querySelectorAll<HTMLElement>('.td-landing :is(.td-value, .td-tilt-value)'),
        ];
        const size = (element: Element) => parseFloat(getComputedStyle(element).fontSize);
        const [first, second] = numbers
          .filter((n) => n.offsetParent !== null)
          .sort((a, b) => size(b) - size(a));
        return size(first!) > size(second!) ? first!.textContent : 'none';
      });
    };
    expect(await largest('contact')).toBe('7.5°');
    expect(await largest('tipped')).toBe('89.6°');
  });

  it('prints a dash for every number when no state has arrived for two ticks', async () => {
    await show('contact', 'stale');
    expect(await page.locator('.td-descent').innerText()).toBe('VSPD\n--\nHSPD\n--\nTTI\n--\nAGL\n--');
    expect(await page.textContent('.td-tilt-value')).toBe('--');
    expect(await page.locator('.td-gates').isVisible()).toBe(false);
    const hatched = await page
      .locator('.td-status')
      .evaluate((slot) => getComputedStyle(slot).backgroundImage);
    expect(hatched).toContain('repeating-linear-gradient');
  });

  it('touches the DOM only where the display changed', async () => {
    const changes = (state: string | null) =>
      page.evaluate((name) => {
        const { hud } = window as unknown as HudWindow;
        const watcher = new MutationObserver(() => undefined);
        const what = { subtree: true, childList: true, characterData: true, attributes: true };
        watcher.observe(document.querySelector('.td-landing')!, what);
        if (name === null) hud.again(100);
        else hud.show(name);
        return watcher.takeRecords().map((record) => record.target.nodeName);
      }, state);
    for (const state of ['flight', 'contact', 'tipped', 'landed', 'stale']) {
      await show(state);
      expect(await changes(null), state).toEqual([]);
    }
    await show('flight');
    expect(await changes('nudged')).toEqual([]);
    // Only provenance differs: its text, the attribute for its style, and the announcement of the confirmed state.
    await show('flight');
    expect((await changes('confirmed')).sort()).toEqual(['#text', 'P', 'SPAN']);
  });

  it('names the current key bindings', async () => {
    await show('tipped');
    expect(await page.locator('.td-righting kbd:visible').allTextContents()).toEqual(['W', 'T']);
    await page.evaluate(() => (window as unknown as HudWindow).hud.rebind('pitchMinus', '7'));
    await show('tipped');
    expect(await page.locator('.td-righting kbd:visible').allTextContents()).toEqual(['7', 'T']);
    await page.evaluate(() => (window as unknown as HudWindow).hud.rebind('pitchMinus', ''));
    await show('tipped');
    expect(await page.locator('.td-righting kbd:visible').allTextContents()).toEqual(['T']);
    expect(await page.locator('.td-hold').first().innerText()).toContain('pitch −');
    await page.evaluate(() => (window as unknown as HudWindow).hud.rebind('pitchMinus', 'W'));
  });

  it('words the tip margin by its outlook, also where that alone changes', async () => {
    const readout = { ...createLandingReadout(), memory: null };
    const margins: readonly Partial<TipMargin>[] = [
      { shown: false },
      { shown: true, outlook: 'steady', degrees: 24.46 },
      { shown: true, outlook: 'holds', degrees: -3 },
      { shown: true, outlook: 'working', degrees: -3 },
      { shown: true, outlook: 'tips', degrees: -3, timeToTipped: 4.2 },
      { shown: false, degrees: -3 },
    ];
    const seen = await page.evaluate(
      ([given, all]) =>
        all.map((margin) => {
          const { hud } = window as unknown as HudWindow;
          hud.landing.paint({ ...given, margin: { ...given.margin, ...margin } });
          const { dataset, textContent } = document.querySelector<HTMLElement>('.td-margin')!;
          return `${dataset['outlook']!}: ${textContent}`;
        }),
      [readout, margins] as const,
    );
    const past = ['holds: past, but held', 'working: past the point of no return', 'tips: tips in 4.2 s'];
    expect(seen).toEqual(['none: ', 'steady: 24.5° to tip', ...past, 'none: ']);
  });

  it('reports that a ship cannot be righted', async () => {
    await show('stuck');
    expect(await page.locator('.td-verdict').innerText()).toContain('cannot be righted here');
    expect(await page.locator('.td-hold:visible').count()).toBe(0);
    // The design's hint is always there, with the reason below.
    expect(await page.locator('.td-hint').isVisible()).toBe(true);
    await show('helped');
    expect(await page.locator('.td-verdict').innerText()).toContain('Take weight off its feet with');
    expect(await page.locator('.td-verdict kbd:visible').allTextContents()).toEqual(['I']);
    expect(await page.locator('.td-hint').isVisible()).toBe(true);
    await show('lighter');
    expect(await page.locator('.td-verdict').innerText()).toMatch(
      /Burn fuel until it weighs less than\s+\d\d.\d{3} kg/,
    );
    await show('tipped');
    expect(await page.locator('.td-verdict').isVisible()).toBe(false);
  });

  it('announces confirmed transitions once, and alerts for TIPPED and CRASHED only', async () => {
    await page.reload();
    await page.waitForSelector('html[data-ready=true]');
    const told = async () => [
      await page.textContent('[role=status]'),
      await page.textContent('[role=alert]'),
    ];
    expect(await page.locator('.td-landing [role=status]').count()).toBe(1);
    expect(await page.locator('.td-landing [role=alert]').count()).toBe(1);
    await show('confirmed');
    expect(await told()).toEqual(['', '']);
    await show('predicted');
    expect(await told()).toEqual(['', '']);
    await show('contact');
    expect(await told()).toEqual(['Kestrel: contact', '']);
    await show('landed');
    expect(await told()).toEqual(['Kestrel: landed', '']);
    await show('tipped');
    expect(await told()).toEqual(['', 'Kestrel: tipped']);
    await show('stale', 'off', 'noData');
    expect(await told()).toEqual(['', 'Kestrel: tipped']);
    await show('crashed');
    expect(await told()).toEqual(['', 'Kestrel: crashed']);
  });

  it('gives its gauges as meters with a text value', async () => {
    await show('contact');
    const meters = await page.locator('.td-landing [role=meter]').evaluateAll((all) =>
      all.map((meter) => {
        const text = (name: string) => meter.getAttribute(`aria-${name}`);
        return `${text('label')!}: ${text('valuetext')!} (${text('valuenow')!} of ${text('valuemax')!})`;
      }),
    );
    expect(meters[0]).toBe('Tilt: 8.0° of tilt (8 of 180)');
    expect(meters[1]).toMatch(
      /^Drift along the ground: \d\.0 m\/s along X, \d\.0 m\/s along Y \(\d of 10\)$/,
    );
  });

  it('removes itself from the host', async () => {
    await page.evaluate(() => {
      const { hud } = window as unknown as HudWindow;
      hud.landing.dispose();
      hud.fleet.dispose();
    });
    expect(await page.locator('.td-hud').count()).toBe(0);
    expect(problemsOf(page)).toEqual([]);
  });
});

describeInBrowser('the pulse', () => {
  beforeAll(() => open('no-preference'));
  afterAll(() => page.context().close());

  const animation = () =>
    page.locator('.td-status').evaluate((slot) => {
      const { animationName, animationDuration, animationIterationCount } = getComputedStyle(slot);
      return `${animationName} ${animationDuration} ${animationIterationCount}`;
    });

  it('lasts 300 ms when a ground state begins', async () => {
    await show('flight');
    expect(await animation()).toMatch(/^none/);
    await show('contact');
    expect(await animation()).toBe('td-pulse-a 0.3s 1');
    await show('landed');
    expect(await animation()).toBe('td-pulse-b 0.3s 1');
  });

  it('is absent for users who prefer reduced motion', async () => {
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await show('flight', 'contact');
    expect(await animation()).toMatch(/^none/);
  });
});
