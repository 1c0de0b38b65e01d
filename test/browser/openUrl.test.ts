import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { describeInBrowser, openUrl } from './pages';

describeInBrowser('a page', () => {
  let inside: Page | undefined;

  describe('opened before the first tests of a file', () => {
    let page: Page;
    beforeAll(async () => {
      page = await openUrl('about:blank');
    });

    it('is there for them, as is one that a test opens itself', async () => {
      inside = await openUrl('about:blank');
      expect([page.isClosed(), inside.isClosed()]).toEqual([false, false]);
    });
  });

  describe('opened before later tests, when others have run', () => {
    let page: Page;
    beforeAll(async () => {
      page = await openUrl('about:blank');
    });

    it('is there for them, and the one of the test before is closed', () => {
      expect([page.isClosed(), inside?.isClosed()]).toEqual([false, true]);
    });

    it('stays for all of them', () => {
      expect(page.isClosed()).toBe(false);
    });
  });
});
