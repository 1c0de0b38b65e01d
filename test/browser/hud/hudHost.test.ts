/** The HUDs on a foreign page: neither's styles affect the other, and any width works. */
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import type { HudAppearance } from '../../../src/hud';
import { compareWithGolden } from './golden';
import { misfits } from './misfits';
import { describeInBrowser, openTestPage, problemsOf } from '../pages';
import { useTestFont } from './testFont';

interface HostWindow {
  mount: (name: string, width: number, shadow: boolean, look: HudAppearance) => Promise<void>;
}

/** px; 200 is the narrowest that appearance.ts promises. */
const WIDTHS = [200, 240, 299, 300, 360, 480, 559, 560, 800];
const STATES = [
  'noData',
  'flight',
  'contact',
  'toppling',
  'landed',
  'tipped',
  'twoKeys',
  'stuck',
  'lighter',
  'stale',
  'off',
];

let page: Page;

const mount = async (
  name: string,
  width: number,
  shadow = false,
  look: HudAppearance = {},
): Promise<void> => {
  await page.evaluate((given) => (window as unknown as HostWindow).mount(...given), [
    name,
    width,
    shadow,
    look,
  ] as const);
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
};

const setStyle = (text: string) =>
  page.evaluate((css) => (document.querySelector('main')!.style.cssText = css), text);

describeInBrowser('the HUDs on a host’s page', () => {
  beforeAll(async () => {
    page = await openTestPage('hudHost.html', { reducedMotion: 'reduce', colorScheme: 'light' });
    await page.waitForSelector('html[data-ready=true]');
    await useTestFont(page);
  });
  afterAll(() => page.context().close());

  it.each(['tipped', 'contact', 'landed', 'flight'])(
    'match the golden pictures whatever the host’s styles are, in the page and in a shadow root: %s',
    async (state) => {
      for (const shadow of [false, true]) {
        await mount(state, 360, shadow);
        // Dark although the system is light: the default is for a dark background.
        const picture = await page.locator('#box').screenshot();
        expect(
          compareWithGolden(`landing-${state}-dark-1280`, picture),
          shadow ? 'shadow root' : 'page',
        ).toBe('');
      }
    },
  );

  it('leave the host’s elements unchanged', async () => {
    const look = () =>
      page.evaluate(() =>
        [...document.querySelectorAll('html, body, main, h1, p.hud')].map((element) =>
          JSON.stringify(
            [...getComputedStyle(element)].map((name) => getComputedStyle(element).getPropertyValue(name)),
          ),
        ),
      );
    await mount('tipped', 360);
    const styled = await look();
    await page.evaluate(() => (document.styleSheets[0]!.disabled = true));
    const bare = await look();
    await page.evaluate(() => (document.styleSheets[0]!.disabled = false));
    // Only the page's height follows its content.
    const names = (all: string[]) => all.slice(3);
    expect(names(styled)).toEqual(names(bare));
  });

  it('have the prefix in every class, keyframe and custom property', async () => {
    await mount('tipped', 360);
    const strange = await page.evaluate(() => {
      const found: string[] = [];
      for (const element of document.querySelectorAll('#box *'))
        for (const name of element.classList) if (!name.startsWith('td-')) found.push(`class ${name}`);
      const visit = (rules: CSSRuleList): void => {
        for (const rule of rules) {
          if (rule instanceof CSSImportRule) visit(rule.styleSheet!.cssRules);
          else if (rule instanceof CSSKeyframesRule) {
            if (!rule.name.startsWith('td-')) found.push(`keyframes ${rule.name}`);
          } else if (rule instanceof CSSStyleRule) {
            for (const name of rule.style)
              if (name.startsWith('--') && !name.startsWith('--td-')) found.push(`property ${name}`);
            if (!/\.td-|^&/.test(rule.selectorText)) {
              // All attribute selectors begin with one of our classes.
              const { selectorText } = rule;
              if (selectorText.split(',').some((part) => !part.includes('.td-'))) found.push(selectorText);
            }
            visit(rule.cssRules);
          } else if (rule instanceof CSSGroupingRule) visit(rule.cssRules);
        }
      };
      visit(document.styleSheets[0]!.cssRules);
      return found;
    });
    expect(strange).toEqual([]);
  });

  it('take colours, font and width from the host’s custom properties, also in a shadow root', async () => {
    await setStyle(
      '--touchdown-ink: rgb(1, 2, 3); --touchdown-scrim: rgb(4, 5, 6); --touchdown-max-width: 200px',
    );
    for (const shadow of [false, true]) {
      await mount('flight', 360, shadow);
      const panel = page.locator('.td-panel');
      const look = await panel.evaluate((element) => {
        const { color, backgroundColor } = getComputedStyle(element);
        return [color, backgroundColor, element.getBoundingClientRect().width];
      });
      expect(look).toEqual(['rgb(1, 2, 3)', 'rgb(4, 5, 6)', 200]);
    }
    await setStyle('');
  });

  it('are light when requested, and follow the system only when requested', async () => {
    const ink = async (look: HudAppearance) => {
      await mount('flight', 360, false, look);
      return page.locator('.td-panel').evaluate((element) => getComputedStyle(element).color);
    };
    const dark = 'rgb(239, 244, 249)';
    const light = 'rgb(15, 23, 32)';
    expect([await ink({}), await ink({ theme: 'light' }), await ink({ theme: 'system' })]).toEqual([
      dark,
      light,
      light,
    ]);
    await page.emulateMedia({ colorScheme: 'dark' });
    expect([await ink({}), await ink({ theme: 'light' }), await ink({ theme: 'system' })]).toEqual([
      dark,
      light,
      dark,
    ]);
    await page.emulateMedia({ colorScheme: 'light' });
  });

  it.each(WIDTHS)('fit into a container of %i px', async (width) => {
    await setStyle('--touchdown-max-width: none');
    for (const layout of ['full', 'compact'] as const)
      for (const state of [...STATES, 'fleet']) {
        if (layout === 'compact' && width > 559) continue;
        await mount(state, width, false, { layout });
        expect(await misfits(page), `${state}, ${layout}`).toEqual([]);
      }
    await setStyle('');
    expect(problemsOf(page)).toEqual([]);
  });
});
