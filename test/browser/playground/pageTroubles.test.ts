import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { describeInBrowser, openBuiltPage } from '../pages';
import type { PageOptions } from '../pages';
import { ON_INSTRUMENTS, shadesOf, SMALL, untilBanner, untilStatus } from '../waits';

/** The page's panels that are drawn: their outlines, too, are seen. */
function panelsOn(page: Page): Promise<string[]> {
  return page.evaluate(() =>
    ['hud', 'flight', 'dock', 'panel'].filter((id) => {
      const part = document.getElementById(id)!;
      return part.checkVisibility({ visibilityProperty: true }) && part.getBoundingClientRect().height > 0;
    }),
  );
}

/** Options of a page for which the matching files never arrive. */
function without(files: RegExp): PageOptions {
  const prepare = (page: Page) => page.context().route(files, (route) => route.abort());
  return { ...ON_INSTRUMENTS, prepare };
}

/** Keeps everything that the banner shows, in order; runs before the page's own scripts. */
function listen(): void {
  const said: string[] = [];
  Object.assign(window, { said });
  document.addEventListener('DOMContentLoaded', () => {
    const banner = document.getElementById('banner')!;
    const note = () => said.push(banner.textContent);
    note();
    new MutationObserver(note).observe(banner, { childList: true, characterData: true, subtree: true });
  });
}

describeInBrowser('the built page of a link with invalid values', () => {
  let page: Page;
  beforeAll(async () => {
    const prepare = (opened: Page) => opened.addInitScript(listen);
    page = await openBuiltPage('?scenario=settle&slow=4&rate=9000&body=Vulcan', { ...SMALL, prepare });
    await untilStatus(page, 'landed');
  });
  afterAll(() => page.context().close());

  it('reports that it builds the ground until there is a picture', async () => {
    const said = await page.evaluate(() => (window as unknown as { said: string[] }).said);
    expect(said).toEqual(['Loading …', 'Building the ground …', '']);
  });

  it('names the invalid values', async () => {
    await page.waitForSelector('#notice:not([hidden])');
    const words = (await page.textContent('#notice')) ?? '';
    expect(words).toContain('rate: expected a number from 0.1 to 100');
    expect(words).toContain('body: expected one of Luna, Earth, Mars, Phobos');
  });

  it('explains why a file is not a recording, and what a recording is', async () => {
    const file = {
      name: 'poem.jsonl',
      mimeType: 'text/plain',
      buffer: Buffer.from('<b>not</b> a recording\n'),
    };
    await page.setInputFiles('input[type=file]', file);
    await page.locator('#notice', { hasText: 'poem.jsonl cannot be played: line 1: not JSON' }).waitFor();
  });
});

describeInBrowser('the built page, when something is wrong', () => {
  it('names the server that cannot be reached', async () => {
    const page = await openBuiltPage('?server=ws://127.0.0.1:9/', ON_INSTRUMENTS);
    await untilBanner(page, 'Nothing answers at ws://127.0.0.1:9', 'Is the server running? Retrying in');
    // Displays without numbers are not shown, and what only the built-in server does looks disabled.
    expect(await panelsOn(page)).toEqual(['panel']);
    const opacityOf = (name: string) =>
      page
        .getByRole('button', { name, exact: true })
        .evaluate((button) => Number(getComputedStyle(button).opacity));
    expect([await opacityOf('Restart'), await opacityOf('Keys')]).toEqual([0.5, 1]);
  });

  it('reports that the built-in server cannot be started, and what to do', async () => {
    const page = await openBuiltPage('?scenario=settle', without(/worker-[\w-]+\.js$/));
    await untilBanner(
      page,
      'the built-in server failed',
      'its program could not be fetched); reload the page',
    );
  });

  it('reports that a part of it could not be fetched', async () => {
    const page = await openBuiltPage('', without(/page-[\w-]+\.js$/));
    await untilBanner(page, 'did not load');
    expect(await panelsOn(page)).toEqual([]);
  });

  it('reports that the picture was lost, and restores it', async () => {
    const page = await openBuiltPage('?scenario=settle&slow=4', {
      ...SMALL,
      drawn: true,
      framesPerSecond: 1,
    });
    await untilStatus(page, 'landed');
    const before = await shadesOf(page);
    await page.evaluate(() => {
      const context = document.querySelector<HTMLCanvasElement>('#scene-view')!.getContext('webgl2')!;
      const loss = context.getExtension('WEBGL_lose_context')!;
      loss.loseContext();
      Object.assign(window, { giveBack: () => loss.restoreContext() });
    });
    await page.waitForSelector('#notice:not([hidden])');
    expect(await page.textContent('#notice')).toContain('The browser lost the 3D view');
    expect(await shadesOf(page)).toBeLessThan(before / 3);
    // Controls and displays work without it. In slow motion: until a frame shows it, the ship flies at full thrust.
    await page.getByLabel('Speed').selectOption('0.25');
    await page.keyboard.press('z');
    await untilStatus(page, 'flight');
    await page.keyboard.press('x');
    await page.getByLabel('Speed').selectOption('4');
    await untilStatus(page, 'landed');
    await page.evaluate(() => (window as unknown as { giveBack: () => void }).giveBack());
    await page.waitForSelector('#notice', { state: 'hidden' });
    await expect.poll(() => shadesOf(page)).toBeGreaterThan(before / 2);
  });

  it('works with displays only, without WebGL', async () => {
    const blind = () => {
      HTMLCanvasElement.prototype.getContext = () => null;
    };
    const prepare = (page: Page) => page.addInitScript(blind);
    const page = await openBuiltPage('?scenario=settle&slow=4&rate=9000', { ...SMALL, prepare });
    await page.waitForSelector('#notice:not([hidden])');
    expect(await page.textContent('#notice')).toContain('WebGL 2 is unavailable');
    // One notice does not hide another.
    expect(await page.textContent('#notice')).toContain('rate: expected a number from 0.1 to 100');
    await untilStatus(page, 'landed');
  });
});
