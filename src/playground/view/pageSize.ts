/** Reports changes of the canvas or the pixel ratio: a window dragged to another screen is not resized, but would be blurred. */
export function watchSize(window: Window & typeof globalThis, canvas: Element, changed: () => void): void {
  new window.ResizeObserver(changed).observe(canvas);
  const watchRatio = () => {
    const media = window.matchMedia(`(resolution: ${window.devicePixelRatio}dppx)`);
    media.addEventListener(
      'change',
      () => {
        changed();
        watchRatio();
      },
      { once: true },
    );
  };
  watchRatio();
}

/** CSS pixels of width below which no picture is drawn coarser. */
const SHARP = 600;

/** Device pixels per CSS pixel. A coarser picture would not speed up a small canvas. */
export function pixelRatioOf(window: Window, width: number, share: number): number {
  return Math.min(window.devicePixelRatio, 2) * Math.max(share, Math.min(SHARP / width, 1));
}
