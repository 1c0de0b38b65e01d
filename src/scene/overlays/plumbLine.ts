import { BufferAttribute, BufferGeometry, Group, LineSegments, LineBasicMaterial } from 'three';

/**
 * How high a flying ship is, as one sees it: a line from its feet straight down to the ground, with a tick every 10 m (100 m far up)
 * and a cross where it ends. It is drawn over the ground, so that a hill between eye and ship does not hide it.
 */
export interface PlumbLine {
  readonly group: Group;
  /** `foot`: local place under the ship's feet, m; `height`: of the feet above the ground, m. */
  place(foot: ArrayLike<number>, height: number, eye: Float64Array): void;
  dispose(): void;
}

/** Below this height of the feet the ship and its shadow say it themselves, m. */
const LOWEST = 12;
/** From here on the ticks stand 100 m apart, m. */
const HIGH = 400;
const MAX_TICKS = 40;
/** Half widths of a tick and of the cross on the ground, m. */
const TICK = 0.5;
const CROSS = 3;

export function createPlumbLine(): PlumbLine {
  const points = new Float32Array((1 + 2 + 2 * MAX_TICKS) * 2 * 3);
  const position = new BufferAttribute(points, 3);
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
  let drawn = NaN;

  const layOut = (height: number) => {
    const step = height > HIGH ? 100 : 10;
    let at = 0;
    const segment = (y: number, dx: number, dy: number, dz: number) => {
      points.set([-dx, y - dy, -dz, dx, y + dy, dz], at);
      at += 6;
    };
    segment(height / 2, 0, height / 2, 0);
    segment(0, CROSS, 0, 0);
    segment(0, 0, 0, CROSS);
    for (let n = 1; n * step < height && n <= MAX_TICKS; n++) {
      const wide = TICK * (step / 10) * (n % 5 === 0 ? 2 : 1);
      segment(n * step, wide, 0, 0);
      segment(n * step, 0, 0, wide);
    }
    geometry.setDrawRange(0, at / 3);
    position.needsUpdate = true;
  };

  return {
    group,
    place(foot, height, eye) {
      group.visible = height > LOWEST;
      if (!group.visible) return;
      // Tenths of a metre are not seen on it.
      const rounded = Math.round(height * 10) / 10;
      if (rounded !== drawn) layOut(rounded);
      drawn = rounded;
      group.position.set(foot[0]! - eye[0]!, foot[1]! - height - eye[1]!, foot[2]! - eye[2]!);
    },
    dispose() {
      geometry.dispose();
      material.dispose();
    },
  };
}
