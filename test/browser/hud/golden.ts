/**
 * Compares a picture with the stored one. TOUCHDOWN_UPDATE_PICTURES=1 stores the new one instead; without a stored
 * picture, or with one of another size, the comparison fails. Differences are written to .vitest-attachments/.
 */
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import pixelmatch from 'pixelmatch';
import { PNG } from 'pngjs';

const GOLDEN = fileURLToPath(new URL('screenshots/', import.meta.url));
const DIFFERENCES = fileURLToPath(new URL('../../../.vitest-attachments/', import.meta.url));
/**
 * Share of pixels that may differ clearly. Measured: none between runs, nor between a machine with fonts and one
 * without; the rest is for other versions of the browser. The neighbouring state of a HUD differs by more (a test holds that).
 */
export const TOLERANCE = 0.0015;
/** Colour distance, 0 … 1, from which a pixel counts as different: at 0.2, yellow and salmon would be equal. */
const THRESHOLD = 0.1;

/** Share of pixels that differ; 1 for another size. */
export function difference(a: PNG, b: PNG, picture?: PNG): number {
  if (a.width !== b.width || a.height !== b.height) return 1;
  const { width, height } = a;
  return (
    pixelmatch(a.data, b.data, picture?.data, width, height, { threshold: THRESHOLD }) / (width * height)
  );
}

export function goldenPicture(name: string): PNG | null {
  const file = `${GOLDEN}${name}.png`;
  return existsSync(file) ? PNG.sync.read(readFileSync(file)) : null;
}

/** '' if the picture equals the stored one, otherwise what differs. */
export function compareWithGolden(name: string, bytes: Buffer): string {
  if (process.env['TOUCHDOWN_UPDATE_PICTURES']) {
    mkdirSync(GOLDEN, { recursive: true });
    writeFileSync(`${GOLDEN}${name}.png`, smallest(PNG.sync.read(bytes)));
    return '';
  }
  const now = PNG.sync.read(bytes);
  const before = goldenPicture(name);
  if (before === null) return `${name}: no golden picture (TOUCHDOWN_UPDATE_PICTURES=1 stores one)`;
  const marked = new PNG({ width: now.width, height: now.height });
  const share = difference(now, before, marked);
  if (share <= TOLERANCE) return '';
  mkdirSync(DIFFERENCES, { recursive: true });
  writeFileSync(`${DIFFERENCES}${name}.now.png`, PNG.sync.write(now));
  if (share < 1) writeFileSync(`${DIFFERENCES}${name}.differs.png`, PNG.sync.write(marked));
  const size = `${String(now.width)} × ${String(now.height)}, golden ${String(before.width)} × ${String(before.height)}`;
  return `${name}: ${(share * 100).toFixed(2)} % of pixels differ, at most ${String(TOLERANCE * 100)} % may (${size})`;
}

function smallest(picture: PNG): Buffer {
  return PNG.sync.write(picture, { colorType: 2, deflateLevel: 9, deflateStrategy: 0, filterType: 0 });
}
