import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { bundleScript } from '../engines/bundle.mjs';
import { PINNED_HASH } from '../engines/hash';
import { describeInBrowser, openUrl } from './pages';

describeInBrowser('the browser’s engine', () => {
  it('Chromium computes the pinned hash of all trajectories', async () => {
    const folder = mkdtempSync(join(tmpdir(), 'touchdown-'));
    try {
      const script = readFileSync(await bundleScript(folder), 'utf8');
      const page = await openUrl('about:blank');
      // Shells print with `print`; a browser's would open the print dialog.
      const text = await page.evaluate(
        `(() => { let text = ''; globalThis.print = (t) => { text = t; }; ${script}; return text; })()`,
      );
      const lines = String(text).split('\n');
      expect(lines.length).toBeGreaterThan(80);
      expect(lines.at(-1)).toBe(`all ${PINNED_HASH}`);
    } finally {
      rmSync(folder, { recursive: true });
    }
  });
});
