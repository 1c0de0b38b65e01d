import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { describeInBrowser, openUrl } from '../pages';

describeInBrowser('a page', () => {
  let inside: Page | undefined;

  describe('a page opened before the first tests of a file', () => {
    let page: Page;
    beforeAll(async () => {
      page = await openUrl('about:blank');
    });

    it('is available to them, as is one that a test opens itself', async () => {
      inside = await openUrl('about:blank');
      expect([page.isClosed(), inside.isClosed()]).toEqual([false, false]);
    });
  });

  describe('a page opened before later tests, after others have run', () => {
    let page: Page;
    beforeAll(async () => {
      page = await openUrl('about:blank');
    });

    it('is available to them, and the previous test’s page is closed', () => {
      expect([page.isClosed(), inside?.isClosed()]).toEqual([false, true]);
    });

    it('stays open for all of them', () => {
      expect(page.isClosed()).toBe(false);
    });
  });
});
