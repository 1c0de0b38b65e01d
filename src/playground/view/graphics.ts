import { createSceneView, type Quality, type SceneView } from '../../scene';
import type { Notice } from '../panels/notice';

const CONTEXT_LOST =
  'The browser lost the 3D view. It returns by itself; if it does not, reload the page. Meanwhile, fly on instruments.';

/** Shows a message while the picture is lost; the renderer rebuilds itself. */
export function watchContext(canvas: HTMLCanvasElement, notice: Notice, restored: () => void): void {
  canvas.addEventListener('webglcontextlost', () => notice.show(CONTEXT_LOST));
  canvas.addEventListener('webglcontextrestored', () => {
    notice.withdraw(CONTEXT_LOST);
    restored();
  });
}

/** The scene, or null with a message if the browser has no WebGL. */
export function openSceneView(
  canvas: HTMLCanvasElement,
  quality: Quality,
  tell: (text: string) => void,
): SceneView | null {
  try {
    return createSceneView(canvas, quality);
  } catch {
    tell(
      'WebGL 2 is unavailable, so there is no picture: fly on instruments. ' +
        'To see the ship, turn on hardware acceleration or try another browser.',
    );
    return null;
  }
}
