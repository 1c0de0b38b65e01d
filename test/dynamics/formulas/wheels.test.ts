import { describe, expect, it } from 'vitest';
import { ANGULAR_VELOCITY, ATTITUDE, FUEL, POSITION, VELOCITY, WHEEL_MOMENTUM } from '../../../src/dynamics';
import { classNamed, createTrial, quaternionAt, run, still, vectorAt } from '../provingGround';
import { cross, dot, lengthOf, product, rotate, times, turnAbout, unit } from '../vectors';

const FAR = 1e9;
const FRIGATE = classNamed('fast_frigate');
const TORQUE = FRIGATE.reactionWheelTorque[0];
const CAPACITY = FRIGATE.reactionWheelCapacity![0];

describe('reaction wheels', () => {
  // Target: capacity / torque = 10 s. The stick commands exactly the wheel's torque.
  it('absorb a torque for capacity / torque seconds, then RCS burns fuel for it', () => {
    const stick = TORQUE / (TORQUE + FRIGATE.rcsTorque[0]);
    const controls = { rotationInput: [stick, 0, 0] as const };
    const trial = createTrial({ body: still('Phobos'), shipClass: FRIGATE, height: FAR, controls });
    const full = trial.ships[FUEL];
    const seconds = CAPACITY / TORQUE;
    run(trial, seconds - 0.01);
    expect(trial.ships[FUEL]).toBe(full);
    expect(trial.ships[WHEEL_MOMENTUM]).toBeCloseTo(CAPACITY - TORQUE * 0.01, 6);
    run(trial, 1);
    expect(trial.ships[WHEEL_MOMENTUM]).toBeCloseTo(CAPACITY, 6);
    expect(trial.ships[FUEL]).toBeLessThan(full!);
    // The ship turns on as before.
    const spin = lengthOf(vectorAt(trial.ships, ANGULAR_VELOCITY));
    expect(spin).toBeCloseTo((TORQUE * (seconds + 0.99)) / 80000, 5);
  });

  it('give their momentum back when they turn the other way', () => {
    const controls = { rotationInput: [-1, 0, 0] as const };
    const trial = createTrial({ body: still('Phobos'), shipClass: FRIGATE, height: FAR, controls });
    trial.ships[WHEEL_MOMENTUM] = CAPACITY;
    run(trial, (2 * CAPACITY) / TORQUE);
    expect(trial.ships[WHEEL_MOMENTUM]).toBeCloseTo(-CAPACITY, 6);
  });

  it('never saturate when the capacity is infinite', () => {
    const shipClass = { ...FRIGATE, reactionWheelCapacity: null };
    const controls = { rotationInput: [1, 0, 0] as const };
    const trial = createTrial({ body: still('Phobos'), shipClass, height: FAR, controls });
    run(trial, 60);
    expect(trial.ships[WHEEL_MOMENTUM]).toBeCloseTo(60 * TORQUE, 5);
  });
});

describe('the attitude controller', () => {
  // Target: (1 + ω t) e^(−ω t) of the angle is left at t = 8 s = 4 / ω: 9.2 %.
  it.each(['prograde', 'retrograde', 'surface_retrograde', 'radial', 'antinormal'] as const)(
    'reduces a frigate’s error of 20° to a tenth within 8 s: %s',
    (attitudeMode) => {
      const controls = { attitudeMode };
      const velocity = [300, 100, 0] as const;
      const trial = createTrial({
        body: still('Phobos'),
        shipClass: FRIGATE,
        height: FAR,
        velocity,
        controls,
      });
      const r = unit(vectorAt(trial.ships, POSITION));
      const u = unit(vectorAt(trial.ships, VELOCITY));
      const target = {
        prograde: u,
        retrograde: times(u, -1),
        surface_retrograde: times(u, -1),
        radial: r,
        antinormal: unit(cross(u, r)),
      }[attitudeMode];
      const off = () => {
        const top = rotate(quaternionAt(trial.ships, ATTITUDE), [0, 0, 1]);
        return (Math.atan2(lengthOf(cross(top, target)), dot(top, target)) * 180) / Math.PI;
      };
      const level = cross([0, 0, 1], target);
      const onto = turnAbout(unit(level), Math.atan2(lengthOf(level), target[2]));
      trial.ships.set(product(onto, turnAbout([0.6, 0.8, 0], Math.PI / 9)), ATTITUDE);
      expect(off()).toBeCloseTo(20, 6);
      run(trial, 8);
      expect(off()).toBeLessThan(2);
    },
  );
});
