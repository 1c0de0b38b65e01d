/** What goes to the GPU: all that changed, and little else. */
import type { BufferAttribute, BufferGeometry, Object3D } from 'three';
import { expect, it } from 'vitest';
import { createDust } from '../../src/scene/effects/dust';
import { createFlame } from '../../src/scene/effects/flame';
import { createDetailTexture } from '../../src/scene/ground/detailTexture';
import { createPlumbLine } from '../../src/scene/overlays/plumbLine';

/** The GPU's copies of attributes, brought up to date as three does it. */
function createGpu() {
  const copies = new Map<BufferAttribute, { version: number; array: Float32Array }>();
  /** Numbers that one attribute sends at a draw. */
  const send = (attribute: BufferAttribute): number => {
    const { array, version, updateRanges } = attribute;
    const known = copies.get(attribute);
    if (known?.version === version) return 0;
    const copy = known?.array ?? Float32Array.from(array);
    copies.set(attribute, { version, array: copy });
    if (known === undefined) return array.length;
    const ranges = updateRanges.length > 0 ? updateRanges : [{ start: 0, count: array.length }];
    let sent = 0;
    for (const { start, count } of ranges) {
      copy.set(array.subarray(start, start + count), start);
      sent += count;
    }
    attribute.clearUpdateRanges();
    return sent;
  };
  return {
    /** Numbers that a draw sends; fails if the GPU would draw anything else than the attributes have. */
    draw(part: Object3D): number {
      const { attributes } = (part as Object3D & { geometry: BufferGeometry }).geometry;
      const all = Object.values(attributes) as BufferAttribute[];
      const sent = all.map(send).reduce((sum, count) => sum + count, 0);
      for (const attribute of all) expect(copies.get(attribute)!.array).toEqual(attribute.array);
      return sent;
    },
  };
}

const LOOK = { seconds: 2, size: 0.5, opacity: 0.75 };
/** Position, velocity and span of a grain. */
const GRAIN = 10;
const GRAINS = 1500;

it('new grains of dust alone, once around and over the end of their ring', () => {
  const gpu = createGpu();
  const dust = createDust(createDetailTexture(4), createFlame().uniforms);
  const throwMany = (count: number) => {
    for (let n = 0; n < count; n++) dust.throwGrain([n, 1, 2], [3, n, 5], LOOK);
  };
  gpu.draw(dust.points);
  const sent = [3, 0, 700, 796, 2, 5].map((count, frame) => {
    dust.update(frame, 1.6, 700);
    throwMany(count);
    return gpu.draw(dust.points);
  });
  expect(sent).toEqual([3, 0, 700, 796, 2, 5].map((count) => count * GRAIN));
});

it('all dust that a new ground clears, and what is raised at once', () => {
  const gpu = createGpu();
  const dust = createDust(createDetailTexture(4), createFlame().uniforms);
  gpu.draw(dust.points);
  dust.throwGrain([1, 2, 3], [4, 5, 6], LOOK);
  gpu.draw(dust.points);
  dust.throwGrain([1, 2, 3], [4, 5, 6], LOOK);
  dust.clear();
  dust.throwGrain([1, 2, 3], [4, 5, 6], LOOK);
  expect(gpu.draw(dust.points)).toBeLessThanOrEqual(4 * GRAINS + 3 * GRAIN);
});

it('the end of the plumb line, and its ticks where they change', () => {
  const gpu = createGpu();
  const line = createPlumbLine();
  const mesh = line.group.children[0]!;
  const eye = new Float64Array(3);
  const sentAt = (height: number) => {
    line.place([0, height, 0], height, eye);
    return gpu.draw(mesh);
  };
  // three takes the first draw's attributes whole, and their ranges with the second.
  for (const height of [390, 391]) sentAt(height);
  expect([395, 399].map(sentAt)).toEqual([3, 3]);
  expect(sentAt(401)).toBeGreaterThan(400);
  expect(sentAt(402)).toBe(3);
});
