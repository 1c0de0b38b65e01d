import { expect, it } from 'vitest';
import { createPilot, takePing } from '../../src/authority/pilots/pilots';

it('a player’s pings are answered up to a hundred in each second', () => {
  const pilot = createPilot('ann');
  const answered = (now: number, count: number) =>
    Array.from({ length: count }, () => takePing(pilot, now)).filter((isAnswered) => isAnswered).length;
  expect([answered(5, 60), answered(5.5, 60), answered(5.999, 60)]).toEqual([60, 40, 0]);
  expect([answered(6, 101), answered(6.5, 1), answered(30, 1)]).toEqual([100, 0, 1]);
});
