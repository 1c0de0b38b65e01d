import { describe, expect, it } from 'vitest';
import type { BodyMotion } from '../../../src/dynamics';
import { createBodySpin, spunMotion } from '../../../src/prediction/snapshots/bodies/bodySpin';
import { flyCase } from '../../bench/netcode/foreign/foreign';
import { spread } from '../../bench/netcode/figure';
import { CASES } from '../literalServer/cases';
import { createRig } from '../rig';

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

describe('the spin of a body that turns otherwise than sent', () => {
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

  it('is as sent while that fits, and not that of one attitude', () => {
    expect(spins(() => 1)).toEqual([1, 1, 1, 1, 1, 1]);
    expect(spins((i) => (i === 3 ? 1.01 : 1)).every((factor) => factor === 1)).toBe(true);
  });

  it('is not measured twice from one tick, nor of a body that stands', () => {
    const spin = createBodySpin();
    for (const tick of [5, 5, 5, 4]) spunMotion(spin, turned(tick / 2, 1.01), tick, 0.5);
    expect(spin.byAttitude.last).toBeNaN();
    const still = { ...turned(0, 1), angularVelocity: [0, 0, 0] as const };
    for (const tick of [6, 7, 8]) expect(spunMotion(spin, still, tick, 0.5)).toEqual(still);
  });
});

describe('a body whose true spin differs by 1 % from the sent one', () => {
  it.each([
    ['spin 1 % off, attitudes true', 10],
    ['spin 1 % off, attitudes made of it', 10],
    ['spin 1 % off, attitudes true', 1],
    ['spin 1 % off, attitudes made of it', 1],
  ])('%s, sent at %i Hz: within 0.2 m (p95) from the third landed state on', (name, sends) => {
    const { ours } = flyCase(caseNamed(name), 50, sends);
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
