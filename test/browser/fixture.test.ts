/** Tests of the browser tests' environment: this browser draws, and the server's policy is enforced. */
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { describeInBrowser, openUrl, problemsOf } from './pages';
import { fileFor, serveFolder } from './staticServer';
import type { StaticServer } from './staticServer';

const INLINE_AND_OUTSIDE = `<!doctype html><title>policy</title><link rel="icon" href="icon.svg">
<canvas width="8" height="8"></canvas><script>window.inlineRan = true</script>
<script type="module" src="outside.js"></script>`;
const OUTSIDE = `window.outsideRan = true;
try { window.evaluated = new Function('return 1')() } catch (error) { window.refused = error.name }`;
const ICON = '<svg xmlns="http://www.w3.org/2000/svg" width="1" height="1"/>';

describeInBrowser('the browser test fixture', () => {
  const folder = mkdtempSync(join(tmpdir(), 'touchdown-'));
  let server: StaticServer;
  beforeAll(async () => {
    writeFileSync(join(folder, 'index.html'), INLINE_AND_OUTSIDE);
    writeFileSync(join(folder, 'outside.js'), OUTSIDE);
    writeFileSync(join(folder, 'icon.svg'), ICON);
    server = await serveFolder(folder);
  });
  afterAll(async () => {
    await server.close();
    rmSync(folder, { recursive: true });
  });

  it('refuses inline scripts and code made from strings, and reports both', async () => {
    const page = await openUrl(server.url);
    const seen = await page.evaluate(() => {
      const { inlineRan, outsideRan, evaluated, refused } = window as unknown as Record<string, unknown>;
      return { inlineRan, outsideRan, evaluated, refused };
    });
    expect(seen).toEqual({
      inlineRan: undefined,
      outsideRan: true,
      evaluated: undefined,
      refused: 'EvalError',
    });
    expect(problemsOf(page).join('\n')).toMatch(/inline script violates.*Content Security Policy/);
  });

  it('draws with WebGL 2', async () => {
    const page = await openUrl(server.url);
    const pixel = await page.evaluate(() => {
      const gl = document.querySelector('canvas')?.getContext('webgl2');
      if (!gl) return null;
      gl.clearColor(0.2, 0.4, 0.6, 1);
      gl.clear(gl.COLOR_BUFFER_BIT);
      const rgba = new Uint8Array(4);
      gl.readPixels(3, 3, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
      return [...rgba];
    });
    expect(pixel).toEqual([51, 102, 153, 255]);
  });

  it('reports a failed request and an uncaught error', async () => {
    const page = await openUrl(server.url);
    await page.evaluate(async () => {
      setTimeout(() => {
        throw new Error('planted');
      });
      await fetch('nowhere.json');
    });
    await expect.poll(() => problemsOf(page).join('\n')).toMatch(/uncaught: planted/);
    expect(problemsOf(page).join('\n')).toMatch(/404/);
  });

  it('serves only its folder', () => {
    expect(fileFor(folder, '/games/touchdown/')).toBe(join(folder, 'index.html'));
    expect(fileFor(folder, '/games/touchdown/../../../../../../etc/passwd')).toBeNull();
    expect(fileFor(folder, '/index.html')).toBeNull();
  });
});
