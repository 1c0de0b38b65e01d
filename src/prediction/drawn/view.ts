import type {
  Body,
  BodyMotion,
  Controls,
  LoadedSettings,
  LoadedShipClass,
  ShipEventName,
  SurfaceState,
} from '../../dynamics';

import type { Connection } from '../time/connection';

/** The result of `view(now)`: plain records, owned and reused by the predictor, valid until the next call. SI units. */

/** Provenance of a shown state. */
export type Provenance =
  /** The server's newest state of this ship agrees; `age` is the wall s since that state's instant. */
  | 'confirmed'
  /** Predicted beyond the server's newest state, or not confirmed by it yet; `age` wall s since the state began. */
  | 'predicted'
  /** No server state for two sends or more. */
  | 'stale'
  /** The time scale exceeds the budget: the server's last state, not extrapolated. */
  | 'off';

/** The last touchdown of the player's ship, from the first touch to rest, substep by substep. Speeds relative to the turning ground. */
export interface TouchdownView {
  /** A touch was simulated. False for a ship first seen on the ground, or one that touched while the page was away. */
  known: boolean;
  /** 'open' until the ship has landed, tipped or crashed. */
  outcome: 'open' | 'landed' | 'tipped' | 'crashed';
  /** Impact speed of the dynamics at the first touch, m/s. */
  verticalSpeed: number;
  /** Just before the first touch, m/s. */
  horizontalSpeed: number;
  /** Number of further touches. */
  bounces: number;
  /** Distance slid along the ground, without hops, m. */
  slideMetres: number;
  /** Game s from the first touch to rest, or so far. */
  settleSeconds: number;
  /** Largest tilt since just before the first touch, rad. */
  largestTilt: number;
}

export interface ShipView {
  /** The server's id. */
  readonly shipId: string;
  /** For display; any text. */
  name: string;
  /** Whether the player flies it. */
  own: boolean;
  /** Its constants. */
  shipClass: LoadedShipClass;
  /** Index into WorldView.bodies. */
  body: number;

  /** Predicted state at the present: m, relative to the body's centre, ICRF axes. HUD numbers come from these. */
  readonly position: Float64Array;
  /** m/s, likewise. */
  readonly velocity: Float64Array;
  /** Ship axes to ICRF, [x, y, z, w]. */
  readonly attitude: Float64Array;
  /** rad/s, ICRF axes. */
  readonly angularVelocity: Float64Array;
  /** Momentum stored in the reaction wheels, N m s, body axes. */
  readonly wheelMomentum: Float64Array;
  /** kg. */
  fuel: number;
  /** m/s */
  impactSpeed: number;
  /** Empty in flight. */
  surfaceContactState: SurfaceState;
  /** The ship is destroyed, as predicted or as sent. */
  crashed: boolean;
  /** Its present controls. */
  controls: Controls;
  /** N, ICRF axes: present thrust of engine and thrusters. */
  readonly thrust: Float64Array;
  /**
   * Radius of the ground along the ship's own radial direction, m: body radius + terrain height + groundOffset. Heights above ground
   * come from it.
   */
  groundRadius: number;
  /**
   * The surface normal under its feet, unit, ICRF axes: local up, or the slope's if the settings require it and the ship is near the ground.
   * Tilt is measured from it.
   */
  readonly groundNormal: Float64Array;
  /** Height of its centre of mass above its feet, m: its own, or its class's. */
  groundContactOffset: number;
  /** The server's ground above the drawn terrain there, m, learned from its states; 0 where they agree. And the confidence, 0 … 1. */
  groundOffset: number;
  groundConfidence: number;
  /**
   * '' if the ship is predicted by the dynamics. Otherwise it is extrapolated from the server's states, and never confirmed: 'law' if the
   * dynamics were worse than that over the last few states, 'ground' if the ground below it is unknown.
   */
  extrapolated: '' | 'law' | 'ground';
  /** Server states received while it was extrapolated. */
  extrapolatedStates: number;

  /** The drawn pose: predicted + fading offset; m, relative to the body's centre, ICRF axes. The simulation does not read it. */
  readonly easedPosition: Float64Array;
  /** [x, y, z, w], likewise. */
  readonly meshAttitude: Float64Array;
  /** The drawn position, lifted or lowered along the local up until the drawn attitude is on the ground (snapToGround); m, likewise. */
  readonly meshPosition: Float64Array;
  /** How far each leg is pressed in, m, in the order of the class's hull (hullOf). */
  readonly legCompression: Float64Array;
  /** Height of the lowest foot of the predicted pose above the ground, m; negative during an impact. */
  feetHeight: number;

  /** Surface state to show: CONTACT dwells 300 ms so that a bounce can be read. 'crashed' only once the server confirmed it. */
  shownState: SurfaceState | 'crashed';
  /** How far shownState can be trusted. */
  provenance: Provenance;
  /** Wall s, see Provenance. */
  age: number;
  /** A predicted state that the server did not confirm, for 2 s; otherwise ''. */
  withdrawn: '' | 'contact' | 'landed' | 'tipped' | 'righted' | 'crashed';

  /** Of the player's ship; `known` is false for others. */
  readonly touchdown: TouchdownView;

  /** The server's newest state of this ship: m, relative to the body's centre at that tick, ICRF axes. */
  readonly serverPosition: Float64Array;
  /** [x, y, z, w]. */
  readonly serverAttitude: Float64Array;
  /** The same pose for drawing a ghost: on the ground like meshPosition; m, relative to the body's centre, in its axes. */
  readonly ghostPosition: Float64Array;
  /** Ship axes to the body's, [x, y, z, w]. */
  readonly ghostAttitude: Float64Array;
  /** false before the first state of this ship. */
  serverKnown: boolean;
  /** Sends without this ship: it is removed at 3, if that took a second. A crash shows in shownState. */
  missingSends: number;
}

/** A predicted event or one of the server, in order of time. */
export interface EventNotice {
  /** Each is reported at most once, in this order. */
  readonly kind: 'predicted' | 'confirmed' | 'retracted';
  /** The game’s event name. */
  readonly type: ShipEventName;
  readonly shipId: string;
  readonly tick: number;
  readonly substep: number;
}

export interface WorldView {
  /** The present that is drawn: server tick boundary and game seconds since it. */
  tick: number;
  /** Game s. */
  sinceTick: number;
  /** Hz. */
  tickRate: number;
  /** Game s per wall s. */
  timeScale: number;
  /** The server is paused, by its newest frame. */
  paused: boolean;
  /** False until a hello (or defaults) and a first frame have arrived. */
  ready: boolean;
  /** State of the connection: distinguishes a paused server, a stalled link and a lost server. */
  connection: Connection;
  /** Client wall s since the newest frame; infinite before the first. */
  silence: number;
  /** Contact settings in force. */
  settings: LoadedSettings;
  readonly bodies: (Body & BodyMotion)[];
  readonly ships: ShipView[];
  /** The player's ship in `ships`, or null. */
  own: ShipView | null;
  /** Counters and gauges. */
  diagnosis: Diagnosis;
}

/** Counters, monotonic, and gauges where stated. */
export interface Diagnosis {
  framesAccepted: number;
  framesDuplicate: number;
  framesOutOfOrder: number;
  framesTooOld: number;
  framesFromFuture: number;
  framesRefused: number;
  /** Refused ships of accepted frames, and the reason of the last refusal, of a frame or a ship. */
  shipsRefused: number;
  lastRefusal: string;
  /** False while the server has sent no hello: settings, classes and terrain are then the defaults. */
  helloReceived: boolean;
  /** Corrections by kind. */
  correctionsLateInput: number;
  correctionsLostInput: number;
  correctionsOtherPilot: number;
  correctionsMismatch: number;
  /** '' or the first field that differed in the last mismatch, with both values. */
  lastMismatch: string;
  replayedSubsteps: number;
  /** Ship substeps in step with the present, replays not counted. */
  steppedSubsteps: number;
  budgetOverruns: number;
  snaps: number;
  resyncs: number;
  /** Frames whose bodies were not where they were predicted to be turned to; the last one's largest component of an attitude, and of a spin, rad/s. */
  correctionsBody: number;
  errorBodyAttitude: number;
  errorBodySpin: number;
  /** Invalid acknowledgements: later than their own frame, or without a number. */
  acknowledgementsRefused: number;
  /** Dropped because the host did not take outgoing messages. */
  pingsDropped: number;
  inputsDropped: number;
  /** Frames superseded before they were decoded: only their events were used. */
  framesSuperseded: number;
  /** Gauge: memory of the predicted states of all ships, bytes. */
  historyBytes: number;
  /** Gauges, wall s: */
  clockOffset: number;
  /** 0.9 … 1.1 */
  clockRate: number;
  roundTrip: number;
  jitter: number;
  lead: number;
  /** Forced rollbacks (a test mode): compared, and not equal to the bit. */
  rollbacksCompared: number;
  rollbacksDifferent: number;
  /** Arrival margin of the last acknowledged input, wall s; negative: late. */
  margin: number;
  /**
   * Error of the prediction of the player's ship at the server's newest state, m and rad, in the body's axes; NaN without a prediction
   * for its tick.
   */
  errorPosition: number;
  errorAngle: number;
  /** Ships extrapolated at present, not predicted by the dynamics, and states received while one was. */
  shipsExtrapolated: number;
  statesExtrapolated: number;
  /** The server's ground above the drawn terrain under the player's ship, m, and the confidence, 0 … 1. */
  groundOffset: number;
  groundConfidence: number;
  /** Size of the offset being eased on the player's ship, m and rad. */
  offsetPosition: number;
  offsetAngle: number;
}
