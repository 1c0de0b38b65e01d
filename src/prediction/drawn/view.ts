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

/** What `view(now)` gives: plain records, owned and reused by the predictor, valid until the next call. SI units. */

/** How far a shown state can be trusted. */
export type Provenance =
  /** The server's own newest state of this ship says the same; `age` wall s since that state's instant. */
  | 'confirmed'
  /** Predicted past the server's newest state, or against it until it answers; `age` wall s since the state began. */
  | 'predicted'
  /** No server state for two sends or more. */
  | 'stale'
  /** Time scale outruns the budget: the server's last state, not carried on. */
  | 'off';

/** The own ship's last touchdown, from the first touch to rest, as the law's substeps had it. Speeds relative to the turning ground. */
export interface TouchdownView {
  /** A touch was seen: a ship met on the ground, or one that came down while the page was away, has no card. */
  known: boolean;
  /** 'open' until the ship has landed, tipped or crashed. */
  outcome: 'open' | 'landed' | 'tipped' | 'crashed';
  /** The law's impact speed at the first touch, m/s. */
  verticalSpeed: number;
  /** Just before the first touch, m/s. */
  horizontalSpeed: number;
  /** Times it came down again. */
  bounces: number;
  /** Way along the ground while on it, hops not counted, m. */
  slideMetres: number;
  /** Game s from the first touch to rest, or so far. */
  settleSeconds: number;
  /** Rad, since the first touch; the tilt it came with counts. */
  largestTilt: number;
}

export interface ShipView {
  /** As the server has it. */
  readonly shipId: string;
  /** For people; any text. */
  name: string;
  /** Whether the player flies it. */
  own: boolean;
  /** Its constants. */
  shipClass: LoadedShipClass;
  /** Index into WorldView.bodies. */
  body: number;

  /** Predicted truth at the present: relative to the body's centre, ICRF axes. HUD numbers come from these. */
  readonly position: Float64Array;
  /** m/s, likewise. */
  readonly velocity: Float64Array;
  /** [x, y, z, w] */
  readonly attitude: Float64Array;
  /** rad/s, ICRF axes. */
  readonly angularVelocity: Float64Array;
  /** What the reaction wheels have given so far, N m s, body axes. */
  readonly wheelMomentum: Float64Array;
  /** kg. */
  fuel: number;
  /** m/s */
  impactSpeed: number;
  /** Empty in flight. */
  surfaceContactState: SurfaceState;
  /** Predicted or told: it is gone. */
  crashed: boolean;
  /** What it is flown with now. */
  controls: Controls;
  /** N, ICRF axes: what engine and thrusters give now. */
  readonly thrust: Float64Array;
  /**
   * Radius of the ground along the ship's own radial direction, m: body radius + terrain height + groundOffset. Heights above ground
   * come from it.
   */
  groundRadius: number;
  /**
   * The surface normal under its feet, unit, ICRF axes: local up, or the slope's where the settings say so and it is near the ground.
   * Tilt is measured from it.
   */
  readonly groundNormal: Float64Array;
  /** Height of its centre of mass above its feet, m: its own, or its class's. */
  groundContactOffset: number;
  /** The server's ground above the drawn terrain there, m, as its states tell; 0 where they agree. And how sure, 0 … 1. */
  groundOffset: number;
  groundConfidence: number;
  /**
   * '' where the ship is predicted by the law. Else its motion is carried on from the server's states: 'law' where the law has been
   * worse than that over the last few of them, 'ground' where no ground is known under it. Never confirmed then.
   */
  carried: '' | 'law' | 'ground';
  /** Server states that came while it was carried on. */
  carriedStates: number;

  /** What is drawn: predicted + fading offset. Nothing computes with it but the view. */
  readonly easedPosition: Float64Array;
  /** [x, y, z, w], of the same. */
  readonly meshAttitude: Float64Array;
  /** The drawn place, lifted or lowered along the local up until the drawn attitude is on the ground (snapToGround), ICRF axes. */
  readonly meshPosition: Float64Array;
  /** How far each leg is pressed in, m, in the order of the class's hull (hullOf). */
  readonly legCompression: Float64Array;
  /** Height of the lowest foot of the predicted pose above the ground beneath it, m; negative while an impact sinks it. */
  feetHeight: number;

  /** Surface state to show: CONTACT dwells 300 ms so that a bounce can be read. 'crashed' only once the server confirmed it. */
  shownState: SurfaceState | 'crashed';
  /** How far shownState can be trusted. */
  provenance: Provenance;
  /** Wall s, see Provenance. */
  age: number;
  /** A predicted state the server did not have: shown for 2 s, else ''. */
  withdrawn: '' | 'contact' | 'landed' | 'tipped' | 'righted' | 'crashed';

  /** Of the own ship; of others never known. */
  readonly touchdown: TouchdownView;

  /** The server's newest state of this ship: relative to the body at that tick, ICRF axes. */
  readonly serverPosition: Float64Array;
  /** [x, y, z, w]. */
  readonly serverAttitude: Float64Array;
  /** The same as a ghost to draw: put on the ground as meshPosition is, in the axes of its body, with which it turns. */
  readonly ghostPosition: Float64Array;
  /** [x, y, z, w]. */
  readonly ghostAttitude: Float64Array;
  /** false before the first state of this ship. */
  serverKnown: boolean;
  /** Sends of the server without this ship: it leaves the list at 3, if that took a second. A crashed ship says so in shownState. */
  missingSends: number;
}

/** A predicted or server-told event, in the order of its birth. */
export interface EventNotice {
  /** Told once each, in this order. */
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
  /** The server’s time stands still. */
  paused: boolean;
  /** False until a hello (or defaults) and a first frame have come. */
  ready: boolean;
  /** Whether the server is heard: a paused one, a link that stalls and a server that is gone are told apart. */
  connection: Connection;
  /** Client wall s since the newest frame came; infinite before the first. */
  silence: number;
  /** Contact settings that hold. */
  settings: LoadedSettings;
  readonly bodies: (Body & BodyMotion)[];
  readonly ships: ShipView[];
  /** The client's own ship in `ships`, or null. */
  own: ShipView | null;
  /** Counters and gauges. */
  diagnosis: Diagnosis;
}

/** Counters and gauges, monotone unless said. */
export interface Diagnosis {
  framesAccepted: number;
  framesDuplicate: number;
  framesOutOfOrder: number;
  framesTooOld: number;
  framesFromFuture: number;
  framesRefused: number;
  /** Ships of accepted frames that could not be used, and why the last refusal, of a frame or of a ship, was. */
  shipsRefused: number;
  lastRefusal: string;
  /** False while the server has sent no hello: settings, classes and terrain are then the defaults, not what it told. */
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
  /** Acknowledgements of inputs that cannot be: later than their own frame, or of no number. */
  acknowledgementsRefused: number;
  /** Left out because the host did not take its outgoing messages. */
  pingsDropped: number;
  inputsDropped: number;
  /** Frames that newer ones overtook before they were decoded: their events were told, nothing else. */
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
  /** Arrival margin of the last acknowledged input. */
  margin: number;
  /**
   * How far the own ship's prediction was from the server's newest word for the same tick, m and rad, as seen from the body; NaN
   * where nothing was predicted for it.
   */
  errorPosition: number;
  errorAngle: number;
  /** Ships that are carried on now, not predicted by the law, and the states that came while one was. */
  shipsCarried: number;
  statesCarried: number;
  /** The server's ground above the drawn terrain under the own ship, m, and how sure that is, 0 … 1. */
  groundOffset: number;
  groundConfidence: number;
  /** Size of the offset being eased on the own ship, m and rad. */
  offsetPosition: number;
  offsetAngle: number;
}
