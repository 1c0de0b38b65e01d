import { expect, it } from 'vitest';
import { createTurns } from '../../../src/playground/view/cockpit';

it('paints all displays in a slow frame, in fast ones each in every other, and none in a busy one', () => {
  const next = createTurns();
  expect([next(false, false), next(false, true), next(false, false)]).toEqual(['all', 'all', 'all']);
  const fast = [false, false, true, false, true, false].map((isBusy) => next(true, isBusy));
  expect(fast).toEqual(['flight', 'landing', 'none', 'flight', 'none', 'landing']);
});
