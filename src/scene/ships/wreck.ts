import { quat } from 'gl-matrix';
import type { ShipActor } from './shipActor';

/** Of h: how far the legs are folded. */
const FOLD = 0.55;
/** Lean of the wreck about local x and z. */
const LEAN = quat.fromEuler(new Float64Array(4), 9, 0, 16);

/** Lays a posed ship down as one that hit too hard lies: on its belly, the legs folded away, leaning. */
export function crumple(actor: ShipActor, h: number): void {
  const upright = -actor.blows[1]!;
  // One that came down on its side lies already.
  if (upright < 0.5) return;
  actor.compression.fill(FOLD * h);
  actor.place[1] = actor.place[1]! - FOLD * h * upright;
  quat.multiply(actor.turn, LEAN, actor.turn);
}
