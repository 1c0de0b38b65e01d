import { describe, expect, it } from 'vitest';
import { SLOTS, SURFACE_SLOTS } from '../../src/dynamics/quantities';

type Slots = readonly (readonly [slot: number, length: number])[];

/** "slot 3 of 2 reaches into slot 4" for each that does. */
function overlaps(slots: Slots): string[] {
  const sorted = [...slots].sort(([a], [b]) => a - b);
  return sorted.flatMap(([slot, length], i) => {
    const next = sorted[i + 1]?.[0] ?? Infinity;
    return slot + length > next ? [`slot ${slot} of ${length} reaches into slot ${next}`] : [];
  });
}

describe('the slots of the quantities', () => {
  it.each([
    ['of a ship', SLOTS],
    ['of its surface', SURFACE_SLOTS],
  ])('%s do not overlap', (_, slots) => {
    expect(slots.length).toBeGreaterThan(5);
    expect(overlaps(slots)).toEqual([]);
  });

  it('would be found to', () => {
    expect(
      overlaps([
        [4, 3],
        [0, 4],
        [6, 1],
      ]),
    ).toEqual(['slot 4 of 3 reaches into slot 6']);
  });
});
