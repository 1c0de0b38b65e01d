import { describe, expect, it } from 'vitest';
import { BODIES } from '../../../../src/dynamics';
import {
  createGameTimeMeter,
  measureGameTime,
} from '../../../../src/prediction/snapshots/tempo/gameTimeMeter';
import { STILL } from '../../faults/restingShip';

const MOVING = { ...BODIES[0]!, velocity: [0, 0, 30_000] } as const;
const at = (seconds: number) => [{ ...MOVING, position: [0, 0, 30_000 * seconds] as const }];
const flying = (seconds: number, more: Partial<typeof STILL> = {}) => [
  {
    ...STILL,
    landedBodyName: '',
    surfaceContactState: '',
    velocity: [0, 0, 1000] as const,
    position: [0, 2e6, 1000 * seconds] as const,
    ...more,
  },
];

/** The scale after frames of ticks 0, 1, … at 10 Hz, of which each is `perTick(tick)` game s after the one before. */
function scalesOf(
  frames: number,
  frameAt: (seconds: number) => object,
  { perTick, sent }: { readonly perTick: (tick: number) => number; readonly sent: number | null },
): (number | null)[] {
  const meter = createGameTimeMeter();
  let seconds = 0;
  return Array.from({ length: frames }, (_, tick) => {
    seconds += tick === 0 ? 0 : perTick(tick);
    return measureGameTime(meter, { tick, tickRate: 10, ships: [], bodies: [], ...frameAt(seconds) }, sent);
  });
}

describe('game time per tick', () => {
  it('stays as sent while the bodies move by it', () => {
    const scales = scalesOf(5, (s) => ({ bodies: at(s) }), { perTick: () => 0.1, sent: 1 });
    expect(scales).toEqual([null, null, null, null, null]);
  });

  it('is measured from the bodies once two frames agree that the sent value is wrong', () => {
    const scales = scalesOf(4, (s) => ({ bodies: at(s) }), { perTick: () => 0.2, sent: 1 });
    expect(scales.slice(0, 2)).toEqual([null, null]);
    expect(scales[2]).toBeCloseTo(2, 6);
  });

  it('is the median of the bodies: two of five that move by another clock do not matter', () => {
    const five = (s: number) =>
      [s / 4, s / 4, s, s, s].map((seconds, i) => ({ ...at(seconds)[0]!, name: `body-${String(i)}` }));
    const scales = scalesOf(4, (s) => ({ bodies: five(s) }), { perTick: () => 0.2, sent: 1 });
    expect(scales[2]).toBeCloseTo(2, 6);
  });

  it('is not measured from a single frame', () => {
    const perTick = (tick: number) => (tick === 2 ? 0.4 : 0.1);
    const scales = scalesOf(6, (s) => ({ bodies: at(s) }), { perTick, sent: 1 });
    expect(scales).toEqual([null, null, null, null, null, null]);
  });

  it('is taken from `gameTime` rather than from the bodies', () => {
    const scales = scalesOf(4, (s) => ({ gameTime: s, bodies: at(s * 3) }), { perTick: () => 0.5, sent: 1 });
    expect(scales[3]).toBeCloseTo(5, 6);
  });

  it('is measured from a coasting ship after three frames if neither is sent', () => {
    const scales = scalesOf(5, (s) => ({ ships: flying(s) }), { perTick: () => 1, sent: null });
    expect(scales.slice(0, 3)).toEqual([null, null, null]);
    expect(scales[3]).toBeCloseTo(10, 6);
  });

  it('is not measured by a ship with thrust, or on the ground', () => {
    for (const more of [{ thrustLevel: 0.2 }, { landedBodyName: 'Luna', surfaceContactState: 'landed' }]) {
      const scales = scalesOf(6, (s) => ({ ships: flying(s, more) }), { perTick: () => 1, sent: null });
      expect(scales.every((scale) => scale === null)).toBe(true);
    }
  });

  it('is measured by ships of 1 m/s or faster', () => {
    const scaleAt = (speed: number) => {
      const drifting = (s: number) => ({
        ships: flying(s, { velocity: [0, 0, speed], position: [0, 2e6, speed * s] }),
      });
      return scalesOf(4, drifting, { perTick: () => 1, sent: null })[3];
    };
    expect([scaleAt(0.99), scaleAt(1)]).toEqual([null, expect.closeTo(10, 6)]);
  });

  it('returns to the sent value once that fits', () => {
    const perTick = (tick: number) => (tick < 4 ? 0.2 : 0.1);
    const scales = scalesOf(8, (s) => ({ bodies: at(s) }), { perTick, sent: 1 });
    expect(scales[3]).toBeCloseTo(2, 6);
    expect(scales[4]).toBeNull();
  });
});
