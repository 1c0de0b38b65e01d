/** The faults that axe finds on a page, in a real browser. */
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import type { AxeResults, RunOptions } from 'axe-core';
import type { Page } from 'playwright-core';

const AXE = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

interface AxeWindow {
  axe?: { run: (context: unknown, options: RunOptions) => Promise<AxeResults> };
}

/** One line per element: the rule and the place. Injected through the debugger, since a page's policy forbids foreign scripts. */
export async function axeFaults(page: Page): Promise<string[]> {
  if (await page.evaluate(() => (window as unknown as AxeWindow).axe === undefined)) await page.evaluate(AXE);
  return page.evaluate(async () => {
    const { axe } = window as unknown as Required<AxeWindow>;
    const { violations } = await axe.run(document, { resultTypes: ['violations'] });
    return violations.flatMap(({ id, nodes }) => nodes.map((node) => `${id}: ${node.target.join(' ')}`));
  });
}
