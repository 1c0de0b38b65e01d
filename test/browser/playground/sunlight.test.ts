/** Hull and ground under a low sun, in pixels: no shadow acne, no black blotches, no streaks. */
import type { Page } from 'playwright-core';
import { beforeAll, expect, it } from 'vitest';
import { FINE } from '../../../src/scene/quality';
import { describeInBrowser, openTestPage } from '../pages';

interface SunlightWindow {
  readonly sunlight: {
    readonly size: number;
    readonly ball: (elevation: number) => { shaded: string; plain: string };
    readonly ground: (elevation: number, height: number, away: number, anisotropy: number) => string;
  };
}

/** The pixels' brightness, 0 … 255. */
const brightness = (picture: string): number[] => Array.from(picture, (pixel) => pixel.charCodeAt(0) / 3);

describeInBrowser('a low sun', () => {
  let page: Page;
  beforeAll(async () => {
    page = await openTestPage('sunlight.html');
    await page.waitForSelector('html[data-ready=true]', { state: 'attached' });
  });

  it.each([3, 10, 30])('%i° up: a hull throws no shadow on its own lit side', async (elevation) => {
    const taken = await page.evaluate(
      (degrees) => (window as unknown as SunlightWindow).sunlight.ball(degrees),
      elevation,
    );
    const [shaded, plain] = [brightness(taken.shaded), brightness(taken.plain)];
    // Of 0 … 96: the sun is most of such a pixel's light.
    const lit = [...plain.keys()].filter((i) => plain[i]! > 60);
    const darkened = lit.filter((i) => shaded[i]! < 0.85 * plain[i]!);
    expect(lit.length).toBeGreaterThan(20_000);
    expect(darkened.length / lit.length).toBeLessThan(0.001);
  });

  /** Flat ground from `height` m up. */
  const groundFrom = async (
    ...given: [elevation: number, height: number, away: number, anisotropy: number]
  ) =>
    brightness(
      await page.evaluate((all) => (window as unknown as SunlightWindow).sunlight.ground(...all), given),
    );

  it.each([3, 8])(
    '%i° up: the grain of level ground does not run together into black blotches',
    async (elevation) => {
      const pixels = await groundFrom(elevation, 20, 40, FINE.anisotropy);
      const median = [...pixels].sort((a, b) => a - b)[pixels.length / 2]!;
      expect(median).toBeGreaterThan(30);
      expect(pixels.filter((each) => each < 0.4 * median).length / pixels.length).toBeLessThan(0.01);
    },
  );

  it('keeps the grain of ground at 50 … 500 m, which is a smear of streaks with one sample per pixel', async () => {
    const size = await page.evaluate(() => (window as unknown as SunlightWindow).sunlight.size);
    /** Mean difference between neighbours of one column, over the rows below the horizon that show that range. */
    const contrast = async (anisotropy: number) => {
      const pixels = await groundFrom(17, 3, 300, anisotropy);
      const band = [...pixels.keys()].slice(70 * size, 120 * size);
      return band.reduce((sum, i) => sum + Math.abs(pixels[i]! - pixels[i - size]!), 0) / band.length;
    };
    expect(await contrast(FINE.anisotropy)).toBeGreaterThan(1.5 * (await contrast(1)));
  });
});
