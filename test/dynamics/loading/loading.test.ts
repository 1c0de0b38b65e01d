import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  BODIES,
  GRAVITATIONAL_CONSTANT,
  loadBody,
  loadControls,
  loadSettings,
  loadShipClass,
  DEFAULT_SETTINGS,
  loadTiming,
  NEUTRAL_CONTROLS,
  readControls,
  SHIP_CLASSES,
  SHIP_STRIDE,
  type ShipClass,
  timingOfTick,
  writeControls,
} from '../../../src/dynamics';
import { LANDER, must } from '../provingGround';

describe('angle thresholds', () => {
  // Target: within 1e-15 of the cosine. Today 2.3e-16 of Math.cos, itself within 1.2e-16.
  it('load as cosines within 1e-15 of Math.cos from 0 to 90°', () => {
    for (let k = 1; k < 9000; k++) {
      const degrees = k / 100;
      const settle = must(loadSettings({ contactSettleTiltDeg: degrees, contactTippedAngleDeg: 89.9999 }));
      const tipped = must(loadSettings({ contactSettleTiltDeg: 1e-6, contactTippedAngleDeg: degrees }));
      const ideal = Math.cos((degrees * Math.PI) / 180);
      expect(Math.abs(settle.cosSettleTilt - ideal)).toBeLessThan(5e-16);
      expect(tipped.cosTippedAngle).toBe(settle.cosSettleTilt);
    }
  });

  it('are exact where the cosine is', () => {
    const { cosTippedAngle } = must(loadSettings({ contactTippedAngleDeg: 60 }));
    expect(Math.abs(cosTippedAngle - 0.5)).toBeLessThanOrEqual(Number.EPSILON / 2);
  });
});

describe('ship class constants', () => {
  function timesInverse({
    inertia,
    inverseInertia,
  }: {
    inertia: Float64Array;
    inverseInertia: Float64Array;
  }) {
    return Array.from({ length: 9 }, (_, at) => {
      const [row, column] = [Math.floor(at / 3), at % 3];
      let sum = 0;
      for (let k = 0; k < 3; k++) sum += inertia[3 * row + k]! * inverseInertia[3 * k + column]!;
      return sum;
    });
  }

  const SKEWED: ShipClass = {
    ...LANDER,
    inertiaTensor: [
      [10, 4, -3],
      [4, 8, 2],
      [-3, 2, 9],
    ],
  };

  // Target: the unit matrix. Today the worst element is off by 2.3e-16.
  it.each([LANDER, ...SHIP_CLASSES, SKEWED])('inertia times its inverse is one for %j', (shipClass) => {
    const product = timesInverse(must(loadShipClass(shipClass)));
    const one = [1, 0, 0, 0, 1, 0, 0, 0, 1];
    product.forEach((part, at) => expect(Math.abs(part - one[at]!)).toBeLessThan(1e-15));
  });

  it('give full mass and fuel flow by the rocket equation', () => {
    const loaded = must(loadShipClass(LANDER));
    expect(loaded.fullMass).toBe(16000);
    expect(loaded.mainEngineFlow * LANDER.mainEngineThrust).toBeCloseTo(60000 / (311 * 9.80665), 12);
    expect(loaded.rcsFlow).toBeCloseTo(1 / (280 * 9.80665), 15);
    expect(loaded.forcePerTorque).toBe(0.25);
  });

  it('are frozen once loaded', () => {
    expect(Object.isFrozen(must(loadShipClass(LANDER)))).toBe(true);
    expect(Object.isFrozen(must(loadSettings({})))).toBe(true);
    expect(Object.isFrozen(must(loadBody(BODIES[0]!)))).toBe(true);
  });
});

describe('a body’s gravity parameter', () => {
  // GM as measured by tracking, m³/s²: Moon 4.9028e12, Earth 3.986004e14, Mars 4.282837e13, Phobos 7.09e5.
  it.each([
    ['Luna', 4.9028e12],
    ['Earth', 3.986004e14],
    ['Mars', 4.282837e13],
    ['Phobos', 7.087e5],
  ])('of %s agrees with the tracked value within 0.5 %', (name, measured) => {
    const { gravityParameter, mass } = must(loadBody(BODIES.find((body) => body.name === name)!));
    expect(gravityParameter).toBe(GRAVITATIONAL_CONSTANT * mass);
    expect(Math.abs(gravityParameter / measured - 1)).toBeLessThan(0.005);
  });
});

describe('controls', () => {
  it('are clamped into range', () => {
    const loaded = must(
      loadControls({
        ...NEUTRAL_CONTROLS,
        thrustLevel: 7,
        translationInput: [-3, 0.25, 1.0001],
        rotationInput: [2, -2, 1e300],
      }),
    );
    expect(loaded.thrustLevel).toBe(1);
    expect(loaded.translationInput).toEqual([-1, 0.25, 1]);
    expect(loaded.rotationInput).toEqual([1, -1, 1]);
    expect(must(loadControls({ ...NEUTRAL_CONTROLS, thrustLevel: -0.1 })).thrustLevel).toBe(0);
  });

  it('normalise the target attitude', () => {
    const load = (targetAttitude: [number, number, number, number]) =>
      must(loadControls({ ...NEUTRAL_CONTROLS, targetAttitude })).targetAttitude;
    expect(load([3, 0, 4, 0])).toEqual([0.6, 0, 0.8, 0]);
    expect(Math.hypot(...load([0.1, -0.7, 0.3, 0.2]))).toBeCloseTo(1, 15);
  });

  it('load to the same bits a second time, so that a stored input replays to the same flight', () => {
    const any = fc.double({ min: -10, max: 10, noNaN: true });
    const target = fc.tuple(any, any, any, any).filter((q) => Math.hypot(...q) > 0.01);
    let moving = 0;
    fc.assert(
      fc.property(target, fc.tuple(any, any, any), any, (targetAttitude, stick, thrustLevel) => {
        const given = { thrustLevel, translationInput: stick, rotationInput: stick, targetAttitude };
        const once = must(loadControls({ ...NEUTRAL_CONTROLS, ...given }));
        expect(must(loadControls(once))).toEqual(once);
        const [x, y, z, w] = once.targetAttitude;
        if (Math.sqrt(x * x + y * y + z * z + w * w) !== 1) moving++;
      }),
      { seed: 20_260, numRuns: 500 },
    );
    // Quotients by their length are often an ulp off length 1: normalising those again would change them.
    expect(moving).toBeGreaterThan(20);
  });

  it('keep a target within 1e-12 of unit length to the bit, and normalise any other', () => {
    const load = (w: number) =>
      must(loadControls({ ...NEUTRAL_CONTROLS, targetAttitude: [0, 0, 0, w] })).targetAttitude[3];
    for (const off of [2 ** -52, -(2 ** -53), 9e-13, -9e-13]) expect(load(1 + off)).toBe(1 + off);
    for (const off of [1.1e-12, -1.1e-12, 1e-6, -0.5]) expect(load(1 + off)).toBe(1);
  });

  it('survive a round trip through a row', () => {
    const given = must(
      loadControls({
        thrustLevel: 0.3,
        translationInput: [0.1, -0.2, 0.3],
        rotationInput: [-1, 0, 0.5],
        attitudeHold: true,
        attitudeMode: 'antiradial',
        targetAttitude: [0, 0.6, 0, 0.8],
      }),
    );
    const rows = new Float64Array(2 * SHIP_STRIDE);
    writeControls(rows, SHIP_STRIDE, given);
    expect(readControls(rows, SHIP_STRIDE)).toEqual(given);
    expect(rows.subarray(0, SHIP_STRIDE).every((value) => value === 0)).toBe(true);
  });
});

describe('timing', () => {
  // substeps = max(1, ⌈tick_seconds · 100 − 1e-9⌉)
  it.each([
    [1, 1, 100],
    [20, 1, 5],
    [100, 1, 1],
    [100, 0.1, 1],
    [0.1, 100, 100_000],
    [0.1, 1, 1000],
    [30, 1, 4],
    [7, 1, 15],
    [60, 1, 2],
    [3, 1, 34],
    [1, 0.1, 10],
    [100, 100, 100],
    [33, 2.5, 8],
  ])('at %d Hz and scale %d has %d substeps', (tickRate, timeScale, substeps) => {
    const timing = must(loadTiming(tickRate, timeScale, DEFAULT_SETTINGS));
    expect(timing.tickSeconds).toBe(timeScale / tickRate);
    expect(timing.substeps).toBe(substeps);
    expect(timing.dt).toBe(timing.tickSeconds / substeps);
  });

  it('uses the fewest whole substeps of at most 10 ms, at any rate', () => {
    for (let rate = 0.1; rate <= 100; rate += 0.37) {
      for (const scale of [0.1, 0.7, 1, 3, 17, 100]) {
        const { substeps, dt, tickSeconds } = must(loadTiming(rate, scale, DEFAULT_SETTINGS));
        expect(Number.isInteger(substeps) && substeps >= 1).toBe(true);
        expect(dt).toBeLessThanOrEqual(0.01 * (1 + 1e-9));
        expect(Math.abs(dt * substeps - tickSeconds)).toBeLessThan(1e-12 * tickSeconds);
        if (substeps > 1) expect(tickSeconds / (substeps - 1)).toBeGreaterThan(0.01);
      }
    }
  });

  it('adds no substep for a rounding error of the tick', () => {
    expect(timingOfTick(0.07, 0.01).substeps).toBe(7);
    expect(timingOfTick(0.1 + 0.2, 0.01).substeps).toBe(30);
    expect(timingOfTick(1e-6, 0.01).substeps).toBe(1);
  });
});
