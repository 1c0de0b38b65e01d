import { describe, expect, it } from 'vitest';
import { toInertial } from '../../../src/readout';
import { readPad, withDeadZone } from '../../../src/playground/input/gamepad';
import {
  createSteeringAxes,
  pushInput,
  pushKeyFor,
  alignSteeringAxes,
  turnInput,
  turnKeysFor,
} from '../../../src/playground/input/steering';
import {
  createDeflection,
  createStick,
  press,
  releaseAll,
  sampleStick,
} from '../../../src/playground/input/stick';
import { NEUTRAL_CONTROLS } from '../../../src/dynamics';

/** An eye in the south that looks north: right is east, away is north. */
const SCREEN = Float64Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);

/** An upright ship turned by `degrees` about its thrust axis. */
function headed(degrees: number): Float64Array {
  const half = (degrees * Math.PI) / 360;
  return Float64Array.of(0, 0, Math.sin(half), Math.cos(half));
}

function aimOf(attitude: Float64Array, flying = true) {
  const aim = createSteeringAxes();
  alignSteeringAxes(aim, SCREEN, attitude, flying);
  return aim;
}

/** Direction in which the top of a ship moves under the input: spin × up, in ICRF. */
function topMoves(attitude: Float64Array, input: readonly number[]): [number, number] {
  const spin = new Float64Array(3);
  toInertial(spin, attitude, Float64Array.from(input));
  return [Math.sign(Math.round(spin[1]! * 100)) + 0, Math.sign(Math.round(-spin[0]! * 100)) + 0];
}

describe('steering as the camera sees it', () => {
  it.each([0, 45, 90, 137, 180, 290])(
    'tilts away, towards, left and right at a heading of %i°',
    (degrees) => {
      const attitude = headed(degrees);
      const aim = aimOf(attitude);
      expect(topMoves(attitude, turnInput(aim, -1, 0, 0))).toEqual([0, 1]);
      expect(topMoves(attitude, turnInput(aim, 1, 0, 0))).toEqual([0, -1]);
      expect(topMoves(attitude, turnInput(aim, 0, 1, 0))).toEqual([-1, 0]);
      expect(topMoves(attitude, turnInput(aim, 0, -1, 0))).toEqual([1, 0]);
    },
  );

  it.each([0, 60, 200])('pushes to the right and away at a heading of %i°', (degrees) => {
    const attitude = headed(degrees);
    const push = new Float64Array(3);
    toInertial(push, attitude, Float64Array.from(pushInput(aimOf(attitude), 1, 0, 0)));
    expect(push[0]).toBeGreaterThan(0.9);
    expect(Math.abs(push[1]!)).toBeLessThan(0.02);
    toInertial(push, attitude, Float64Array.from(pushInput(aimOf(attitude), 0, 1, 0)));
    expect(push[1]).toBeGreaterThan(0.9);
  });

  it('rights a ship on its side with one key, and never rolls it', () => {
    // Tipped over to the east or the north-east, seen from the south.
    for (const [x, y] of [
      [0, 1],
      [-1, 0],
      [-0.5, 0.5],
    ] as const) {
      const length = Math.hypot(x, y);
      const half = Math.SQRT1_2;
      const attitude = Float64Array.of((x / length) * half, (y / length) * half, 0, half);
      const aim = aimOf(attitude, false);
      // About the same axis, backwards.
      const keys = turnKeysFor(aim, -x / length, -y / length);
      expect(keys).toHaveLength(1);
      const held = (plus: string, minus: string) =>
        (keys.includes(plus as never) ? 1 : 0) - (keys.includes(minus as never) ? 1 : 0);
      const input = turnInput(aim, held('pitchPlus', 'pitchMinus'), held('yawPlus', 'yawMinus'), 0);
      expect(input[2]).toBe(0);
      expect((input[0] * -x + input[1] * -y) / length / Math.hypot(input[0], input[1])).toBeGreaterThan(0.99);
    }
  });

  it('applies part of the torque in flight and all of it on the ground', () => {
    expect(turnInput(aimOf(headed(0)), -1, 0, 0)).toEqual([-0.35, 0, 0]);
    expect(turnInput(aimOf(headed(0), false), -1, 0, 0)).toEqual([-1, 0, 0]);
  });

  it('names the keys that rotate the ship about its own axes', () => {
    expect(turnKeysFor(aimOf(headed(0)), 1, 0)).toEqual(['pitchPlus']);
    expect(turnKeysFor(aimOf(headed(180)), 1, 0)).toEqual(['pitchMinus']);
    expect(turnKeysFor(aimOf(headed(90)), 1, 0)).toHaveLength(1);
    expect(turnKeysFor(aimOf(headed(45)), 1, 0)).toHaveLength(2);
    // The keys it names turn the ship that way.
    for (const degrees of [0, 30, 45, 90, 200, 315]) {
      const aim = aimOf(headed(degrees), false);
      const keys = turnKeysFor(aim, 0, -1);
      const sum = (plus: string, minus: string) =>
        (keys.includes(plus as never) ? 1 : 0) - (keys.includes(minus as never) ? 1 : 0);
      const input = turnInput(aim, sum('pitchPlus', 'pitchMinus'), sum('yawPlus', 'yawMinus'), 0);
      expect(input[1]).toBeLessThan(-0.9);
    }
  });
});

describe('a gamepad', () => {
  const button = (value: number) => ({ pressed: value > 0.5, value });
  const pad = (axes: number[], buttons: Record<number, number> = {}) => ({
    mapping: 'standard',
    axes,
    buttons: Array.from({ length: 17 }, (_, i) => button(buttons[i] ?? 0)),
  });

  it('has dead zones, and the full range beyond them', () => {
    expect([0, 0.1, -0.15, 0.16].map(withDeadZone)).toEqual([0, 0, 0, 0]);
    expect(withDeadZone(1)).toBe(1);
    expect(withDeadZone(-1)).toBe(-1);
    expect(withDeadZone(0.58)).toBeCloseTo(0.5, 9);
    expect(withDeadZone(NaN)).toBe(0);
  });

  it('tilts with the left stick, pushes with the right, throttles with the triggers, lifts with pressed sticks', () => {
    const out = createDeflection();
    expect(readPad(out, pad([1, -1, 0, 0], { 7: 1 }))).toBe(true);
    expect(out).toMatchObject({ tiltRight: 1, tiltAway: 1, pushRight: 0, lever: 1 });
    readPad(out, pad([0, 0, -1, 1], { 6: 1, 4: 1 }));
    expect(out).toMatchObject({ tiltRight: 0, pushRight: -1, pushAway: -1, lever: -1, turnLeft: 1 });
    const lifted = [10, 11].map((button) => {
      readPad(out, pad([0, 0, 0, 0], { [button]: 1 }));
      return out.pushUp;
    });
    expect(lifted).toEqual([-1, 1]);
  });

  it('of another mapping is ignored', () => {
    expect(readPad(createDeflection(), { ...pad([1, 1, 1, 1]), mapping: '' })).toBe(false);
  });

  it('deflects the stick, yields to keys, and releases everything at once', () => {
    const stick = createStick();
    stick.touched = true;
    stick.deflection.tiltAway = 0.5;
    expect(sampleStick(stick, 0.02).rotationInput).toEqual([-0.5, 0, 0]);
    press(stick, 'pitchPlus', NEUTRAL_CONTROLS);
    expect(sampleStick(stick, 0.02).rotationInput).toEqual([1, 0, 0]);
    releaseAll(stick);
    expect(sampleStick(stick, 0.02).rotationInput).toEqual([0, 0, 0]);
  });
});

describe('the size of what a stick commands', () => {
  const level = () => aimOf(headed(0), false);

  it('is the deflection’s, full at 1, in hundredths, in its direction', () => {
    expect(turnInput(level(), 0.3, 0, 0)).toEqual([0.3, 0, 0]);
    // Yaw + tips to the left: about the axis that points at the eye.
    expect(turnInput(level(), 0.6, -0.8, 0)).toEqual([0.75, 1, 0]);
    expect(turnInput(level(), 1, 1, 0)).toEqual([1, -1, 0]);
    expect(turnInput(level(), 0, 0, 0.123)).toEqual([0, 0, 0.12]);
    expect(turnInput(level(), 0, 0, -3)).toEqual([0, 0, -1]);
    expect(turnInput(level(), 0, 0, 3)).toEqual([0, 0, 1]);
    expect(turnInput(aimOf(headed(0)), 0, 0, 1)).toEqual([0, 0, 0.35]);
    expect(pushInput(level(), 0.6, 0, 0.8)).toEqual([0.75, 0, 1]);
    expect(pushInput(level(), 0, -1, 0)).toEqual([0, -1, 0]);
    expect(pushInput(level(), 0, 0, 0)).toEqual([0, 0, 0]);
    expect(pushInput(level(), 1, 1, 1)).toEqual([1, 1, 1]);
  });

  it('is zero about a screen axis within 6° of the thrust axis', () => {
    /** A ship leaning over to the north by `degrees`: tilting it left or right is about north. */
    const leaning = (degrees: number) => {
      const half = (-degrees * Math.PI) / 360;
      return aimOf(Float64Array.of(Math.sin(half), 0, 0, Math.cos(half)), false);
    };
    expect(turnInput(leaning(84), 0, 1, 0)).toEqual([0, -1, 0]);
    expect(turnInput(leaning(84.5), 0, 1, 0)).toEqual([0, 0, 0]);
    expect(turnInput(leaning(84.5), 1, 0, 0)).toEqual([1, 0, 0]);
  });

  it('is about the ship’s own axes without a picture', () => {
    const aim = aimOf(headed(90));
    alignSteeringAxes(aim, null, headed(90), false);
    expect(aim).toEqual(createSteeringAxes());
    expect([turnInput(aim, 1, 0, 0), turnInput(aim, 0, 1, 0)]).toEqual([
      [1, 0, 0],
      [0, 1, 0],
    ]);
    expect(pushInput(aim, 0, -0.6, 0.8)).toEqual([0, -0.75, 1]);
  });

  it.each([
    [0, 'translateXPlus', 'translateXPlus'],
    [0, 'translateYMinus', 'translateYMinus'],
    // Of a ship that heads west, +X points north: away.
    [90, 'translateXPlus', 'translateYPlus'],
    [90, 'translateXMinus', 'translateYMinus'],
    [90, 'translateYPlus', 'translateXMinus'],
    [90, 'translateYMinus', 'translateXPlus'],
    [180, 'translateXPlus', 'translateXMinus'],
    [200, 'translateZPlus', 'translateZPlus'],
    [200, 'translateZMinus', 'translateZMinus'],
  ] as const)('turned by %d°, %s is the key %s', (degrees, action, key) => {
    expect(pushKeyFor(aimOf(headed(degrees)), action)).toBe(key);
  });
});
