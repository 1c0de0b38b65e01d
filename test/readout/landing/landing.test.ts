import { describe, expect, it } from 'vitest';
import { createLandingReadout, updateLandingReadout, type LandingReadout } from '../../../src/readout';
import type { ShipView } from '../../../src/prediction';
import { makeView, type Pose } from '../views';

const read = (pose: Pose, changes: Partial<ShipView> = {}): LandingReadout =>
  updateLandingReadout(createLandingReadout(), makeView(pose, changes));

/** G M / r² on the Moon's surface, from the body's data alone. */
const MOON_GRAVITY = (6.6743e-11 * 7.342e22) / 1737400 ** 2;
const LANDER = { h: 4.56, legRadius: 3.42 };

it('the readout names the ship, its body, its state and its provenance; without a ship it has none', () => {
  const view = makeView(
    { state: 'contact', body: 'Mars' },
    { name: 'Heron', provenance: 'predicted', age: 0.7, withdrawn: 'landed' },
  );
  const out = updateLandingReadout(createLandingReadout(), { ...view, timeScale: 4 });
  const how = { provenance: 'predicted', age: 0.7, withdrawn: 'landed', known: true, timeScale: 4 };
  expect(out).toMatchObject({ shipName: 'Heron', bodyName: 'Mars', status: 'contact', ...how });
  updateLandingReadout(out, { ...view, own: null, timeScale: 2 });
  const none = { provenance: 'stale', withdrawn: '', known: false, timeScale: 2 };
  expect(out).toMatchObject({ shipName: '', bodyName: '', status: 'none', ...none });
  expect(out.gates.shown || out.margin.shown || out.righting.shown || out.touchdownShown).toBe(false);
});

describe('descent data', () => {
  it('counts descending as positive and measures against the turning ground', () => {
    // Earth's ground moves at up to 465 m/s here, which must not show.
    const { descent } = read({ body: 'Earth', clearance: 500, up: -12.3, east: 3, north: -4 });
    expect(descent.verticalSpeed).toBeCloseTo(12.3, 6);
    expect(descent.horizontalSpeed).toBeCloseTo(5, 6);
    expect(read({ clearance: 500, up: 7 }).descent.verticalSpeed).toBeCloseTo(-7, 6);
  });

  it('gives the height of the lowest foot, not of the centre of mass, over terrain', () => {
    expect(read({ clearance: 321.5, terrain: -1200 }).descent.feetHeight).toBeCloseTo(321.5, 6);
    const tilted = read({ clearance: 100, tilt: 30, leanTo: 77 }).descent.feetHeight;
    const { h, legRadius } = LANDER;
    const lowest = h * Math.cos(Math.PI / 6) + legRadius * Math.sin(Math.PI / 6);
    expect(tilted).toBeCloseTo(100 + h - lowest, 6);
  });

  it('is 0 on the ground, however deep the contact penetrates', () => {
    for (const state of ['contact', 'landed', 'tipped'] as const) {
      expect(read({ clearance: -3.4, state }).descent.feetHeight).toBe(0);
    }
    // On its side the feet hang in the air, but the hull stands on the ground.
    expect(read({ tilt: 89, state: 'tipped' }).descent.feetHeight).toBe(0);
  });

  it('gives no height and no time to impact over terrain that is not loaded', () => {
    const { descent } = read({ clearance: 86, up: -12.3 }, { extrapolated: 'ground' });
    expect(descent.feetHeight).toBeNaN();
    expect(descent.timeToImpact).toBeNaN();
    expect(descent.verticalSpeed).toBeCloseTo(12.3, 6);
    expect(read({ state: 'landed' }, { extrapolated: 'ground' }).descent.feetHeight).toBe(0);
  });

  it('is shown below 50 km', () => {
    const shown = (feetHeight: number) => read({ clearance: 49_990 }, { feetHeight }).descent.shown;
    expect([49_999.9, 50_000].map(shown)).toEqual([true, false]);
  });
});

describe('time to impact', () => {
  /** Runs the fall in small steps instead of solving it. */
  function fall(height: number, speed: number, acceleration: number): number {
    let [y, v, t] = [height, speed, 0];
    const dt = 1e-4;
    for (; y > 0 && t < 1000; t += dt) {
      v += acceleration * dt;
      y -= v * dt;
    }
    return t;
  }

  it('is the fall under gravity alone', () => {
    const { timeToImpact } = read({ clearance: 86, up: -12.3 }).descent;
    expect(timeToImpact).toBeCloseTo(fall(86, 12.3, MOON_GRAVITY), 2);
  });

  it('includes the present thrust', () => {
    const mass = 8000 + 4000;
    const half = read({ clearance: 86, up: -12.3, lift: 0.5 * mass * MOON_GRAVITY }).descent;
    expect(half.timeToImpact).toBeCloseTo(fall(86, 12.3, MOON_GRAVITY / 2), 2);
    // 12.3² / (2 · 86) = 0.88 m/s² up stops it just before the ground.
    const stops = read({ clearance: 86, up: -12.3, lift: mass * (MOON_GRAVITY + 0.9) }).descent;
    expect(stops.timeToImpact).toBeNaN();
    const gravityThere = MOON_GRAVITY * (1737400 / (1737400 + 4.56 + 86)) ** 2;
    const hovering = read({ clearance: 86, up: -2, lift: mass * gravityThere }).descent;
    expect(hovering.timeToImpact).toBeCloseTo(43, 2);
  });

  it('includes the centrifugal effect of ground speed', () => {
    const orbital = Math.sqrt(MOON_GRAVITY * 1737400);
    // The turning body adds or removes 4 m/s: less than a hundredth of the time.
    const fast = read({ clearance: 1000, up: -1, north: 0.9 * orbital }).descent;
    expect(fast.timeToImpact / fall(1000, 1, (1 - 0.81) * MOON_GRAVITY)).toBeCloseTo(1, 1);
    expect(read({ clearance: 1000, up: -1, north: 1.1 * orbital }).descent.timeToImpact).toBeNaN();
    // Straight down, however fast, there is none. Gravity at the start holds all the way.
    const gravity = MOON_GRAVITY * (1737400 / (1737400 + 4.56 + 40_000)) ** 2;
    const steep = read({ clearance: 40_000, up: -1500 }).descent;
    expect(steep.timeToImpact).toBeCloseTo(fall(40_000, 1500, gravity), 2);
  });

  it('is unknown when ascending or on the ground', () => {
    expect(read({ clearance: 86, up: 0.1 }).descent.timeToImpact).toBeNaN();
    expect(read({ clearance: 86, up: 0 }).descent.timeToImpact).toBeNaN();
    expect(read({ clearance: -0.1, up: -1, state: 'contact' }).descent.timeToImpact).toBeNaN();
  });
});

describe('tilt', () => {
  it('is precise at 0, 90 and 180°, where acos is not', () => {
    for (const tilt of [0, 1e-6, 5, 36.87, 80, 89.999999, 90, 179.999999]) {
      expect(read({ tilt, leanTo: 200, clearance: 10 }).tilt.degrees).toBeCloseTo(tilt, 7);
    }
  });

  it('marks settle, arctan(leg_radius / h) and tipped', () => {
    const { tilt } = read({ settings: { contactSettleTiltDeg: 4, contactTippedAngleDeg: 75 } });
    expect(tilt.settle).toBe(4);
    expect(tilt.tipped).toBe(75);
    expect(tilt.noReturn).toBeCloseTo((Math.atan(LANDER.legRadius / LANDER.h) * 180) / Math.PI, 10);
  });

  it('has a trend: growing, shrinking or steady', () => {
    expect(read({ tilt: 20, tiltRate: 0.05, leanTo: 130 }).tilt.trend).toBe(1);
    expect(read({ tilt: 20, tiltRate: -0.05, leanTo: 130 }).tilt.trend).toBe(-1);
    expect(read({ tilt: 20, tiltRate: 0.005, leanTo: 130 }).tilt.trend).toBe(0);
    // A ship that turns with the planet is at rest.
    expect(read({ body: 'Earth', tilt: 20 }).tilt.trend).toBe(0);
  });

  it('points to the ship’s lowest side, in its own axes', () => {
    for (const [heading, leanTo] of [
      [0, 40],
      [70, 200],
      [-30, 310],
    ] as const) {
      const level = makeView({ clearance: 10, heading });
      const leaning = makeView({ clearance: 10, heading, tilt: 25, leanTo });
      const { leanX, leanY } = updateLandingReadout(createLandingReadout(), leaning).tilt;
      // The drift towards its lean, in the axes of an upright ship with the same heading.
      const azimuth = (leanTo * Math.PI) / 180;
      const drifting = makeView({
        clearance: 10,
        heading,
        east: Math.sin(azimuth),
        north: Math.cos(azimuth),
      });
      const { drift } = updateLandingReadout(createLandingReadout(), drifting);
      expect(leanX).toBeCloseTo(drift.x, 9);
      expect(leanY).toBeCloseTo(drift.y, 9);
      expect(updateLandingReadout(createLandingReadout(), level).tilt).toMatchObject({ leanX: 0, leanY: 0 });
    }
  });

  it('is the largest number in contact and tipped only', () => {
    for (const [state, prominent] of [
      ['', false],
      ['contact', true],
      ['landed', false],
      ['tipped', true],
    ] as const) {
      expect(read({ state }).tilt.prominent).toBe(prominent);
    }
  });
});

describe('cross-pointer', () => {
  it('keeps the size and side of the drift at any tilt', () => {
    for (const tilt of [0, 20, 89, 120]) {
      // A lean across the drift turns the ship about the drift, so its axis along the drift stays.
      const { drift } = read({ tilt, leanTo: 0, north: 7, clearance: 50 });
      expect(Math.hypot(drift.x, drift.y)).toBeCloseTo(7, 8);
      const upright = read({ tilt: 0, north: 7, clearance: 50 }).drift;
      expect(drift.x).toBeCloseTo(upright.x, 8);
      expect(drift.y).toBeCloseTo(upright.y, 8);
    }
  });

  it('turns with the ship’s heading', () => {
    const before = read({ north: 5, east: 2 }).drift;
    const after = read({ north: 5, east: 2, heading: 90 }).drift;
    // The ship's X now points where its Y did.
    expect(after.x).toBeCloseTo(before.y, 9);
    expect(after.y).toBeCloseTo(-before.x, 9);
  });

  it('selects its range, up at once and down after a delay', () => {
    const out = createLandingReadout();
    const scaleAt = (north: number) => updateLandingReadout(out, makeView({ north })).drift.scale;
    expect([0.4, 1.5, 4, 9, 41].map(scaleAt)).toEqual([1, 2, 5, 10, 50]);
    expect([17, 15, 5, 4.1, 3.9].map(scaleAt)).toEqual([50, 20, 10, 10, 5]);
    const scales = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000];
    expect([0.1, ...scales.map((scale) => 0.999 * scale)].map(scaleAt).slice(1)).toEqual(scales);
    expect(scaleAt(20_000)).toBe(10_000);
    const smaller = scales.map((scale) => 0.79 * scale).reverse();
    expect(smaller.map(scaleAt)).toEqual([...scales].reverse());
  });
});
