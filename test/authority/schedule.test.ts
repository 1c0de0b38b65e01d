import { expect, it } from 'vitest';
import { createSchedule, endOfTick, passBoundary } from '../../src/authority/time/schedule';

it('keeps the due times of the last 128 tick boundaries, and extrapolates at the tick rate before and after', () => {
  const schedule = createSchedule(10);
  // Half a second apart, each a little later than that.
  for (let boundary = 10; boundary <= 200; boundary++) passBoundary(schedule, boundary, 0.51 * boundary);
  const ends = (...boundaries: number[]) => boundaries.map((end) => endOfTick(schedule, end - 1, 2));
  expect(ends(200, 199, 73)).toEqual([0.51 * 200, 0.51 * 199, 0.51 * 73]);
  expect(ends(201, 220, 72)).toEqual([102.5, 112, 38]);
});

it('extrapolates from its start while no boundary has been due', () => {
  const schedule = createSchedule(40);
  expect([39, 40, 49].map((tick) => endOfTick(schedule, tick, 10))).toEqual([0, 0.1, 1]);
});
