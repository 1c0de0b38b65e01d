/** What only some clients need of a predictor: a page loads the features that it hands to createLeanPredictor. */
import { TERRAINS } from '../dynamics';
import { turnWithBody, writeBetween } from './drawn/interpolate';
import { learnGround } from './ground/learn';
import { checkRollback } from './simulation/rollbackCheck';
import type { SessionFeatures } from './session';
import type { Features } from './simulation/simulation';
import { measureByShip, spunMotion } from './snapshots/bodies/bodySpin';
import { measureGameTime } from './snapshots/gameTimeMeter';
import { keepServerState } from './snapshots/reconcile/keepStates';
import { weighLaw } from './snapshots/reconcile/lawFit';
import { takeHello } from './snapshots/takeHello';
import { takePong } from './snapshots/takePong';
import { pingIfDue } from './time/pings';
import { fillTouchdown, logSubstep } from './touchdown/touchdownLog';
import { rewindLog } from './touchdown/touchdownRewind';

/** One of the features below, for `createLeanPredictor`. */
export interface Feature {
  /** Its name here. */
  readonly feature: string;
}

const ground: Features = { learnGround };
const dynamics: Features = { weighLaw };
const touchdown: Features = { touchdown: { rewindLog, logSubstep, fillTouchdown } };
const gameTime: Features = { measureGameTime };
const hello: Pick<SessionFeatures, 'takeHello'> = { takeHello };
const pings: Pick<SessionFeatures, 'takePong' | 'pingIfDue'> = { takePong, pingIfDue };
const spin: Features = { spin: { spunMotion, measureByShip } };

/** Learns where the server's ground differs from the client's (PREDICTION, Learned ground). */
export const learnedGround: Feature = { feature: 'learnedGround', ...ground };

/** Extrapolates a ship that the server moves by other dynamics (PREDICTION, Foreign dynamics). */
export const foreignDynamics: Feature = { feature: 'foreignDynamics', ...dynamics };

/** Records the own ship's last touchdown: `touchdown` of its view, for the HUD's touchdown card. */
export const touchdownRecord: Feature = { feature: 'touchdownRecord', ...touchdown };

/** Measures the game time per tick of a server that does not send it, or another (PREDICTION, Timeline). */
export const measuredGameTime: Feature = { feature: 'measuredGameTime', ...gameTime };

/** Measures the spin of bodies that turn otherwise than sent. */
export const measuredSpin: Feature = { feature: 'measuredSpin', ...spin };

/** Takes the hello of a server that sends one: its world, settings, classes, own ship and protocol version. */
export const serverHello: Feature = { feature: 'serverHello', ...hello };

/** Pings a server that answers with a pong: the clock then knows the round trip (PREDICTION, Clock). */
export const roundTripPings: Feature = { feature: 'roundTripPings', ...pings };

/** What createPredictor has. */
export const ALL_FEATURES: SessionFeatures = Object.freeze({
  ...{ ...ground, ...dynamics, ...touchdown, ...gameTime, ...spin },
  takeHello,
  takePong,
  pingIfDue,
  interpolation: { keep: keepServerState, writeBetween, turnWithBody },
  terrains: TERRAINS,
  checkRollback,
});
