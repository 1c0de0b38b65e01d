import { SHIP_STRIDE, THRUST_LEVEL } from '../../dynamics';
import { createEase, type Ease } from './ease';
import type { ShipView } from './view';

/** The drawn and shown state of one ship; its track holds the prediction. The simulation never reads it. */
export interface Picture {
  readonly ease: Ease;
  /** Index of the body in whose axes `ease` is; -1 before the first view. */
  body: number;
  /** Substeps from its last uprighting to the front; 0: the front's last substep turned it upright. */
  sinceUprighting: number;
  /** The last predicted pose, in the body's axes, to ease from after a resynchronisation or a change of tempo. */
  hasHeld: boolean;
  readonly heldPlace: Float64Array;
  readonly heldAttitude: Float64Array;
  /** Game s by which the present jumped since the held pose: the ship's motion in that time is no correction. */
  skipped: number;
  /** Predicted ground above the drawn one, as the mesh uses it, m; follows the learned ground. */
  groundOffset: number;
  readonly status: Status;
  /** Its view; created when it is first seen. */
  view: ShipView | null;
}

/** Its shown state. */
export interface Status {
  /** The present surface state, -1 before the first, and when it began, server wall s. */
  state: number;
  since: number;
  /** CONTACT stays shown until this client wall s. */
  contactUntil: number;
  /** The last retracted prediction, and until when it is shown, client wall s. */
  withdrawn: ShipView['withdrawn'];
  withdrawnUntil: number;
  /** Tick of the server's state that the view shows, and server wall s then. */
  serverTick: number;
  serverWall: number;
  /** The commands that the view's controls were made from. */
  readonly commands: Float64Array;
}

/** Substeps: longer than any frame. */
export const LONG_AGO = 1e6;

export function createPicture(): Picture {
  return {
    ease: createEase(),
    body: -1,
    sinceUprighting: LONG_AGO,
    hasHeld: false,
    heldPlace: new Float64Array(3),
    heldAttitude: Float64Array.of(0, 0, 0, 1),
    skipped: 0,
    groundOffset: 0,
    status: {
      state: -1,
      since: 0,
      contactUntil: Number.NEGATIVE_INFINITY,
      withdrawn: '',
      withdrawnUntil: Number.NEGATIVE_INFINITY,
      serverTick: -1,
      serverWall: Number.NaN,
      commands: new Float64Array(SHIP_STRIDE - THRUST_LEVEL).fill(Number.NaN),
    },
    view: null,
  };
}
