/** The built page by gamepad, by fingers and by ear. */
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { describeInBrowser, openBuiltPage, problemsOf } from '../pages';
import { FLUENT, untilBanner, untilPhase } from '../waits';

const throttleOf = (page: Page) => page.locator('.td-lever').getAttribute('aria-valuenow').then(Number);
const tiltOf = (page: Page) =>
  page.locator('.td-landing [role=meter][aria-label=Tilt]').getAttribute('aria-valuenow').then(Number);

interface PadWindow {
  pad: { axes: number[]; buttons: { pressed: boolean; value: number }[] };
  pads: unknown[];
}

/** A gamepad of the standard mapping that a test moves; runs before the page's own scripts. */
function plugIn(): void {
  const buttons = Array.from({ length: 17 }, () => ({ pressed: false, value: 0 }));
  const pad = { id: 'Test pad', index: 0, connected: true, mapping: 'standard', axes: [0, 0, 0, 0], buttons };
  const pads: unknown[] = [];
  Object.assign(window, { pad, pads });
  navigator.getGamepads = () => pads as Gamepad[];
}

const button = (page: Page, number: number, value: number) =>
  page.evaluate(
    ([at, to]) => {
      (window as unknown as PadWindow).pad.buttons[at!] = { pressed: to! > 0.5, value: to! };
    },
    [number, value],
  );
const axis = (page: Page, number: number, value: number) =>
  page.evaluate(
    ([at, to]) => {
      (window as unknown as PadWindow).pad.axes[at!] = to!;
    },
    [number, value],
  );
const [A, B, Y, RIGHT_TRIGGER] = [0, 1, 3, 7];

interface SoundWindow {
  contexts: AudioContext[];
}

/** Keeps the page's audio contexts; runs before its own scripts. */
function listenIn(): void {
  const contexts: AudioContext[] = [];
  const Given = window.AudioContext;
  Object.assign(window, {
    contexts,
    AudioContext: class extends Given {
      constructor() {
        super();
        contexts.push(this);
      }
    },
  });
}

describeInBrowser('on the built page', () => {
  let page: Page;
  beforeAll(async () => {
    const prepare = async (opened: Page) => {
      await opened.addInitScript(plugIn);
      await opened.addInitScript(listenIn);
    };
    page = await openBuiltPage('', { ...FLUENT, hasWebGL: false, prepare });
    await page.waitForSelector('html[data-ready=true]');
  });
  afterAll(() => page.context().close());

  it('a gamepad is named, flies by triggers and sticks, lands by its autopilot button, and continues with A', async () => {
    await page.evaluate(() => {
      const { pads, pad } = window as unknown as PadWindow;
      pads.push(pad);
      window.dispatchEvent(new Event('gamepadconnected'));
    });
    await untilBanner(page, 'Gamepad: Test pad');
    await expect
      .poll(() => page.textContent('#goal'))
      .toContain('You fly: RT more thrust, LT less, B cut the engine.');
    await expect
      .poll(() => page.locator('.td-modes kbd').allTextContents())
      .toEqual(['X', '→', '↑', '←', 'Y', '↓']);
    await button(page, RIGHT_TRIGGER, 1);
    await expect.poll(() => throttleOf(page)).toBeGreaterThan(20);
    await button(page, RIGHT_TRIGGER, 0);
    await button(page, B, 1);
    await expect.poll(() => throttleOf(page)).toBe(0);
    await button(page, B, 0);
    // A worn stick does not return to 0: this must count as no input.
    await axis(page, 0, 0.1);
    expect(await tiltOf(page)).toBeLessThan(0.5);
    await axis(page, 0, 1);
    await expect.poll(() => tiltOf(page)).toBeGreaterThan(2);
    await axis(page, 0, 0);
    await button(page, Y, 1);
    await button(page, Y, 0);
    await page.locator('summary', { hasText: 'Workshop' }).click();
    await page.getByLabel('Speed').selectOption('4');
    await untilPhase(page, 'done');
    await button(page, A, 1);
    await page.waitForFunction(() => location.search.includes('scenario=sidestep'));
    await page.evaluate(() => (window as unknown as PadWindow).pads.splice(0));
    await untilBanner(page, 'Gamepad disconnected.');
    await expect.poll(() => page.textContent('#goal')).toContain('W');
    expect(problemsOf(page)).toEqual([]);
  });

  it('sound is off at first; its key and its button switch it on and off', async () => {
    const states = () =>
      page.evaluate(() => (window as unknown as SoundWindow).contexts.map(({ state }) => state));
    await page.keyboard.press('z');
    expect(await states()).toEqual([]);
    const soundButton = page.getByRole('button', { name: 'Sound' });
    expect(await soundButton.getAttribute('aria-pressed')).toBe('false');
    await page.keyboard.press('2');
    await expect.poll(states).toEqual(['running']);
    await untilBanner(page, 'Sound on.');
    expect(await soundButton.getAttribute('aria-pressed')).toBe('true');
    await page.keyboard.press('2');
    await expect.poll(states).toEqual(['suspended']);
    await soundButton.click();
    await expect.poll(states).toEqual(['running']);
    expect(problemsOf(page)).toEqual([]);
  });
});

interface Point {
  readonly x: number;
  readonly y: number;
}

describeInBrowser('fingers on the built page', () => {
  it('tilt, push and lift at once, move the lever, let go, and scroll what is below the picture', async () => {
    const page = await openBuiltPage('', {
      ...FLUENT,
      hasWebGL: false,
      viewport: { width: 390, height: 844 },
      hasTouch: true,
      isMobile: true,
    });
    await page.waitForSelector('html[data-ready=true]');
    const cdp = await page.context().newCDPSession(page);
    const touch = (
      type: 'touchStart' | 'touchMove' | 'touchEnd',
      ...touchPoints: (Point & { id: number })[]
    ) => cdp.send('Input.dispatchTouchEvent', { type, touchPoints });
    const middleOf = async (selector: string): Promise<Point> => {
      const { x, y, width, height } = (await page.locator(selector).boundingBox())!;
      return { x: x + width / 2, y: y + height / 2 };
    };
    const stick = (name: string) => middleOf(`.thumb:has-text("${name}")`);
    const [tilt, push, lift] = [await stick('Tilt'), await stick('Push'), await stick('Lift')];
    const descent = async () =>
      parseFloat((await page.textContent('.td-reading-vspd .td-value'))!.replace(/^\D+/, ''));
    const fell = await descent();
    await touch('touchStart', { ...tilt, id: 0 }, { ...push, id: 1 }, { ...lift, id: 2 });
    await touch(
      'touchMove',
      { x: tilt.x + 40, y: tilt.y, id: 0 },
      { x: push.x, y: push.y - 40, id: 1 },
      { x: lift.x, y: lift.y - 40, id: 2 },
    );
    await expect.poll(() => tiltOf(page)).toBeGreaterThan(2);
    const speed = () => page.locator('.td-reading-hspd .td-value').textContent();
    await expect.poll(speed).not.toMatch(/^0\.0/);
    await expect.poll(descent).toBeLessThan(fell - 0.3);
    const knobs = () => page.locator('.knob').evaluateAll((all) => all.map((knob) => knob.style.translate));
    expect((await knobs()).every((place) => place !== '' && !place.startsWith('0px 0px'))).toBe(true);
    await touch('touchEnd');
    await expect.poll(async () => (await knobs()).every((place) => /^0px( 0px)?$/.test(place))).toBe(true);

    const before = await throttleOf(page);
    const lever = await middleOf('.thumb-lever input');
    await touch('touchStart', { ...lever, id: 0 });
    await touch('touchMove', { x: lever.x + 30, y: lever.y, id: 0 });
    await touch('touchEnd');
    await expect.poll(() => throttleOf(page)).toBeGreaterThan(before + 10);
    expect(await page.textContent('.thumb-lever')).toMatch(/Engine \d+ %, hover \d+ %/);
    await page.getByRole('button', { name: 'Cut', exact: true }).tap();
    await expect.poll(() => throttleOf(page)).toBe(0);

    const isOn = () =>
      page.locator('.thumb-buttons button').evaluateAll((all) => all.map((one) => one.ariaPressed));
    await page.getByRole('button', { name: 'Upright', exact: true }).tap();
    await expect.poll(isOn).toEqual([null, 'true', 'true', 'false']);
    await page.getByRole('button', { name: 'Auto', exact: true }).tap();
    await expect.poll(isOn).toEqual([null, 'true', 'false', 'true']);

    const hud = await middleOf('.td-landing');
    await touch('touchStart', { ...hud, id: 0 });
    for (let n = 1; n <= 6; n++) await touch('touchMove', { x: hud.x, y: hud.y - 40 * n, id: 0 });
    await touch('touchEnd');
    await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(50);
    expect(problemsOf(page)).toEqual([]);
  });
});
