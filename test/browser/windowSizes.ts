import type { PageOptions } from './pages';

/** px: phones, a laptop, and wide screens. */
export const WINDOW_SIZES = [
  { width: 320, height: 640, isTouch: true },
  { width: 390, height: 844, isTouch: true },
  { width: 1280, height: 720, isTouch: false },
  { width: 1920, height: 1080, isTouch: false },
  { width: 2560, height: 1440, isTouch: false },
];

/** A window of that size, whose picture is drawn with only `pixels` pixels across. */
export const windowOf = (
  { width, height, isTouch }: (typeof WINDOW_SIZES)[number],
  pixels: number,
): PageOptions => ({
  viewport: { width, height },
  deviceScaleFactor: pixels / width,
  hasTouch: isTouch,
  isMobile: isTouch,
});
