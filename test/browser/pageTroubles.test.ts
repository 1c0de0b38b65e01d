import { expect, inject, it } from 'vitest';
import { describeInBrowser, openBuiltPage, theBrowser } from './pages';
import { shadesOf, SMALL, untilBanner, untilStatus } from './waits';

describeInBrowser('the built page, when something is wrong', () => {
  it('says that it builds the ground until there is a picture', { timeout: 60_000 }, async () => {
    const context = await (await theBrowser()).newContext({ ...SMALL, locale: 'en-US' });
    const page = await context.newPage();
    // Everything the banner says, in order.
    await page.addInitScript(() => {
      const said: string[] = [];
      Object.assign(window, { said });
      document.addEventListener('DOMContentLoaded', () => {
        const banner = document.getElementById('banner')!;
        const note = () => said.push(banner.textContent);
        note();
        new MutationObserver(note).observe(banner, { childList: true, characterData: true, subtree: true });
      });
    });
    await page.goto(`${inject('builtPage')}?scenario=settle`);
    await untilStatus(page, 'landed');
    const said = await page.evaluate(() => (window as unknown as { said: string[] }).said);
    expect(said).toEqual(['Loading …', 'Building the ground …', '']);
    await context.close();
  });

  it('says what a link asks for that cannot be had', { timeout: 60_000 }, async () => {
    const page = await openBuiltPage('?scenario=settle&rate=9000&body=Vulcan', SMALL);
    await page.waitForSelector('#notice:not([hidden])', { timeout: 45_000 });
    const words = (await page.textContent('#notice')) ?? '';
    expect(words).toContain('rate: expected a number from 0.1 to 100');
    expect(words).toContain('body: expected one of Moon, Earth, Mars, Phobos');
  });

  it('says why a file is no recording and what one is', { timeout: 60_000 }, async () => {
    const page = await openBuiltPage('?scenario=settle', SMALL);
    await page.waitForSelector('html[data-ready=true]', { timeout: 45_000 });
    const file = {
      name: 'poem.jsonl',
      mimeType: 'text/plain',
      buffer: Buffer.from('<b>not</b> a recording\n'),
    };
    await page.setInputFiles('input[type=file]', file);
    await page.waitForSelector('#notice:not([hidden])', { timeout: 45_000 });
    expect(await page.textContent('#notice')).toContain('poem.jsonl cannot be played: line 1: not JSON');
  });

  it('says which server cannot be reached', { timeout: 60_000 }, async () => {
    const page = await openBuiltPage('?server=ws://127.0.0.1:9/', SMALL);
    await untilBanner(page, 'Connection lost');
    expect(await page.textContent('#banner')).toContain('ws://127.0.0.1:9/');
    expect(await page.textContent('#banner')).toContain('Is the server running? Tried again every 3 s');
  });

  it('says that its own server cannot be started, and what to do', { timeout: 60_000 }, async () => {
    const context = await (
      await theBrowser()
    ).newContext({ ...SMALL, locale: 'en-US', serviceWorkers: 'block' });
    await context.route(/worker-[\w-]+\.js$/, (route) => route.abort());
    const page = await context.newPage();
    await page.goto(`${inject('builtPage')}?scenario=settle`);
    await untilBanner(page, 'the server in the page failed');
    expect(await page.textContent('#banner')).toContain(
      'its program could not be fetched); load the page anew',
    );
    await context.close();
  });

  it('says that a part of it could not be fetched', { timeout: 60_000 }, async () => {
    const context = await (
      await theBrowser()
    ).newContext({ ...SMALL, locale: 'en-US', serviceWorkers: 'block' });
    await context.route(/page-[\w-]+\.js$/, (route) => route.abort());
    const page = await context.newPage();
    await page.goto(inject('builtPage'));
    await untilBanner(page, 'could not be fetched whole');
    await context.close();
  });

  it('says that the picture was taken away, and shows it again', { timeout: 120_000 }, async () => {
    const page = await openBuiltPage('?scenario=settle', SMALL);
    await untilStatus(page, 'landed');
    const before = await shadesOf(page);
    await page.evaluate(() => {
      const context = document.querySelector<HTMLCanvasElement>('#stage')!.getContext('webgl2')!;
      const loss = context.getExtension('WEBGL_lose_context')!;
      loss.loseContext();
      Object.assign(window, { giveBack: () => loss.restoreContext() });
    });
    await page.waitForSelector('#notice:not([hidden])', { timeout: 30_000 });
    expect(await page.textContent('#notice')).toContain('The browser has taken the picture away');
    expect(await shadesOf(page)).toBeLessThan(before / 3);
    // Hands and displays go on without it.
    await page.keyboard.press('z');
    await untilStatus(page, 'flight');
    await page.keyboard.press('x');
    await untilStatus(page, 'landed');
    await page.evaluate(() => (window as unknown as { giveBack: () => void }).giveBack());
    await page.waitForSelector('#notice', { state: 'hidden', timeout: 30_000 });
    await expect.poll(() => shadesOf(page), { timeout: 45_000 }).toBeGreaterThan(before / 2);
  });

  it('goes on by its displays where there is no WebGL', { timeout: 60_000 }, async () => {
    const context = await (await theBrowser()).newContext({ ...SMALL, locale: 'en-US' });
    const page = await context.newPage();
    await page.addInitScript(() => {
      HTMLCanvasElement.prototype.getContext = () => null;
    });
    await page.goto(`${inject('builtPage')}?scenario=settle`);
    await page.waitForSelector('#notice:not([hidden])', { timeout: 45_000 });
    expect(await page.textContent('#notice')).toContain('This browser gives no WebGL 2');
    await untilStatus(page, 'landed');
    await context.close();
  });
});
