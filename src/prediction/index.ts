/** Server states and own controls → the present pose. */

/** The predictor: receive, advance, view. */
export { createPredictor, forkPredictor } from './predictor';
export { createLeanPredictor, type LeanOptions } from './leanPredictor';
export type { LeanPredictor, Predictor } from './calls/api';
/** The lean predictor and its features. */
export {
  type Feature,
  foreignDynamics,
  checkedRecords,
  completedBodies,
  inputAcknowledgements,
  mismatchValues,
  snapshotParts,
  surfaceEvents,
  learnedGround,
  measuredGameTime,
  measuredSpin,
  measuredTickRate,
  touchdownRecord,
  serverHello,
  roundTripPings,
  frameBudget,
  gameCatalogue,
  groundedGhost,
  replayedImpacts,
  sleepingShips,
  terrainNormals,
  unloadedGround,
} from './features';
export type { ClientTerrain, Defaults, PredictorOptions } from './options';
/** Reasons for removing a ship, and warnings to the caller. */
export type { Removal } from './ownership';
export type { Warn } from './warnings';
/** Drawing policies of ships, and the scheduled inputs of the player's ship. */
export type { Policy } from './simulation/track';
export type { ScheduledInput } from './inputs/inputs';
/** Its view. */
export type * from './drawn/view';
/** Settle times of corrections, and the state of the connection. */
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
/** The last messages as plain data, to continue from elsewhere. */
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
/** Recording and replaying a predictor's input. */
export {
  type PredictorEntry,
  recordPredictor,
  replayEntries,
  type PredictorCall,
  type Write,
} from './recorder';
