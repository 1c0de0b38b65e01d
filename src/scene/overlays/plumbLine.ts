import {
  BufferAttribute,
  BufferGeometry,
  DynamicDrawUsage,
  Group,
  LineBasicMaterial,
  LineSegments,
} from 'three';
import { uploadFirst, uploadItems } from '../uploads';

/**
 * Height cue of a flying ship: a line from its feet straight down to the ground, with a tick every 10 m (100 m far up) and a cross
 * at its end. It is drawn over the ground, so that a hill between eye and ship does not hide it.
 */
export interface PlumbLine {
  readonly group: Group;
  /** `foot`: local place under the ship's feet, m; `height`: of the feet above the ground, m. */
  place(foot: ArrayLike<number>, height: number, eye: Float64Array): void;
  dispose(): void;
}

/** No line below this height of the feet: the ship's shadow shows it, m. */
const LOWEST = 12;
/** From here on the ticks are 100 m apart, m. */
const HIGH = 400;
const MAX_TICKS = 40;
/** Half widths of a tick and of the cross on the ground, m. */
const TICK = 0.5;
const CROSS = 3;
/** Two points of three coordinates; the line itself and the cross come before the ticks, each tick is two segments. */
const SEGMENT = 6;
const FIRST_TICK = 3;

export function createPlumbLine(): PlumbLine {
  const points = new Float32Array((FIRST_TICK + 2 * MAX_TICKS) * SEGMENT);
  const position = new BufferAttribute(points, 3).setUsage(DynamicDrawUsage);
  const geometry = new BufferGeometry().setAttribute('position', position);
  const material = new LineBasicMaterial({
    color: 0xbfeaff,
    transparent: true,
    opacity: 0.55,
    depthTest: false,
    toneMapped: false,
  });
  const lines = new LineSegments(geometry, material);
  lines.frustumCulled = false;
  lines.renderOrder = 4;
  const group = new Group();
  group.add(lines);
  let step = NaN;

  return {
    group,
    place(foot, height, eye) {
      group.visible = height > LOWEST;
      if (!group.visible) return;
      const wanted = height > HIGH ? 100 : 10;
      if (wanted !== step) {
        writeTicks(points, wanted);
        uploadFirst(position, position.count);
      }
      step = wanted;
      // The upper end of the line: the only point that moves while the ship does.
      points[4] = height;
      uploadItems(position, 1, 1);
      const ticks = Math.min(Math.ceil(height / step) - 1, MAX_TICKS);
      geometry.setDrawRange(0, 2 * (FIRST_TICK + 2 * ticks));
      group.position.set(foot[0]! - eye[0]!, foot[1]! - height - eye[1]!, foot[2]! - eye[2]!);
    },
    dispose() {
      geometry.dispose();
      material.dispose();
    },
  };
}

/** The cross and the ticks, relative to the line's lower end. */
function writeTicks(points: Float32Array, step: number): void {
  const across = (segment: number, y: number, dx: number, dz: number) =>
    points.set([-dx, y, -dz, dx, y, dz], segment * SEGMENT);
  across(1, 0, CROSS, 0);
  across(2, 0, 0, CROSS);
  for (let n = 1; n <= MAX_TICKS; n++) {
    const half = TICK * (step / 10) * (n % 5 === 0 ? 2 : 1);
    across(FIRST_TICK + 2 * (n - 1), n * step, half, 0);
    across(FIRST_TICK + 2 * (n - 1) + 1, n * step, 0, half);
  }
}
