import { quat } from 'gl-matrix';
import type { ShipActor } from './shipActor';

/** Of h: how far the legs are folded. */
const FOLD = 0.55;
/** Lean of the wreck about local x and z. */
const LEAN = quat.fromEuler(new Float64Array(4), 9, 0, 16);

/** Poses a crashed ship as a wreck: on its belly, the legs folded, leaning. */
export function crumple(actor: ShipActor, h: number): void {
  const upright = -actor.blows[1]!;
  // One that came down on its side needs no other pose.
  if (upright < 0.5) return;
  actor.compression.fill(FOLD * h);
  actor.place[1] = actor.place[1]! - FOLD * h * upright;
  quat.multiply(actor.turn, LEAN, actor.turn);
}
