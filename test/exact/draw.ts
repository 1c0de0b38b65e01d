/** Draws from a seeded generator by + − × ÷ √ alone, so that a seed gives the same case in every engine. */
import type { Quat, Vec3 } from '../../src/dynamics';
import type { Dice } from '../../src/scenarios';

export function between(dice: Dice, low: number, high: number): number {
  return low + (high - low) * dice();
}

export function chance(dice: Dice, probability: number): boolean {
  return dice() < probability;
}

export function pick<T>(dice: Dice, choices: readonly T[]): T {
  return choices[Math.floor(dice() * choices.length)]!;
}

export function whole(dice: Dice, low: number, high: number): number {
  return low + Math.floor(dice() * (high - low + 1));
}

export function triple(dice: Dice, most: number): Vec3 {
  return [between(dice, -most, most), between(dice, -most, most), between(dice, -most, most)];
}

/** Every direction alike: a point of the cube that lies in the ball. */
export function unitVector(dice: Dice): Vec3 {
  for (;;) {
    const [x, y, z] = triple(dice, 1);
    const length = Math.sqrt(x * x + y * y + z * z);
    if (length > 0.1 && length <= 1) return [x / length, y / length, z / length];
  }
}

export function unitQuaternion(dice: Dice): Quat {
  for (;;) {
    const [x, y, z] = triple(dice, 1);
    const w = between(dice, -1, 1);
    const length = Math.sqrt(x * x + y * y + z * z + w * w);
    if (length > 0.1 && length <= 1) return [x / length, y / length, z / length, w / length];
  }
}

/** A unit vector square to the unit vector `n`. */
export function tangent(dice: Dice, n: Vec3): Vec3 {
  for (;;) {
    const v = unitVector(dice);
    const along = v[0] * n[0] + v[1] * n[1] + v[2] * n[2];
    const t: Vec3 = [v[0] - along * n[0], v[1] - along * n[1], v[2] - along * n[2]];
    const length = Math.sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
    if (length > 0.1) return [t[0] / length, t[1] / length, t[2] / length];
  }
}
