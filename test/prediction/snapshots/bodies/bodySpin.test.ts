import { describe, expect, it } from 'vitest';
import {
  BODY_ANGULAR_VELOCITY,
  BODY_STRIDE,
  type BodyMotion,
  CONTACT,
  LANDED,
  POSITION,
  REFERENCE_BODY,
  SHIP_STRIDE,
  SURFACE_STATE,
} from '../../../../src/dynamics';
import {
  createBodySpin,
  measureByShip,
  spunMotion,
} from '../../../../src/prediction/snapshots/bodies/bodySpin';
import { flyCase } from '../../../bench/netcode/foreign/foreign';
import { spread } from '../../../bench/netcode/figure';
import { CASES } from '../../literalServer/cases';
import { createRig } from '../../rig';
import { plus, product, rotate, times, turnAbout, unit } from '../../../dynamics/vectors';

const caseNamed = (name: string) => CASES.find((one) => one.name === name)!;

const RATE = 7e-5;
/** Attitude of a body about z after `seconds` at `factor` times the spin sent. */
const turned = (seconds: number, factor: number): BodyMotion => {
  const half = (RATE * factor * seconds) / 2;
  return {
    ...{ position: [0, 0, 0], velocity: [0, 0, 0], angularVelocity: [0, 0, RATE] },
    attitude: [0, 0, Math.sin(half), Math.cos(half)],
  };
};

describe('the spin of a body that turns differently than sent', () => {
  /** The motions in use, of frames each 10 ticks and 0.5 s. */
  const motions = (factorAt: (frame: number) => number, frames = 6) => {
    const spin = createBodySpin();
    return Array.from({ length: frames }, (_, i) =>
      spunMotion(spin, turned(i / 2, factorAt(i)), 1000 + i * 10, i === 0 ? 0 : 0.5),
    );
  };
  const spins = (factorAt: (frame: number) => number) =>
    motions(factorAt).map(({ angularVelocity }) => angularVelocity[2] / RATE);

  it('is measured from two pairs of attitudes that agree', () => {
    const found = spins(() => 1.01);
    expect(found.slice(0, 2)).toEqual([1, 1]);
    for (const factor of found.slice(2)) expect(factor).toBeCloseTo(1.01, 9);
  });

  it('leaves the attitudes as sent', () => {
    for (const [i, { attitude }] of motions(() => 1.01).entries())
      expect(attitude[2]).toBeCloseTo(turned(i / 2, 1.01).attitude[2], 15);
  });

  it('stays as sent while that fits, and needs more than one attitude', () => {
    expect(spins(() => 1)).toEqual([1, 1, 1, 1, 1, 1]);
    expect(spins((i) => (i === 3 ? 1.01 : 1)).every((factor) => factor === 1)).toBe(true);
  });

  it('is measured once per tick, and not for a body at rest', () => {
    const spin = createBodySpin();
    for (const tick of [5, 5, 5, 4]) spunMotion(spin, turned(tick / 2, 1.01), tick, 0.5);
    expect(spin.byAttitude.last).toBeNaN();
    const still = { ...turned(0, 1), angularVelocity: [0, 0, 0] as const };
    for (const tick of [6, 7, 8]) expect(spunMotion(spin, still, tick, 0.5)).toEqual(still);
  });
});

describe('the spin about an axis in general position', () => {
  const AXIS = unit([2, -3, 6]);
  const SPIN = times(AXIS, 1e-4);
  const TILT = turnAbout(unit([1, 1, -1]), 0.8);
  /** As sent after `seconds`: the attitude turns by `factor` times the spin sent. */
  const sent = (seconds: number, factor = 1): BodyMotion => ({
    ...{ position: [0, 0, 0], velocity: [0, 0, 0], angularVelocity: SPIN },
    attitude: product(turnAbout(AXIS, 1e-4 * factor * seconds), TILT),
  });
  const near = (found: readonly number[], expected: readonly number[], digits: number) => {
    for (const [k, x] of expected.entries()) expect(found[k]).toBeCloseTo(x, digits);
  };
  /** A state at rest on the second body, turned with it by `factor` of its spin after `seconds`, and moved `aside`, m. */
  const resting = (seconds: number, factor: number, { aside = 0, state = LANDED, body = 1 } = {}) => {
    const row = new Float64Array(SHIP_STRIDE);
    const place = rotate(turnAbout(AXIS, 1e-4 * factor * seconds), [4e5, -2e5, 5e5]);
    row.set(plus(place, times(AXIS, aside)), POSITION);
    row[SURFACE_STATE] = state;
    row[REFERENCE_BODY] = body;
    return row;
  };
  const bodies = new Float64Array(2 * BODY_STRIDE);
  bodies.set(SPIN, BODY_STRIDE + BODY_ANGULAR_VELOCITY);
  const measured = (first: Float64Array, second: Float64Array, seconds = 2) => {
    const spin = createBodySpin();
    measureByShip(spin, first, second, bodies, seconds);
    return spin.factor;
  };

  it.each([1.01, 0.6, 1.4])('is measured from the attitudes: %d of the one sent', (factor) => {
    const spin = createBodySpin();
    const made = [0, 1, 3, 4].map((at, i, all) =>
      spunMotion(spin, sent(at, factor), i, at - (all[i - 1] ?? at)),
    );
    near(made[3]!.angularVelocity, times(SPIN, factor), 12);
    near(made[3]!.attitude, sent(4, factor).attitude, 15);
  });

  it('is not measured if it is half as fast again, or if the body turns in two years', () => {
    const fast = createBodySpin();
    for (const at of [0, 1, 2, 3]) spunMotion(fast, sent(at, 1.51), at, 1);
    expect([fast.factor, fast.byAttitude.last]).toEqual([1, NaN]);
    const slow = createBodySpin();
    for (const at of [0, 1]) spunMotion(slow, { ...sent(at), angularVelocity: times(AXIS, 1e-9) }, at, 1);
    expect(slow.byAttitude.last).toBeNaN();
  });

  it('is measured from one ship that moves exactly with the ground', () => {
    expect(measured(resting(0, 1.01), resting(2, 1.01))).toBeCloseTo(1.01, 6);
    // The path is 47 m long: a thousandth of it aside is too much.
    expect(measured(resting(0, 1.01), resting(2, 1.01, { aside: 0.04 }))).toBeCloseTo(1.01, 6);
    expect(measured(resting(0, 1.01), resting(2, 1.01, { aside: 0.06 }))).toBe(1);
  });

  it('is measured from two readings beside that path if they agree', () => {
    const spin = createBodySpin();
    for (const at of [2, 4]) {
      measureByShip(spin, resting(at - 2, 1.01), resting(at, 1.01, { aside: 1 }), bodies, 2);
      if (at === 2) expect(spin.factor).toBe(1);
    }
    expect(spin.factor).toBeCloseTo(1.01, 5);
  });

  it.each([
    ['that touched in the first state', { state: CONTACT }, {}],
    ['that touched in the second', {}, { state: CONTACT }],
    ['that was at another body', { body: 0 }, {}],
  ])('is not that of a ship %s', (_, before, after) => {
    expect(measured(resting(0, 1.01, before), resting(2, 1.01, after))).toBe(1);
  });

  it('measured by ships turns the attitude sent further by what it lacks', () => {
    const spin = createBodySpin();
    spunMotion(spin, sent(0), 0, 0);
    measureByShip(spin, resting(0, 1.01), resting(2, 1.01), bodies, 2);
    const later = [5, 15].map((at) => spunMotion(spin, sent(at), at, at === 5 ? 5 : 10));
    for (const [i, at] of [5, 15].entries()) {
      near(later[i]!.angularVelocity, times(SPIN, 1.01), 10);
      near(later[i]!.attitude, sent(at, 1.01).attitude, 9);
    }
    // Rows in use have that spin: another ship measures the same one.
    const inUse = bodies.map((x) => x * spin.factor);
    measureByShip(spin, resting(3, 1.01), resting(5, 1.01), inUse, 2);
    expect(spin.factor).toBeCloseTo(1.01, 6);
  });
});

describe('a body whose true spin differs by 1 % from the sent one', () => {
  it.each([
    ['spin 1 % off, attitudes true', 10],
    ['spin 1 % off, attitudes made of it', 10],
    ['spin 1 % off, attitudes true', 1],
    ['spin 1 % off, attitudes made of it', 1],
  ])('%s, sent at %i Hz: within 0.2 m (p95) from the third landed state on', (name, sends) => {
    const { ours } = flyCase(caseNamed(name), 50, sends, ['ours']);
    expect(ours.settled.length).toBeGreaterThan(200);
    expect(spread(ours.settled).p95).toBeLessThan(0.2);
  });

  it('no spin correction is made for a server that sends the true spin', () => {
    const rig = createRig({ scenario: 'slide-mars', tickRate: 5 });
    rig.fly(18);
    expect(rig.view().own!.surfaceContactState).toBe('landed');
    expect(rig.view().diagnosis.correctionsMismatch).toBe(0);
    expect(rig.view().diagnosis.correctionsBody).toBe(0);
  });
});
