import { createStage, type Quality, type Stage } from '../../scene';
import type { Notice } from '../panels/notice';

const CONTEXT_LOST =
  'The browser has taken the picture away: its graphics were reset, or too many pages draw. The flight goes on by the ' +
  'displays, and the picture comes back as soon as the browser gives it back. If it does not, load the page anew.';

/** Says when the picture is lost, and no longer when it is back: the renderer builds itself anew. */
export function watchContext(canvas: HTMLCanvasElement, notice: Notice, restored: () => void): void {
  canvas.addEventListener('webglcontextlost', () => notice.tell(CONTEXT_LOST));
  canvas.addEventListener('webglcontextrestored', () => {
    notice.withdraw(CONTEXT_LOST);
    restored();
  });
}

/** The picture, or null and a word about it where the browser gives none. */
export function openStage(
  canvas: HTMLCanvasElement,
  quality: Quality,
  tell: (text: string) => void,
): Stage | null {
  try {
    return createStage(canvas, quality);
  } catch {
    tell(
      'This browser gives no WebGL 2, so there is no picture. Everything else works: fly by the displays. ' +
        'To see the ship, allow hardware acceleration in the settings or try another browser.',
    );
    return null;
  }
}
