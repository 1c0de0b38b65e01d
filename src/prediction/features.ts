/** Optional parts of a predictor: a page loads only the features that it passes to createLeanPredictor. */
import { faultOfConstants, TERRAIN_NORMALS, TERRAINS, writeBodyMotion } from '../dynamics';
import { groundGhost } from './drawn/ghost';
import { slopeBelow } from './drawn/slopeBelow';
import { rowOfPolicy } from './drawn/interpolate';
import { snapToLevel } from './drawn/snap/levelSnap';
import { learnGround } from './ground/learn';
import { knowsGround, withoutGround } from './ground/unknownGround';
import { GAME_CATALOGUE } from './options';
import { announce, type SessionFeatures } from './session';
import { extrapolate } from './simulation/extrapolate';
import { rowsWithin } from './simulation/rings/history';
import {
  holdSleeping,
  placeAsleep,
  sleepAtFirst,
  sleepIfAtRest,
  sleepsOn,
  sleepsThrough,
  wakeIfBurning,
  writeSleeping,
} from './simulation/sleep';
import { acknowledgementOf, applyAcknowledgement } from './inputs/acknowledgements';
import { completeBodies } from './snapshots/bodies/completeBodies';
import { createBodySpin, measureByShip, spunMotion } from './snapshots/bodies/bodySpin';
import { gameTimeScale } from './snapshots/tempo/gameTimeMeter';
import { learnFrom } from './snapshots/reconcile/learnFrom';
import { describeDifference } from './snapshots/reconcile/compare';
import { keepServerState } from './snapshots/reconcile/keepStates';
import { holdLaw } from './snapshots/reconcile/lawErrors';
import { chooseMotion } from './snapshots/reconcile/lawFit';
import { replayImpact } from './snapshots/reconcile/recall';
import { confirmEnd, confirmEvents, recordPredicted, settleEvents } from './events/settleEvents';
import { isPlaced, recordsOf, tickFault } from './snapshots/checkedRecords';
import { shipFault } from './snapshots/shipFault';
import { receiveHello } from './snapshots/receiveHello';
import { receiveRest, takeOlder, takePart, takeShips } from './snapshots/takeParts';
import { receivePong } from './snapshots/receivePong';
import { loadUntrusted } from './lifecycle/worldConfig';
import { measureUnsentRate, sentUntimed } from './snapshots/tempo/unsentTickRate';
import { keepWithinBudget } from './frameBudget';
import { pingIfDue } from './time/pings';
import { fillTouchdown, logSubstep } from './touchdown/touchdownLog';
import { rewindLog } from './touchdown/touchdownRewind';
import { forgetLogsAfter, keepLog, logLanded, resizeLogs } from './touchdown/touchdownRing';

/** One of the features below, for `createLeanPredictor`. */
export interface Feature {
  /** Its name here. */
  readonly feature: string;
}

const feature = (name: string, parts: Partial<SessionFeatures>): Feature => ({ feature: name, ...parts });

const learning = { learnFrom, holdLaw };
const unknownGround = { knowsGround, withoutGround };
const sleep = {
  sleepIfAtRest,
  sleepAtFirst,
  sleepsOn,
  sleepsThrough,
  placeAsleep,
  holdSleeping,
  wakeIfBurning,
  writeSleeping,
};
const touchdown = {
  rewindLog,
  logSubstep,
  fillTouchdown,
  keepLog,
  forgetLogsAfter,
  resizeLogs,
  logLanded,
};
const spin = { createBodySpin, spunMotion, measureByShip };
const events = { recordPredicted, confirmEvents, settleEvents, confirmEnd };
const acknowledgements = { acknowledgementOf, applyAcknowledgement };
const tickRates = { measureUnsentRate, sentUntimed };
const records = { tickFault, recordsOf, isPlaced, shipFault, loadUntrusted, writeBodyMotion };
const parts = { takeShips, takeOlder, takePart, receiveRest };

/** The game's ship classes and bodies, for a page whose `defaults` have none. */
export const gameCatalogue: Feature = feature('gameCatalogue', { catalogue: GAME_CATALOGUE });

/** The ground's own normals, for a server whose setting `surfaceNormal` is 'terrain' (DYNAMICS, "The ground's own normal"). */
export const terrainNormals: Feature = feature('terrainNormals', {
  terrainNormals: TERRAIN_NORMALS,
  slopeBelow,
});

/** Learns where the server's ground differs from the client's (PREDICTION, Learned ground). */
export const learnedGround: Feature = feature('learnedGround', { learning, learnGround });

/** Extrapolates a ship that the server moves by other dynamics (PREDICTION, Foreign dynamics). */
export const foreignDynamics: Feature = feature('foreignDynamics', {
  learning,
  chooseMotion,
  extrapolate,
});

/** Extrapolates ships above ground that the client has not loaded: where its terrain returns null (PREDICTION, Learned ground). */
export const unloadedGround: Feature = feature('unloadedGround', { learning, unknownGround, extrapolate });

/** Lets landed ships sleep: they cost no substep while the server agrees (PREDICTION, Reconciliation). */
export const sleepingShips: Feature = feature('sleepingShips', { sleep });

/**
 * Keeps frames short with many ships, and their memory bounded: beyond `maxSubstepsPerFrame` distant ones are not predicted
 * (PREDICTION, Other ships), beyond 32 ships the ground below the others counts as level for drawing, and the predicted states of all
 * ships but the player’s take at most 32 MB.
 */
export const frameBudget: Feature = feature('frameBudget', { keepWithinBudget, snapToLevel, rowsWithin });

/** Finds the impact speed of a contact that was not predicted, from a server that does not send it. */
export const replayedImpacts: Feature = feature('replayedImpacts', { replayImpact });

/** Puts the ghost of a view, the server's newest state, on the drawn ground like the ship itself. */
export const groundedGhost: Feature = feature('groundedGhost', { groundGhost });

/** Records the last touchdown of the player's ship: `touchdown` of its view, for the HUD's touchdown card. */
export const touchdownRecord: Feature = feature('touchdownRecord', { touchdown });

/** Predicted, confirmed and retracted events: `onEvent`, and `withdrawn` of a view (PREDICTION, Events). */
export const surfaceEvents: Feature = feature('surfaceEvents', { events, announce });

/** Takes a server's acknowledgements of inputs, and steers the lead by their margins (PREDICTION, Clock). */
export const inputAcknowledgements: Feature = feature('inputAcknowledgements', { acknowledgements });

/** Completes bodies that a frame sends in part, without attitude or spin, in another order, or outdated. */
export const completedBodies: Feature = feature('completedBodies', { completeBodies });

/** Takes snapshots in several messages or out of order, and thousands of new ships without blocking. */
export const snapshotParts: Feature = feature('snapshotParts', { parts });

/** Checks each frame's records, for a caller that makes them itself instead of decoding them. */
export const checkedRecords: Feature = feature('checkedRecords', { records });

/** Both values of a field that differed, in `lastMismatch` of the diagnosis. */
export const mismatchValues: Feature = feature('mismatchValues', { describeDifference });

/** Measures the game time per tick of a server that does not send it, or sends a wrong one (PREDICTION, Timeline). */
export const measuredGameTime: Feature = feature('measuredGameTime', { gameTimeScale });

/** Measures the tick rate of a server that does not send it (PREDICTION, Timeline). */
export const measuredTickRate: Feature = feature('measuredTickRate', { tickRates });

/** Measures the spin of bodies whose sent spin is wrong. */
export const measuredSpin: Feature = feature('measuredSpin', { learning, spin });

/** Takes the hello of a server that sends one: its world, settings, classes, the player's ship and protocol version. */
export const serverHello: Feature = feature('serverHello', { receiveHello, faultOfConstants });

/** Pings a server that answers with a pong: measures the round trip (PREDICTION, Clock). */
export const roundTripPings: Feature = feature('roundTripPings', { receivePong, pingIfDue });

/** The features of createPredictor while rollbacks are forced. */
export const AWAKE_FEATURES: SessionFeatures = Object.freeze({
  learning,
  learnGround,
  chooseMotion,
  extrapolate,
  unknownGround,
  replayImpact,
  keepWithinBudget,
  snapToLevel,
  rowsWithin,
  groundGhost,
  touchdown,
  events,
  announce,
  acknowledgements,
  completeBodies,
  parts,
  records,
  describeDifference,
  gameTimeScale,
  tickRates,
  spin,
  receiveHello,
  faultOfConstants,
  receivePong,
  pingIfDue,
  terrains: TERRAINS,
  catalogue: GAME_CATALOGUE,
  terrainNormals: TERRAIN_NORMALS,
  slopeBelow,
  keepServerState,
  rowOfPolicy,
});

/** The features of createPredictor. */
export const ALL_FEATURES: SessionFeatures = Object.freeze({ ...AWAKE_FEATURES, sleep });
