import type { WorldView } from '../../prediction';
import type { SceneView } from '../../scene';
import { gameSeconds } from '../game/mission/missionTracker';
import type { Resolution } from './resolution';

/** The members of the page that a frame needs. */
export interface FrameContext {
  readonly sceneView: SceneView | null;
  /** The view to show now, and its page clock s; `milliseconds` of the frame. */
  readonly nextView: (milliseconds: number) => { readonly view: WorldView; readonly now: number };
  /** Shows everything but the picture; `isFast`: the frame before was less than SLOW_FRAME ago. */
  readonly paint: (view: WorldView, now: number, isFast: boolean) => void;
  /** The view for the scene, including a ghost ship. */
  readonly viewForScene: (view: WorldView) => WorldView;
  /** The first picture is drawn. */
  readonly opened: () => void;
  /** A world has been requested and has not arrived yet. */
  readonly isLoading: () => boolean;
  readonly resolution: Resolution | null;
  readonly fit: () => void;
}

export interface FrameLoop {
  readonly start: () => void;
  readonly resized: () => void;
  readonly isWarm: () => boolean;
}

/** ms */
const SLOW_FRAME = 25;

/** Draws in every animation frame. The first picture builds the ground and compiles its programs, a second or more. */
export function createFrameLoop(window: Window, root: HTMLElement, context: FrameContext): FrameLoop {
  const { sceneView } = context;
  const freezeAt = Number(new URLSearchParams(window.location.search).get('freeze') ?? NaN);
  let isWarm = false;
  let isBuilding = false;
  let isResized = false;
  let isMarked = false;
  let isFrozen = false;
  let before = NaN;

  function frame(milliseconds: number): void {
    if (!isFrozen) window.requestAnimationFrame(frame);
    const { view, now } = context.nextView(milliseconds);
    context.paint(view, now, milliseconds - before < SLOW_FRAME);
    before = milliseconds;
    // Before the picture: a canvas that changes size is blank until it is drawn again.
    // Frames in which nothing is drawn do not measure the machine.
    const isMeasured = view.ready && Number.isNaN(freezeAt);
    const hasChanged = isMeasured && (context.resolution?.measure(milliseconds / 1000) ?? false);
    if (hasChanged || isResized) {
      isResized = false;
      context.fit();
    }
    if (view.ready && (isWarm || !isBuilding)) sceneView?.draw(context.viewForScene(view), now);
    if (view.ready && !isWarm) {
      isBuilding = true;
      isWarm = sceneView === null || sceneView.hasDrawn();
      if (isWarm) context.opened();
      return;
    }
    if (!isMarked && view.ready && !context.isLoading()) markReady(view);
  }

  /** On the root element, for tests and screenshots. */
  function markReady(view: WorldView): void {
    const seconds = gameSeconds(view);
    isFrozen = seconds >= freezeAt;
    if (isFrozen) root.dataset['frozen'] = 'true';
    isMarked = Number.isNaN(freezeAt) || isFrozen;
    if (isMarked) root.dataset['ready'] = 'true';
  }

  return {
    start: () => window.requestAnimationFrame(frame),
    resized: () => (isResized = true),
    isWarm: () => isWarm,
  };
}
