/** The first minute of somebody who has never seen the page: real time, real frames, at the sizes of phone, laptop and wide screen. */
import { describe, expect, it } from 'vitest';
import { flyAsNewcomer } from './newcomer';
import { describeInBrowser, openBuiltPage, problemsOf } from '../pages';

const TRIES = 2;
/** Fewer frames than a graphics card draws: what counts is that time is real. */
const FRAMES = { framesPerSecond: 6 };

const SIZES = [
  { width: 320, height: 640, isTouch: true },
  { width: 390, height: 844, isTouch: true },
  { width: 1280, height: 720, isTouch: false },
  { width: 1920, height: 1080, isTouch: false },
  { width: 2560, height: 1440, isTouch: false },
];

describeInBrowser('a newcomer who follows the words on the screen', () => {
  describe.each(SIZES)('at $width × $height', ({ width, height, isTouch }) => {
    it('lands by the beacon, softer than 2 m/s, within two tries', async () => {
      const page = await openBuiltPage('', {
        ...FRAMES,
        viewport: { width, height },
        deviceScaleFactor: 400 / width,
        hasTouch: isTouch,
        isMobile: isTouch,
      });
      await page.waitForSelector('html[data-ready=true]');
      const said: string[] = [];
      for (let i = 0; i < TRIES; i++) {
        const { card, log } = await flyAsNewcomer(page, isTouch);
        said.push(card, ...log);
        if (/^Landed: \d+ of 1000/.test(card)) break;
        const again = page.getByRole('button', { name: /Try again/ });
        await (isTouch ? again.tap() : again.click());
        await page.waitForSelector('#card', { state: 'hidden' });
      }
      expect(
        said.filter((line) => /^Landed: \d+ of 1000/.test(line)),
        said.join('\n'),
      ).toHaveLength(1);
      expect(problemsOf(page)).toEqual([]);
    });
  });
});
