import { expect, it } from 'vitest';
import { heapFigures } from '../../heapRun';

/**
 * Bytes. Target 0; a boxed double takes 16. The first case has few ships to divide by: what a frame takes besides them may differ by 50
 * bytes between two fleets.
 */
const BOUNDS = {
  'a display frame, per ship on the ground point by point': 8,
  'a display frame, per other ship': 0.5,
  'a server frame, per state': 0.5,
};

it('a ship in a display frame and a state in a server frame allocate nothing', () => {
  // Compilation in the background would end at another frame on a busy machine. What is inlined differs from run to run: with nothing
  // inlined, each double that a call takes or returns is boxed.
  const flags = ['--no-concurrent-recompilation', '--no-turbo-inlining'];
  const bytes = heapFigures('test/prediction/heap/heapOfFleet.ts', flags);
  expect(Object.keys(bytes)).toEqual(Object.keys(BOUNDS));
  for (const [of, bound] of Object.entries(BOUNDS)) expect(bytes[of], of).toBeLessThan(bound);
});
