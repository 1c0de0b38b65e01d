import { describe, expect, it } from 'vitest';
import { createArena, identity } from '../../../src/prediction/arena';
import { addTrack, createFleet } from '../../../src/prediction/simulation/track';
import { createRig } from '../rig';

/** Every array of doubles in a record and the records in it. */
function arraysIn(record: object): Float64Array[] {
  return Object.values(record).flatMap((value: unknown) => {
    if (value instanceof Float64Array) return [value];
    const isRecord = typeof value === 'object' && value !== null;
    return isRecord && !Object.isFrozen(value) ? arraysIn(value) : [];
  });
}

/** Expects the arrays to lie in one buffer, one beside the other, and to fill it. */
function expectOneBuffer(arrays: readonly Float64Array[]): void {
  const [first] = arrays;
  expect(new Set(arrays.map(({ buffer }) => buffer)).size).toBe(1);
  const sorted = [...arrays].sort((a, b) => a.byteOffset - b.byteOffset);
  let end = 0;
  for (const array of sorted) {
    expect(array.byteOffset).toBe(end);
    end += array.byteLength;
  }
  expect(end).toBe(first!.buffer.byteLength);
}

describe('an arena', () => {
  it('gives out arrays that do not overlap, and throws once it is used up', () => {
    const arena = createArena(7);
    const vector = arena(3).fill(2);
    expect([...identity(arena)]).toEqual([0, 0, 0, 1]);
    expect([...vector]).toEqual([2, 2, 2]);
    expect(() => arena(1)).toThrow(RangeError);
  });

  it('is filled by the arrays of a ship, of its history and of its view', () => {
    const { history, ...track } = addTrack(createFleet(), 'ship-1', 12);
    expectOneBuffer(arraysIn(history));
    expectOneBuffer(arraysIn(track));
    const rig = createRig({ scenario: 'opening' });
    rig.fly(1);
    const { shipClass, ...view } = rig.view().own!;
    expect(shipClass.name).not.toBe('');
    expectOneBuffer(arraysIn(view));
  });
});
