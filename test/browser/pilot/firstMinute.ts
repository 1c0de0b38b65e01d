/** The first minute of somebody who has never seen the page: real time, real frames. */
import { describe, expect, it } from 'vitest';
import { flyAsNewcomer } from './newcomer';
import { openBuiltPage, problemsOf } from '../pages';
import { type WINDOW_SIZES, windowOf } from '../windowSizes';

const TRIES = 2;
/** Fewer frames than a graphics card draws: what counts is that time is real. */
const FRAMES = { framesPerSecond: 6 };

/** Pixels across of the picture: enough for a pilot who reads the HUDs alone. */
const PIXELS = 400;

/** Tests in windows of some sizes: those by touch and those by keyboard are files of their own, which run side by side. */
export function testNewcomer(sizes: readonly (typeof WINDOW_SIZES)[number][]): void {
  describe.each(sizes)('a newcomer who follows the words on the screen at $width × $height', (size) => {
    it('lands by the beacon at less than 2 m/s within two tries', async () => {
      const { isTouch } = size;
      const page = await openBuiltPage('', { ...FRAMES, ...windowOf(size, PIXELS) });
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
}
