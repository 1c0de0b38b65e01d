import { describe, expect, it } from 'vitest';
import { createLandingReadout, landingReadout, type LandingReadout } from '../../src/readout';
import type { ShipView, WorldView } from '../../src/prediction';
import { later, makeShip, makeView, type Pose } from './views';

type Leg = readonly [seconds: number, pose: Pose, changes?: Partial<ShipView>];

/** Reads a way through poses, each held for its game seconds at 60 frames a second. */
function fly(legs: readonly Leg[], out = createLandingReadout()): LandingReadout {
  let view: WorldView | null = null;
  for (const [seconds, pose, changes] of legs) {
    const frames = Math.round(seconds * 60);
    for (let i = 0; i < frames; i++) {
      const ship = makeShip(pose, changes);
      view = view === null ? makeView(pose, changes) : later(view, 1 / 60, ship);
      landingReadout(view, out);
    }
  }
  return out;
}

const FALL: Leg = [0.5, { clearance: 1, up: -12.3, north: 4, east: 3, tilt: 6 }];
const TOUCH: Leg = [0.5, { state: 'contact', clearance: -0.5, up: -6, north: 3.6 }, { impactSpeed: 12.3 }];
const RISE: Leg = [0.1, { clearance: 0.1, up: 4, north: 3 }];
const HOP: Leg = [4, { clearance: 2, up: 0.5, north: 3 }];
const SLIDE: Leg = [2, { state: 'contact', clearance: -0.02, north: 3, tilt: 9 }, { impactSpeed: 4 }];
const REST: Leg = [1, { state: 'landed', clearance: -0.016, tilt: 1 }];

describe('the touchdown card', () => {
  it('tells speeds at the first touch, bounces, slide, time to rest and the largest tilt', () => {
    const { touchdown, touchdownShown } = fly([FALL, TOUCH, RISE, HOP, SLIDE, REST]);
    expect(touchdownShown).toBe(true);
    expect(touchdown).toMatchObject({ known: true, outcome: 'landed', bounces: 1 });
    expect(touchdown.verticalSpeed).toBe(12.3);
    expect(touchdown.horizontalSpeed).toBeCloseTo(5, 6);
    // 30 frames at 3.6 m/s and 120 at 3 m/s, the way between two of them counted; the frame of coming to rest at its mean.
    expect(touchdown.slideMetres).toBeCloseTo((29 * 3.6 + 119 * 3 + 1.5) / 60, 6);
    expect(touchdown.settleSeconds).toBeCloseTo(0.5 + 0.1 + 4 + 2, 1);
    expect(touchdown.largestTilt).toBeCloseTo(9, 6);
  });

  it('counts the tilt it came with', () => {
    const steep: Leg = [0.5, { clearance: 1, up: -5, tilt: 22 }];
    expect(fly([steep, TOUCH, REST]).touchdown.largestTilt).toBeCloseTo(22, 6);
  });

  it('is shown when landed or tipped, not while it goes on', () => {
    expect(fly([FALL, TOUCH]).touchdownShown).toBe(false);
    const tipped = fly([FALL, TOUCH, [1, { state: 'tipped', tilt: 88, clearance: -0.02 }]]);
    expect(tipped).toMatchObject({ touchdownShown: true, touchdown: { outcome: 'tipped' } });
    expect(tipped.touchdown.largestTilt).toBeCloseTo(88, 6);
  });

  it('stands still once the ship is at rest', () => {
    const out = fly([FALL, TOUCH, REST]);
    const settle = out.touchdown.settleSeconds;
    fly([[3, REST[1]]], out);
    expect(out.touchdown.settleSeconds).toBe(settle);
  });

  it('begins anew with the next approach, not with a long flight’s end', () => {
    const launch: Leg = [0.2, { clearance: 0.2, up: 2 }];
    const away: Leg = [20, { clearance: 80, up: 1 }];
    const down: Leg = [0.5, { clearance: 0.5, up: -2 }];
    const again: Leg = [0.5, { state: 'contact', clearance: -0.02 }, { impactSpeed: 2 }];
    const next = fly([FALL, TOUCH, RISE, HOP, SLIDE, REST, launch, away, down, again, REST]).touchdown;
    expect(next).toMatchObject({ verticalSpeed: 2, bounces: 0, outcome: 'landed' });
    // Without having landed in between: a climb on the engine is no bounce either.
    const climbed = fly([FALL, TOUCH, launch, away, down, again, REST]).touchdown;
    expect(climbed).toMatchObject({ verticalSpeed: 2, bounces: 0 });
  });

  it('forgets a touch that was predicted and taken back', () => {
    const stillFalling: Leg = [0.2, { clearance: 0.4, up: -12 }];
    const real: Leg = [0.5, { state: 'contact', clearance: -0.3 }, { impactSpeed: 12 }];
    const { touchdown } = fly([FALL, TOUCH, stillFalling, real, REST]);
    expect(touchdown).toMatchObject({ bounces: 0, verticalSpeed: 12 });
  });

  it('has nothing to tell of a ship met on the ground, or put there', () => {
    expect(fly([REST])).toMatchObject({ touchdownShown: false, touchdown: { known: false } });
    const out = fly([FALL, TOUCH, REST]);
    fly([[0.5, { ...REST[1] }, { shipId: 'ship-2' }]], out);
    expect(out.touchdownShown).toBe(false);
    const moved = fly([FALL, TOUCH, REST]);
    fly([[0.5, { ...REST[1], terrain: 900 }]], moved);
    expect(moved.touchdownShown).toBe(false);
  });

  it('tells a crash by the velocity that the law leaves', () => {
    const out = fly([
      FALL,
      [0.5, { clearance: -0.7, up: -63, east: 8 }, { crashed: true, shownState: 'crashed' }],
    ]);
    expect(out.touchdown).toMatchObject({ outcome: 'crashed' });
    expect(out.touchdown.verticalSpeed).toBeCloseTo(63, 6);
    expect(out.touchdown.horizontalSpeed).toBeCloseTo(8, 6);
  });

  it('stands still while the game is paused', () => {
    const out = createLandingReadout();
    fly([FALL, TOUCH], out);
    const before = { ...out.touchdown };
    const view = makeView(TOUCH[1], TOUCH[2]);
    landingReadout(view, out);
    const paused = out.touchdown.slideMetres;
    for (let i = 0; i < 100; i++) landingReadout(view, out);
    expect(out.touchdown.slideMetres).toBe(paused);
    expect(paused - before.slideMetres).toBeLessThan(1e-9);
  });
});
