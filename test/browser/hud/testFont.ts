/** One font on every machine, for comparable pictures: Open Sans from the npm Chromium. */
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { brotliDecompressSync } from 'node:zlib';
import type { Page } from 'playwright-core';

const BLOCK = 512;

/** The file at `name` of a tar archive: a header block with name and octal size, then the contents in whole blocks. */
function fileOf(archive: Buffer, name: string): Buffer {
  for (let at = 0; at + BLOCK <= archive.length;) {
    const field = (from: number, length: number) =>
      archive
        .subarray(at + from, at + from + length)
        .toString('latin1')
        .split('\0')[0]!;
    const size = parseInt(field(124, 12), 8) || 0;
    if (field(0, 100) === name) return archive.subarray(at + BLOCK, at + BLOCK + size);
    at += BLOCK + Math.ceil(size / BLOCK) * BLOCK;
  }
  throw new Error(`no ${name} in the archive`);
}

/** Sets the page's HUDs in Open Sans. Arrows, which it lacks, still come from the machine. */
export async function useTestFont(page: Page): Promise<void> {
  const entry = createRequire(import.meta.url).resolve('@sparticuz/chromium');
  const packed = readFileSync(
    join(entry.slice(0, entry.lastIndexOf('@sparticuz')), '@sparticuz/chromium/bin/fonts.tar.br'),
  );
  const archive = brotliDecompressSync(packed);
  const faces = [
    ['100 500', 'OpenSans-Regular.ttf'],
    ['600 900', 'OpenSans-Bold.ttf'],
  ].map(
    ([weight, file]) => [weight!, fileOf(archive, `fonts/Open_Sans/${file!}`).toString('base64')] as const,
  );
  await page.addStyleTag({ content: `:root { --touchdown-font: 'Test Sans', sans-serif }` });
  await page.evaluate(async (given) => {
    for (const [weight, base64] of given) {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      document.fonts.add(await new FontFace('Test Sans', bytes, { weight }).load());
    }
  }, faces);
}
