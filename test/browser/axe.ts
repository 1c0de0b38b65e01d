/** The faults that axe finds on a page, in a real browser. */
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import type { AxeResults, RunOptions } from 'axe-core';
import type { Page } from 'playwright-core';

const AXE = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

interface AxeWindow {
  axe?: { run: (context: unknown, options: RunOptions) => Promise<AxeResults> };
}

/** The rules that depend on colours. */
export const OF_COLOUR = ['color-contrast', 'link-in-text-block'];

export interface AxeOptions {
  /** Selector of the part that is checked; the rules about documents are left out with it. The whole document by default. */
  readonly within?: string;
  /** The rules by which it is checked, all by default. */
  readonly rules?: readonly string[] | undefined;
}

/** One line per element: the rule and the place. Injected through the debugger, since a page's policy forbids foreign scripts. */
export async function axeFaults(page: Page, { within, rules }: AxeOptions = {}): Promise<string[]> {
  if (await page.evaluate(() => (window as unknown as AxeWindow).axe === undefined)) await page.evaluate(AXE);
  const options: RunOptions = { resultTypes: ['violations'], ...(rules && { runOnly: [...rules] }) };
  return page.evaluate(
    async ([part, how]) => {
      const { axe } = window as unknown as Required<AxeWindow>;
      const { violations } = await axe.run(part ?? document, how);
      return violations.flatMap(({ id, nodes }) => nodes.map((node) => `${id}: ${node.target.join(' ')}`));
    },
    [within, options] as const,
  );
}
