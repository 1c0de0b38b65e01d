/** Draws from a seeded generator by + − × ÷ √ alone, so that a seed gives the same case in every engine. */
import type { Quat, Vec3 } from '../../../src/dynamics';
import type { Random } from '../../../src/scenarios';

export function between(rng: Random, low: number, high: number): number {
  return low + (high - low) * rng();
}

export function chance(rng: Random, probability: number): boolean {
  return rng() < probability;
}

export function pick<T>(rng: Random, choices: readonly T[]): T {
  return choices[Math.floor(rng() * choices.length)]!;
}

export function whole(rng: Random, low: number, high: number): number {
  return low + Math.floor(rng() * (high - low + 1));
}

export function triple(rng: Random, most: number): Vec3 {
  return [between(rng, -most, most), between(rng, -most, most), between(rng, -most, most)];
}

/** A uniform direction: a point of the cube inside the sphere. */
export function unitVector(rng: Random): Vec3 {
  for (;;) {
    const [x, y, z] = triple(rng, 1);
    const length = Math.sqrt(x * x + y * y + z * z);
    if (length > 0.1 && length <= 1) return [x / length, y / length, z / length];
  }
}

export function unitQuaternion(rng: Random): Quat {
  for (;;) {
    const [x, y, z] = triple(rng, 1);
    const w = between(rng, -1, 1);
    const length = Math.sqrt(x * x + y * y + z * z + w * w);
    if (length > 0.1 && length <= 1) return [x / length, y / length, z / length, w / length];
  }
}

/** A unit vector perpendicular to the unit vector `n`. */
export function tangent(rng: Random, n: Vec3): Vec3 {
  for (;;) {
    const v = unitVector(rng);
    const along = v[0] * n[0] + v[1] * n[1] + v[2] * n[2];
    const t: Vec3 = [v[0] - along * n[0], v[1] - along * n[1], v[2] - along * n[2]];
    const length = Math.sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
    if (length > 0.1) return [t[0] / length, t[1] / length, t[2] / length];
  }
}
