import { expect, it } from 'vitest';
import { createTurns } from '../../src/playground/view/cockpit';

it('paints all displays in a slow frame, and in fast ones each in every other', () => {
  const next = createTurns();
  expect([next(false), next(false), next(false)]).toEqual(['all', 'all', 'all']);
  const fast = [next(true), next(true), next(true), next(true)];
  expect(fast).toEqual(['landing', 'flight', 'landing', 'flight']);
});
