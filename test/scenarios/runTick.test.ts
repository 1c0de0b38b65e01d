import { describe, expect, it } from 'vitest';
import { NEUTRAL_CONTROLS } from '../../src/dynamics';
import { scheduleOf, type ScheduledInput } from '../../src/scenarios/runTick';

const input = (tick: number, substep: number, thrustLevel: number): ScheduledInput => ({
  ...{ tick, substep },
  controls: { ...NEUTRAL_CONTROLS, thrustLevel },
});

describe('scheduled inputs', () => {
  it('come into force once each, at their own substep', () => {
    const schedule = scheduleOf([input(0, 1, 0.1), input(1, 0, 0.2)]);
    const seen = [0, 1].flatMap((tick) => [0, 1, 2].map((s) => schedule(tick, s)?.thrustLevel ?? null));
    expect(seen).toEqual([null, 0.1, null, 0.2, null, null]);
  });

  it('of one substep, or of those before the first, leave the last of them in force', () => {
    const schedule = scheduleOf([input(0, 0, 0.1), input(0, 2, 0.2), input(3, 1, 0.3), input(3, 1, 0.4)]);
    expect(schedule(1, 0)?.thrustLevel).toBe(0.2);
    expect(schedule(3, 1)?.thrustLevel).toBe(0.4);
    expect(schedule(3, 2)).toBeNull();
  });
});
