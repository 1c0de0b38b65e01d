import {
  BODY_POSITION,
  BODY_STRIDE,
  BODY_VELOCITY,
  CRASHED,
  FLYING,
  POSITION,
  REFERENCE_BODY,
  SURFACE_STATE,
  VELOCITY,
} from './state/layout';
import type { World } from './constants/world';

/**
 * At a tick's start: makes the body with the smallest distance / radius a flying ship's reference body (ties: the first listed), and
 * converts the ship's relative state with both bodies' positions and velocities (DYNAMICS, Frame).
 */
export function chooseReferenceBody(
  ships: Float64Array,
  at: number,
  bodies: Float64Array,
  world: World,
): void {
  if (ships[at + SURFACE_STATE] !== FLYING || ships[at + CRASHED] === 1) return;
  const now = ships[at + REFERENCE_BODY]! * BODY_STRIDE;
  let nearest = Infinity;
  let best = 0;
  for (let i = 0; i < world.bodies.length; i++) {
    const body = i * BODY_STRIDE;
    const x = bodies[now + BODY_POSITION]! - bodies[body + BODY_POSITION]! + ships[at + POSITION]!;
    const y =
      bodies[now + BODY_POSITION + 1]! - bodies[body + BODY_POSITION + 1]! + ships[at + POSITION + 1]!;
    const z =
      bodies[now + BODY_POSITION + 2]! - bodies[body + BODY_POSITION + 2]! + ships[at + POSITION + 2]!;
    const { radius } = world.bodies[i]!;
    // Squares have the same order.
    const measure = (x * x + y * y + z * z) / (radius * radius);
    if (measure < nearest) {
      nearest = measure;
      best = i;
    }
  }
  if (best === ships[at + REFERENCE_BODY]) return;
  const next = best * BODY_STRIDE;
  for (let k = 0; k < 3; k++) {
    const apart = bodies[now + BODY_POSITION + k]! - bodies[next + BODY_POSITION + k]!;
    const drift = bodies[now + BODY_VELOCITY + k]! - bodies[next + BODY_VELOCITY + k]!;
    ships[at + POSITION + k] = apart + ships[at + POSITION + k]!;
    ships[at + VELOCITY + k] = drift + ships[at + VELOCITY + k]!;
  }
  ships[at + REFERENCE_BODY] = best;
}
