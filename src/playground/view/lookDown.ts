import type { WorldView } from '../../prediction';
import type { SceneView } from '../../scene';

/** High over its pad a ship is seen from above, so that the pad is in the picture; near the ground from the side. */
export interface LookDown {
  readonly begin: () => void;
  /** Once a frame; what the hand turns comes on top of it. */
  readonly follow: (view: WorldView) => void;
}

/** rad over the first view, and the height from which on, m. */
const HIGHEST = 1.15;
const FROM_HEIGHT = 60;
/** rad: smaller turns wait, so that the picture does not swim. */
const STEP = 0.02;

export function createLookDown(stage: SceneView | null): LookDown {
  let turned = 0;
  return {
    begin() {
      stage?.resetCamera();
      stage?.zoomCamera(1.4);
      turned = 0;
    },
    follow({ own }) {
      if (own === null) return;
      const share = Math.min(Math.max((own.feetHeight - 8) / FROM_HEIGHT, 0), 1);
      const wanted = HIGHEST * share;
      if (Math.abs(wanted - turned) < STEP && wanted !== 0) return;
      stage?.turnCamera(0, wanted - turned);
      turned = wanted;
    },
  };
}
