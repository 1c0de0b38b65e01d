import { expect, it } from 'vitest';
import { quantities, SLOTS } from '../../src/dynamics/contact/quantities';

/** Slots shared by two entries, or out of range. */
function faultsOf(slots: typeof SLOTS, length: number): string[] {
  const owner = new Map<number, number>();
  const faults: string[] = [];
  for (const [slot, size] of slots)
    for (let at = slot; at < slot + size; at++) {
      if (at >= length) faults.push(`${at} is outside`);
      if (owner.has(at)) faults.push(`${at} belongs to ${String(owner.get(at))} and ${slot}`);
      owner.set(at, slot);
    }
  return faults;
}

it('no two quantities of a substep share a slot', () => {
  expect(faultsOf(SLOTS, quantities.length)).toEqual([]);
  expect(SLOTS.reduce((sum, [, size]) => sum + size, 0)).toBe(quantities.length);
});

it('detects slots that overlap', () => {
  expect(faultsOf([...SLOTS, [40, 2]], quantities.length)).toHaveLength(2);
});
