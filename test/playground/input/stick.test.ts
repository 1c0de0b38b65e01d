import { describe, expect, it } from 'vitest';
import { NEUTRAL_CONTROLS } from '../../../src/dynamics';
import {
  createStick,
  isFlightAction,
  press,
  release,
  releaseAll,
  resetStick,
  sampleStick,
  setThrottle,
} from '../../../src/playground/input/stick';

describe('stick', () => {
  it('returns the same controls object while nothing changes', () => {
    const stick = createStick();
    press(stick, 'pitchPlus', NEUTRAL_CONTROLS);
    const first = sampleStick(stick, 0.016);
    expect(first.rotationInput).toEqual([1, 0, 0]);
    expect(sampleStick(stick, 0.016)).toBe(first);
    release(stick, 'pitchPlus');
    expect(sampleStick(stick, 0.016).rotationInput).toEqual([0, 0, 0]);
  });

  it('moves the throttle by 1 % per tap, slowly and then fast while held, and stops at its ends', () => {
    const stick = createStick();
    press(stick, 'throttleUp', NEUTRAL_CONTROLS);
    expect(sampleStick(stick, 0).thrustLevel).toBeCloseTo(0.01, 12);
    expect(sampleStick(stick, 0.5).thrustLevel).toBeCloseTo(0.04, 12);
    expect(sampleStick(stick, 5).thrustLevel).toBe(1);
    release(stick, 'throttleUp');
    press(stick, 'throttleCut', NEUTRAL_CONTROLS);
    expect(sampleStick(stick, 0.016).thrustLevel).toBe(0);
  });

  it('moves the throttle slowly again after each press of its keys, and of no other', () => {
    const stick = createStick();
    const held = (action: 'throttleUp' | 'throttleDown') => {
      const before = stick.throttle;
      press(stick, action, NEUTRAL_CONTROLS);
      sampleStick(stick, 0.5);
      release(stick, action);
      return Math.round(100 * (stick.throttle - before));
    };
    setThrottle(stick, 0.5, NEUTRAL_CONTROLS);
    expect([held('throttleUp'), held('throttleUp'), held('throttleDown'), held('throttleDown')]).toEqual([
      ...[4, 4, -4, -4],
    ]);
    press(stick, 'throttleUp', NEUTRAL_CONTROLS);
    sampleStick(stick, 1);
    const before = stick.throttle;
    press(stick, 'yawPlus', NEUTRAL_CONTROLS);
    sampleStick(stick, 0.2);
    expect(stick.throttle - before).toBeGreaterThan(0.05);
  });

  it('takes over from the scenario’s plan, and forgets the pilot’s input at a restart', () => {
    const stick = createStick();
    press(stick, 'yawMinus', { ...NEUTRAL_CONTROLS, thrustLevel: 0.7, attitudeHold: true });
    const taken = sampleStick(stick, 0.016);
    expect(taken.thrustLevel).toBeCloseTo(0.7, 12);
    expect([taken.attitudeHold, taken.rotationInput]).toEqual([true, [0, -1, 0]]);
    press(stick, 'yawPlus', NEUTRAL_CONTROLS);
    expect(sampleStick(stick, 0.016).rotationInput).toEqual([0, 0, 0]);
    press(stick, 'modeUpright', NEUTRAL_CONTROLS);
    press(stick, 'throttleFull', NEUTRAL_CONTROLS);
    expect(sampleStick(stick, 0.016)).toMatchObject({ attitudeMode: 'radial', thrustLevel: 1 });
    resetStick(stick);
    expect([stick.touched, stick.controls]).toEqual([false, NEUTRAL_CONTROLS]);
    expect(sampleStick(stick, 0.016)).toEqual(NEUTRAL_CONTROLS);
  });
});

describe('the stick, by device and by key', () => {
  const touched = () => Object.assign(createStick(), { touched: true });

  it('commands a device’s deflection unless a key on the same axis is held', () => {
    const stick = touched();
    Object.assign(stick.deflection, { tiltRight: 0.2, turnLeft: 0.1 });
    Object.assign(stick.deflection, { pushRight: 0.1, pushAway: -0.2, pushUp: 0.4 });
    const { rotationInput, translationInput } = sampleStick(stick, 0.02);
    expect([rotationInput, translationInput]).toEqual([
      [0, -0.2, 0.1],
      [0.11, -0.23, 0.46],
    ]);
    const keys = ['yawPlus', 'rollMinus', 'translateXMinus', 'translateYPlus', 'translateZMinus'] as const;
    for (const key of keys) press(stick, key, NEUTRAL_CONTROLS);
    const held = sampleStick(stick, 0.02);
    expect([held.rotationInput, held.translationInput]).toEqual([
      [0, 1, -1],
      [-1, 1, -1],
    ]);
  });

  it('moves the lever by half the fast rate for a device, down for its key, and within its ends', () => {
    const stick = touched();
    stick.deflection.lever = 1;
    expect(sampleStick(stick, 1).thrustLevel).toBeCloseTo(0.3, 12);
    stick.deflection.lever = -0.5;
    expect(sampleStick(stick, 1).thrustLevel).toBeCloseTo(0.15, 12);
    press(stick, 'throttleDown', NEUTRAL_CONTROLS);
    expect(sampleStick(stick, 0).thrustLevel).toBeCloseTo(0.14, 12);
    // 0.6 s at 0.06 a second, then 0.6 a second.
    expect(sampleStick(stick, 0.6).thrustLevel).toBeCloseTo(0.105, 12);
    expect(sampleStick(stick, 0.1).thrustLevel).toBeCloseTo(0.045, 12);
    release(stick, 'throttleDown');
    press(stick, 'throttleDown', NEUTRAL_CONTROLS);
    expect(sampleStick(stick, 0.1).thrustLevel).toBeCloseTo(0.03, 12);
    expect(sampleStick(stick, 9).thrustLevel).toBe(0);
    expect([2, -2, 0.5].map((to) => (setThrottle(stick, to, NEUTRAL_CONTROLS), stick.throttle))).toEqual([
      ...[1, 0, 0.5],
    ]);
    releaseAll(stick);
    expect([stick.leverSeconds, stick.held.size, stick.throttle]).toEqual([0, 0, 0.5]);
  });

  it('switches modes on and off, holds the attitude of the moment, and kills rates', () => {
    const stick = touched();
    const attitude = Float64Array.of(0.1, 0.2, 0.3, 0.9);
    const modes = (['modeUpright', 'modeRetrograde', 'modeRetrograde', 'modeHold'] as const).map((key) => {
      press(stick, key, NEUTRAL_CONTROLS, attitude);
      return sampleStick(stick, 0.02).attitudeMode;
    });
    expect(modes).toEqual(['radial', 'surface_retrograde', 'none', 'hold']);
    expect(sampleStick(stick, 0.02).targetAttitude).toEqual([0.1, 0.2, 0.3, 0.9]);
    press(stick, 'killRates', NEUTRAL_CONTROLS);
    const killed = sampleStick(stick, 0.02);
    expect([killed.attitudeMode, killed.attitudeHold]).toEqual(['none', true]);
    press(stick, 'rateDamping', NEUTRAL_CONTROLS);
    expect(sampleStick(stick, 0.02).attitudeHold).toBe(false);
    press(stick, 'throttleFull', NEUTRAL_CONTROLS);
    expect(sampleStick(stick, 0.02).thrustLevel).toBe(1);
  });

  it('is moved by flight keys, not by commands', () => {
    const flight = ['pitchPlus', 'translateZMinus', 'throttleFull', 'killRates', 'modeHold'] as const;
    expect(flight.every(isFlightAction)).toBe(true);
    expect((['autopilot', 'restart', 'mute', 'help'] as const).some(isFlightAction)).toBe(false);
  });
});
