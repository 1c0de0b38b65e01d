import { describe, expect, it } from 'vitest';
import { createLandingReadout, updateLandingReadout, type LandingReadout } from '../../../src/readout';
import type { ShipView } from '../../../src/prediction';
import { timeToTipped } from '../law';
import { later, makeShip, makeView, type Pose } from '../views';

const read = (pose: Pose, changes: Partial<ShipView> = {}): LandingReadout =>
  updateLandingReadout(createLandingReadout(), makeView(pose, changes));

const MOON_GRAVITY = (6.6743e-11 * 7.342e22) / (1737400 + 4.56) ** 2;
/** Depth of a ship at rest: g / 100. */
const SAG = -MOON_GRAVITY / 100;
const AT_REST: Pose = { state: 'contact', clearance: SAG };

describe('the four gates', () => {
  const met = ({ gates }: LandingReadout) => [
    gates.tilt.met,
    gates.spin.met,
    gates.vertical.met,
    gates.horizontal.met,
  ];

  it('are all met by a ship at rest, and shown in contact only', () => {
    expect(read(AT_REST).gates.shown).toBe(true);
    expect(met(read(AT_REST))).toEqual([true, true, true, true]);
    for (const state of ['', 'landed', 'tipped'] as const) expect(read({ state }).gates.shown).toBe(false);
  });

  it('open and close each by its own quantity, at its own limit', () => {
    expect(met(read({ ...AT_REST, tilt: 4.99 }))).toEqual([true, true, true, true]);
    expect(met(read({ ...AT_REST, tilt: 5.01 }))).toEqual([false, true, true, true]);
    expect(met(read({ ...AT_REST, yawRate: 0.0099 }))).toEqual([true, true, true, true]);
    expect(met(read({ ...AT_REST, yawRate: -0.0101 }))).toEqual([true, false, true, true]);
    expect(met(read({ ...AT_REST, up: -0.499 }))).toEqual([true, true, true, true]);
    expect(met(read({ ...AT_REST, up: 0.501 }))).toEqual([true, true, false, true]);
    expect(met(read({ ...AT_REST, east: 0.3, north: -0.39 }))).toEqual([true, true, true, true]);
    expect(met(read({ ...AT_REST, east: 0.3, north: -0.41 }))).toEqual([true, true, true, false]);
  });

  it('are met below the limit, not at it', () => {
    const pose = { ...AT_REST, yawRate: 0.004 };
    const { value } = read(pose).gates.spin;
    const gate = (limit: number) =>
      read({ ...pose, settings: { contactSettleAngularVel: limit } }).gates.spin;
    expect(gate(value)).toEqual({ value, limit: value, met: false });
    expect(gate(value + 1e-9).met).toBe(true);
  });

  it('count the legs’ stored energy as vertical speed', () => {
    // At the bottom of a bounce the radial speed is 0; 0.3 m below the sag the legs hold √(100 · 0.3²) = 3 m/s.
    const { vertical } = read({ ...AT_REST, clearance: SAG - 0.3 }).gates;
    expect(vertical.value).toBeCloseTo(3, 6);
    const moving = read({ ...AT_REST, clearance: SAG - 0.3, up: 4 }).gates.vertical;
    expect(moving.value).toBeCloseTo(5, 6);
    // Half the weight on the engine: half the sag.
    const mass = 8000 + 4000;
    const carried = read({ ...AT_REST, clearance: SAG / 2, lift: 0.5 * mass * MOON_GRAVITY }).gates.vertical;
    expect(carried.value).toBeCloseTo(0, 6);
  });

  it('measure spin against the turning ground', () => {
    expect(read({ ...AT_REST, body: 'Earth' }).gates.spin.value).toBeLessThan(1e-15);
    expect(read({ ...AT_REST, body: 'Earth', yawRate: 0.004 }).gates.spin.value).toBeCloseTo(0.004, 12);
  });

  it('take their limits from the server’s settings', () => {
    const settings = { contactSettleTiltDeg: 7, contactSettleAngularVel: 0.02, contactSettleLinearVel: 0.25 };
    const { gates } = read({ ...AT_REST, settings });
    expect([gates.tilt, gates.spin, gates.vertical, gates.horizontal].map((gate) => gate.limit)).toEqual([
      7, 0.02, 0.25, 0.25,
    ]);
  });
});

describe('the tip margin', () => {
  const noReturn = (Math.atan(0.75) * 180) / Math.PI;

  it('is what remains before the point of no return', () => {
    const { margin } = read({ ...AT_REST, tilt: 12 });
    expect(margin).toMatchObject({ shown: true, outlook: 'steady' });
    expect(margin.degrees).toBeCloseTo(noReturn - 12, 9);
  });

  it('runs no simulation for a ship at rest within its feet, nor in flight', () => {
    for (const pose of [
      { ...AT_REST, tilt: 12 },
      { clearance: 50, tilt: 60 },
    ]) {
      const out = createLandingReadout();
      for (let i = 0; i < 5; i++) updateLandingReadout(out, makeView(pose));
      expect(out.memory.ahead!.tipping.projection.elapsed).toBeNaN();
    }
  });

  /** Follows a toppling ship until the readout has an answer, then lets the law tip it. */
  function predictedAndTrue(pose: Pose): { predicted: number; truth: number } {
    const out = createLandingReadout();
    const view = makeView(pose);
    for (let i = 0; i < 40 && out.margin.outlook !== 'tips'; i++) updateLandingReadout(out, view);
    return { predicted: out.margin.timeToTipped, truth: timeToTipped(pose) };
  }

  it('past that point gives the time until the law tips the ship', () => {
    const pose: Pose = { ...AT_REST, tilt: 38, leanTo: 140 };
    const { predicted, truth } = predictedAndTrue(pose);
    expect(truth).toBeGreaterThan(1);
    expect(predicted).toBeCloseTo(truth, 2);
  });

  it('spends at most 200 substeps a view, and none once it has its answer', () => {
    const out = createLandingReadout();
    const view = makeView({ ...AT_REST, tilt: 38 });
    const { projection } = out.memory.ahead!.tipping;
    updateLandingReadout(out, view);
    // Substeps of 0.01 s.
    expect(projection.elapsed).toBeCloseTo(2, 9);
    for (let i = 0; i < 40; i++) updateLandingReadout(out, view);
    expect(out.margin).toMatchObject({ outlook: 'tips', timeToTipped: projection.elapsed });
    expect(projection.running).toBe(false);
  });

  it('counts down with game time', () => {
    const out = createLandingReadout();
    // The readout's clock has run for a while when the ship begins to topple.
    const upright = makeView({ ...AT_REST, tilt: 3 });
    updateLandingReadout(out, upright);
    let view = later(upright, 7, makeView({ ...AT_REST, tilt: 38 }).own);
    for (let i = 0; i < 40 && out.margin.outlook !== 'tips'; i++) updateLandingReadout(out, view);
    const before = out.margin.timeToTipped;
    expect(before).toBeCloseTo(timeToTipped({ ...AT_REST, tilt: 38 }), 2);
    view = later(view, 0.5, view.own);
    updateLandingReadout(out, view);
    expect(out.margin.timeToTipped).toBeCloseTo(before - 0.5, 6);
  });

  it('reports whether the attitude control holds the ship or is too weak', () => {
    for (const [shipClass, outlook] of [
      ['planetary_lander', 'holds'],
      ['cargo_hauler', 'tips'],
    ] as const) {
      const out = createLandingReadout();
      const view = makeView({ ...AT_REST, shipClass, tilt: 38 });
      view.own.controls = { ...view.own.controls, attitudeMode: 'radial' };
      for (let i = 0; i < 60; i++) updateLandingReadout(out, view);
      expect(out.margin.outlook).toBe(outlook);
    }
  });
});

describe('on a slope', () => {
  /** A slope in degrees that rises to the north, with the ship flush on it, leaning to the south. */
  function onSlope(degrees: number) {
    const angle = (degrees * Math.PI) / 180;
    const level = makeShip({ state: 'contact' });
    const tilted = makeShip({ state: 'contact', tilt: degrees, leanTo: 180 });
    const up = Array.from(level.position, (x: number) => x / Math.hypot(...level.position));
    const [x, y, z, w] = tilted.attitude as unknown as [number, number, number, number];
    const top = [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)];
    expect(top[0]! * up[0]! + top[1]! * up[1]! + top[2]! * up[2]!).toBeCloseTo(Math.cos(angle), 9);
    return updateLandingReadout(
      createLandingReadout(),
      makeView({ state: 'contact', tilt: degrees, leanTo: 180 }, { groundNormal: Float64Array.from(top) }),
    );
  }

  it('measures tilt from the ground and the point of no return from the vertical', () => {
    const { tilt, margin } = onSlope(20);
    expect(tilt.degrees).toBeCloseTo(0, 6);
    expect(tilt.noReturn).toBeCloseTo(36.87 - 20, 2);
    expect(margin.degrees).toBeCloseTo(36.87 - 20, 2);
  });

  it('reports sliding on 38.9° of 38.7°, and not on 38°', () => {
    const steep = onSlope(38.9).gates;
    expect(steep.onSlope).toBe(true);
    expect(steep.slope.limit).toBeCloseTo(38.66, 2);
    expect([steep.slope.met, steep.balance.met]).toEqual([false, false]);
    expect([steep.slope.value, steep.balance.value]).toEqual([
      expect.closeTo(38.9, 9),
      expect.closeTo(38.9, 9),
    ]);
    expect(steep.balance.limit).toBeCloseTo((Math.atan(0.75) * 180) / Math.PI, 9);
    const less = onSlope(38).gates;
    expect([less.slope.met, less.balance.met]).toEqual([true, false]);
    const safe = onSlope(30).gates;
    expect([safe.slope.met, safe.balance.met]).toEqual([true, true]);
    // A degree is level to a pilot.
    expect([0, 1, 1.01].map((degrees) => onSlope(degrees).gates.onSlope)).toEqual([false, false, true]);
  });
});
