/**
 * Opens pages in the real browser for a test:
 *   describeInBrowser('…', () => { it('…', async () => { const page = await openBuiltPage('?scenario=settle'); … }) })
 * A page opened inside a test closes with the test, one opened in beforeAll with its file.
 */
import type { Browser, BrowserContext, Page } from 'playwright-core';
import { afterAll, describe, inject, onTestFailed, onTestFinished, TestRunner } from 'vitest';
import { connectToChromium } from './chromium';
import { leaveOutTriangles, refuseWebGL } from './webgl';

export interface PageOptions {
  /** Size of the window in CSS pixels; 1280 × 720 by default. */
  readonly viewport?: { readonly width: number; readonly height: number };
  /** 'light' by default. */
  readonly colorScheme?: 'light' | 'dark';
  readonly reducedMotion?: 'reduce' | 'no-preference';
  /** 'allow' by default. */
  readonly serviceWorkers?: 'allow' | 'block';
  /** Device pixels per CSS pixel; 1 by default. */
  readonly deviceScaleFactor?: number;
  /** Fingers in place of a mouse, as on a phone; a phone's window follows its document's viewport. */
  readonly hasTouch?: boolean;
  readonly isMobile?: boolean;
  /** Most frames per second that the page may draw, as on a slow display; no limit by default. */
  readonly framesPerSecond?: number;
  /** Whether the page's triangles are drawn, in software, which takes most of a test's time; true by default. */
  readonly drawn?: boolean;
  /** Whether the browser has WebGL; without it the page flies on instruments, and loads for half the work. True by default. */
  readonly hasWebGL?: boolean;
  /** Done to the page before its address is opened. */
  readonly prepare?: (page: Page) => Promise<unknown>;
}

/**
 * ms, for hangs only: less than a test's own limit, so that the error names what was waited for. A page with a change by test/mutants
 * often hangs.
 */
const HANG = process.env['TOUCHDOWN_MUTANT'] ? 30_000 : 120_000;

const browsers = inject('chromium');
/** The one for this test file: files that run at the same time are spread over all. */
const address = browsers[Number(process.env['VITEST_POOL_ID'] ?? 0) % Math.max(1, browsers.length)];
const problems = new WeakMap<Page, string[]>();
let browser: Promise<Browser> | undefined;

/** `describe`, skipped (and counted as such) on a machine without a Chromium. */
export const describeInBrowser = describe.skipIf(address === undefined);

/** A browser shared with other test files; what a file opens in it is its own, and goes with it. */
function theBrowser(): Promise<Browser> {
  if (address === undefined) throw new Error('there is no Chromium: put the test into describeInBrowser');
  browser ??= connectToChromium(address);
  return browser;
}

afterAll(async () => {
  await (await browser)?.close();
  browser = undefined;
});

/** Problems of the page so far: uncaught errors, console errors (policy violations too), failed requests. */
export function problemsOf(page: Page): readonly string[] {
  return problems.get(page) ?? [];
}

/** What three says where there is no WebGL, besides throwing; the page shows a notice. */
const NO_CONTEXT = 'THREE.WebGLRenderer: THREE.WebGLRenderer: Error creating WebGL context.';

function watchForProblems(page: Page, hasWebGL: boolean): void {
  const found: string[] = [];
  problems.set(page, found);
  page.on('pageerror', (error) => found.push(`uncaught: ${error.message}`));
  page.on('crash', () => found.push('the page crashed'));
  page.on('console', (message) => {
    if (message.type() !== 'error' || (!hasWebGL && message.text() === NO_CONTEXT)) return;
    found.push(`console: ${message.text()}`);
  });
  page.on('requestfailed', (request) => {
    found.push(`request: ${request.url()} ${request.failure()?.errorText ?? ''}`);
  });
}

// Set here, since on a machine without a language Chromium uses "en-US@posix", which Intl refuses.
const EVERYWHERE_THE_SAME = { locale: 'en-US', timezoneId: 'UTC' };

/** Closes the page after the running test, and shows its problems beside the test's failure. */
function endWithTest(page: Page): void {
  onTestFinished(() => page.context().close());
  onTestFailed(() => {
    for (const problem of problemsOf(page)) console.error(`${page.url()} ${problem}`);
  });
}

/** Limits the frame rate of its pages: most of a test's time goes into the software renderer's frames. */
async function limitFrames(context: BrowserContext, framesPerSecond: number): Promise<void> {
  await context.addInitScript((gap) => {
    const soon = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = (draw) => window.setTimeout(() => soon(draw), gap);
  }, 1000 / framesPerSecond);
}

/** Passes on which blocks a page reaches, for test/mutants. */
function reportProbe(path: string, block: number): void {
  (globalThis as { touchdownReport?: typeof reportProbe }).touchdownReport?.(path, block);
}

/** Opens any address; resolves when the page's load event has fired. */
export async function openUrl(url: string, options: PageOptions = {}): Promise<Page> {
  const { framesPerSecond, drawn = true, hasWebGL = true, prepare, ...given } = options;
  const usual = { viewport: { width: 1280, height: 720 }, colorScheme: 'light' as const };
  const running = await theBrowser();
  const context = await running.newContext({ ...usual, ...given, ...EVERYWHERE_THE_SAME });
  context.setDefaultTimeout(HANG);
  // Of the context: a second page that a test opens in it is spared the same work.
  if (process.env['TOUCHDOWN_PROBES']) await context.exposeFunction('touchdownReport', reportProbe);
  if (framesPerSecond !== undefined) await limitFrames(context, framesPerSecond);
  if (!hasWebGL) await context.addInitScript(refuseWebGL);
  else if (!drawn) await context.addInitScript(leaveOutTriangles);
  const page = await context.newPage();
  watchForProblems(page, hasWebGL);
  // Not the state of `expect`: in a later beforeAll that still names the test before.
  if (TestRunner.getCurrentTest() !== undefined) endWithTest(page);
  await prepare?.(page);
  await page.goto(url);
  return page;
}

/** Opens the built page under the strict content security policy. `query` is like "?scenario=settle&freeze=3". */
export function openBuiltPage(query = '', options: PageOptions = {}): Promise<Page> {
  return openUrl(inject('builtPage') + query, options);
}

/** Opens test/browser/pages/`name` (like "hud.html?state=tipped") from the development server: TypeScript runs as it is. */
export function openTestPage(name: string, options: PageOptions = {}): Promise<Page> {
  return openUrl(`${inject('devServer')}test/browser/pages/${name}`, options);
}
