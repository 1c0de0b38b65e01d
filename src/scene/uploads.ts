import type { BufferAttribute } from 'three';

/** Sends `count` items from `at` on to the GPU at the next draw, in one range with those sent before them if they follow these. */
export function uploadItems(attribute: BufferAttribute, at: number, count: number): void {
  const { itemSize, updateRanges } = attribute;
  const start = at * itemSize;
  const last = updateRanges.at(-1);
  if (last !== undefined && last.start + last.count === start) last.count += count * itemSize;
  else attribute.addUpdateRange(start, count * itemSize);
  attribute.needsUpdate = true;
}

/** Sends the first `count` items alone. */
export function uploadFirst(attribute: BufferAttribute, count: number): void {
  attribute.clearUpdateRanges();
  uploadItems(attribute, 0, count);
}
