/** Server truth and own controls -> a pose for now. */

/** The whole of it: receive, advance, view. */
export { createPredictor, forkPredictor, type Predictor } from './predictor';
export type { ClientTerrain, Defaults, PredictorOptions } from './options';
/** Why a ship leaves, and what a caller is warned of. */
export type { Removal } from './ownership';
export type { Warn } from './warnings';
/** What the own ship does by itself. */
export type { Policy } from './simulation/track';
export type { ScheduledInput } from './inputs/inputs';
/** What it gives. */
export type * from './drawn/view';
/** How fast a correction fades. */
export type { Smoothing } from './drawn/ease';
export type { Connection } from './time/connection';
/** A drawn pose on the drawn ground. */
export type { DrawnGround } from './drawn/snap/drawnGround';
export {
  createGroundedPose,
  type GroundPose,
  snapToGround,
  type GroundedPose,
} from './drawn/snap/groundSnap';
export { type Hull, hullOf, LEGS } from './drawn/snap/hull';
/** Told last, as plain data: to go on from elsewhere. */
export type { PredictorSnapshot } from './lifecycle/snapshot';
/** A predictor in a worker. */
export {
  type Channel,
  connectPredictor,
  type FromWorker,
  type RemotePredictor,
  servePredictor,
  type ToWorker,
} from './lifecycle/remote';
/** What goes through a predictor, written down and fed again. */
export {
  type PredictorEntry,
  recordPredictor,
  replayEntries,
  type PredictorCall,
  type Write,
} from './recorder';
