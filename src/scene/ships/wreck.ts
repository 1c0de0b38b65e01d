import { quat } from 'gl-matrix';

/** The members of a drawn ship (ShipActor) that a crash changes. */
interface WreckedPose {
  readonly place: Float64Array;
  readonly turn: Float64Array;
  readonly blows: Float64Array;
  readonly compression: Float32Array;
}

/** Of h: how far the legs are folded. */
const FOLD = 0.55;
/** Lean of the wreck about local x and z. */
const LEAN = quat.fromEuler(new Float64Array(4), 9, 0, 16);

/** Poses a crashed ship as a wreck: on its belly, the legs folded, leaning. */
export function crumple(actor: WreckedPose, h: number): void {
  const upright = -actor.blows[1]!;
  // A ship that came down on its side keeps its pose.
  if (upright < 0.5) return;
  actor.compression.fill(FOLD * h);
  actor.place[1] = actor.place[1]! - FOLD * h * upright;
  quat.multiply(actor.turn, LEAN, actor.turn);
}
