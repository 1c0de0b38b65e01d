/** Where stones lie, and which of them are drawn. */
import { Matrix4, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { BODIES, flatTerrain } from '../../../src/dynamics';
import { createCone, type ViewCone } from '../../../src/scene/camera/viewCone';
import { cellNoise } from '../../../src/scene/ground/noise';
import { createRocks, type Rocks } from '../../../src/scene/ground/rocks';
import { createLocalFrame } from '../../../src/scene/localFrame';
import { lookOf } from '../../../src/scene/sky/bodyLook';

const LUNA = BODIES.find(({ name }) => name === 'Luna')!;
const FRAME = createLocalFrame(LUNA, [0.3, 0.5, 0.8], { elevation: 15, azimuth: 60 });
const NO_SHADOW = () => -Infinity;
/** A cone with everything in sight, and one with only what has a larger x than `x`. */
const WHOLE = createCone();
const beyond = (x: number): ViewCone => ({ x, z: 0, whole: false, inward: Float64Array.of(1, 0, 1, 0) });

function layRocks(shadowY: (x: number, z: number) => number = NO_SHADOW, stoniness = 1): Rocks {
  const rocks = createRocks();
  rocks.setGround(FRAME, flatTerrain);
  rocks.paint({ ...lookOf('Luna'), stoniness });
  rocks.follow(0, 0, shadowY);
  return rocks;
}

/** The stones drawn by an eye, local. */
function stonesOf({ mesh }: Rocks, eye: Float64Array) {
  return Array.from({ length: mesh.count }, (_, n) => {
    const matrix = new Matrix4();
    mesh.getMatrixAt(n, matrix);
    const at = new Vector3().setFromMatrixPosition(matrix).add(mesh.position);
    const [wide, high, long] = new Vector3().setFromMatrixScale(matrix);
    return { x: at.x + eye[0]!, y: at.y + eye[1]!, z: at.z + eye[2]!, wide: wide!, high: high!, long: long! };
  });
}

function seen(rocks: Rocks, cone = WHOLE, eye = new Float64Array(3)) {
  rocks.place(eye, cone);
  return stonesOf(rocks, eye);
}

/** Three in ten of two places in each of 23 × 23 cells of 5 m. */
function countOf(stoniness: number): number {
  let count = 0;
  for (let k = -11; k <= 11; k++)
    for (let i = -11; i <= 11; i++)
      for (const seed of [31, 38]) if (cellNoise(i, k, seed) <= 0.3 * stoniness) count++;
  return count;
}

describe('stones', () => {
  it('are as many as the body has, knee-high at most, half sunk into the ground', () => {
    const stones = seen(layRocks());
    expect(stones).toHaveLength(countOf(1));
    expect(seen(layRocks(NO_SHADOW, 1.6))).toHaveLength(countOf(1.6));
    for (const { x, y, z, wide, high, long } of stones) {
      expect(Math.max(Math.abs(x), Math.abs(z))).toBeLessThan(60.001);
      expect(wide).toBeGreaterThan(0.0499);
      expect(wide).toBeLessThan(0.35);
      expect(high / wide).toBeGreaterThan(0.5499);
      expect(high / wide).toBeLessThan(0.9501);
      expect(long / wide).toBeCloseTo(0.85, 4);
      // Level ground falls away as the body does: d² / 2 R.
      expect(y).toBeCloseTo(0.15 * wide - (x * x + z * z) / (2 * LUNA.radius), 3);
    }
    // Most are small: a fourth power.
    const large = stones.filter(({ wide }) => wide > 0.05 + 0.3 * 0.5 ** 4).length / stones.length;
    expect(large).toBeGreaterThan(0.4);
    expect(large).toBeLessThan(0.6);
  });

  it('fill their cells evenly, to each side', () => {
    const stones = seen(layRocks());
    for (const axis of ['x', 'z'] as const) {
      const mean = stones.reduce((sum, stone) => sum + stone[axis], 0) / stones.length;
      // Cells begin at their number: from −55 m to 60 m.
      expect(Math.abs(mean - 2.5)).toBeLessThan(6);
      expect(Math.min(...stones.map((stone) => stone[axis]))).toBeLessThan(-50);
      expect(Math.max(...stones.map((stone) => stone[axis]))).toBeGreaterThan(55);
      const within = stones.map((stone) => stone[axis] / 5 - Math.floor(stone[axis] / 5));
      expect(within.reduce((sum, share) => sum + share, 0) / within.length).toBeCloseTo(0.5, 1);
    }
  });

  it('are left out where the ground is in the terrain’s shadow', () => {
    const stones = seen(layRocks((x) => (x > 0 ? 1 : -Infinity)));
    expect(stones.length).toBeGreaterThan(100);
    expect(stones.every(({ x }) => x <= 0)).toBe(true);
  });

  it('cast a shadow within 18 m of the ship', () => {
    const rocks = layRocks();
    const stones = seen(rocks);
    const { mesh } = rocks;
    const call = (hook: 'onBeforeShadow' | 'onAfterShadow') => (mesh[hook] as () => void).call(mesh);
    call('onBeforeShadow');
    const away = stones.map(({ x, z }) => Math.hypot(x, z));
    expect(mesh.count).toBe(away.filter((distance) => distance < 18).length);
    expect(away.slice(0, mesh.count).every((distance) => distance < 18)).toBe(true);
    call('onAfterShadow');
    expect(mesh.count).toBe(stones.length);
    seen(rocks, beyond(0));
    call('onBeforeShadow');
    const visible = stones.filter(({ x, z }) => x > -2 && Math.hypot(x, z) < 18);
    expect(mesh.count).toBe(visible.length);
  });

  it('are drawn where they are in sight, with 2 m to spare, chosen anew once the eye has moved a metre', () => {
    const rocks = layRocks();
    const all = seen(rocks);
    const inSight = (x: number) => all.filter((stone) => stone.x > x - 2).length;
    expect(seen(rocks, beyond(0))).toHaveLength(inSight(0));
    expect(rocks.mesh.instanceMatrix.updateRanges).toEqual([{ start: 0, count: 16 * inSight(0) }]);
    expect(seen(rocks, beyond(0.99))).toHaveLength(inSight(0));
    expect(seen(rocks, beyond(1.01))).toHaveLength(inSight(1.01));
    expect(seen(rocks, WHOLE)).toHaveLength(all.length);
  });

  it('stay where they are while the ship moves less than two cells, and are then laid around it', () => {
    const rocks = layRocks();
    const before = seen(rocks);
    const eye = Float64Array.of(3, 8, -4);
    for (const [x, z] of [
      [7.4, 0],
      [-7.4, 7.4],
      [0, -7.4],
    ] as const) {
      rocks.follow(x, z, NO_SHADOW);
      const still = seen(rocks, WHOLE, eye);
      expect(still).toHaveLength(before.length);
      expect(still[0]!.x).toBeCloseTo(before[0]!.x, 4);
    }
    rocks.follow(7.6, 0, NO_SHADOW);
    const moved = seen(rocks, WHOLE, eye);
    const range = moved.map(({ x }) => x);
    expect(Math.min(...range)).toBeGreaterThan(-45.001);
    expect(Math.max(...range)).toBeGreaterThan(65);
    // A stone of the ground between stays in place.
    const known = before.filter(({ x, z }) => Math.hypot(x, z) < 30);
    for (const stone of known)
      expect(moved.some(({ x, z }) => Math.hypot(x - stone.x, z - stone.z) < 1e-3)).toBe(true);
    const count = moved.length;
    rocks.setGround(FRAME, flatTerrain);
    rocks.follow(7.6, 0, () => 1);
    expect([count > 0, seen(rocks, WHOLE, eye)]).toEqual([true, []]);
  });

  it('are not laid without ground', () => {
    const rocks = createRocks();
    rocks.follow(50, 50, NO_SHADOW);
    expect(seen(rocks)).toEqual([]);
  });
});
