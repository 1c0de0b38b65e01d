import { rotate } from '../authority';
import type { Quat, Vec3 } from '../dynamics';

/** Cosine of the angle between a ship's +Z and straight up; `position`: m from the body's centre, in the attitude's axes. */
export function cosineOfTilt(attitude: Quat, position: Vec3): number {
  const top = rotate(attitude, [0, 0, 1]);
  return (top[0] * position[0] + top[1] * position[1] + top[2] * position[2]) / Math.hypot(...position);
}
