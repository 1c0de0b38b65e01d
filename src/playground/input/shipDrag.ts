import type { Vec3 } from '../../dynamics';
import type { SceneView } from '../../scene';

/** Moves the ship with the pointer: a drag in the picture is converted to metres at the ship's distance. */
export interface ShipDrag {
  readonly isOn: () => boolean;
  readonly toggle: () => boolean;
  readonly begin: () => void;
  /** CSS pixels to the right and down. */
  readonly move: (right: number, down: number) => void;
  readonly end: () => void;
}

/** ms between two commands; each is a respawn of the ship. */
const EVERY = 100;

/** @param put displaces the ship from where it was when the drag began, m, ICRF axes */
export function createShipDrag(scene: SceneView, put: (offset: Vec3, begins: boolean) => void): ShipDrag {
  const axes = new Float64Array(9);
  const offset: Vec3 & number[] = [0, 0, 0];
  let isOn = false;
  let isDragging = false;
  let sentAt = -Infinity;
  const send = (begins: boolean) => {
    sentAt = performance.now();
    put([offset[0], offset[1], offset[2]], begins);
  };
  return {
    isOn: () => isOn,
    toggle: () => (isOn = !isOn),
    begin() {
      isDragging = scene.screenAxes(axes);
      offset.fill(0);
      if (isDragging) send(true);
    },
    move(right, down) {
      if (!isDragging) return;
      const size = scene.pixelSize();
      for (let k = 0; k < 3; k++) offset[k] = offset[k]! + size * (right * axes[k]! - down * axes[6 + k]!);
      if (performance.now() - sentAt >= EVERY) send(false);
    },
    end() {
      if (isDragging) send(false);
      isDragging = false;
    },
  };
}
