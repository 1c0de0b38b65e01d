import type { BodyMotion, TerrainHeight, World, writeBodyMotion } from '../../dynamics';
import type { InputAcknowledgement, PartialFrame, ServerFrame, StateControls } from '../../wire';
import type { Diagnosis, EventNotice } from '../drawn/view';
import type { ReceivedState } from '../ground/lastState';
import type * as unknownGround from '../ground/unknownGround';
import type { InputOutcome, Inputs } from '../inputs/inputs';
import type * as bodySpin from '../snapshots/bodies/bodySpin';
import type { BodySpin } from '../snapshots/bodies/bodySpin';
import type { BodyTrack } from '../snapshots/bodies/bodyTrack';
import type * as checkedRecords from '../snapshots/checkedRecords';
import type { gameTimeScale } from '../snapshots/tempo/gameTimeMeter';
import type { Receiver } from '../snapshots/receiver';
import type { describeDifference, Place } from '../snapshots/reconcile/compare';
import type { holdLaw, ComparedState } from '../snapshots/reconcile/lawErrors';
import type { NewestState } from '../snapshots/snapshotContext';
import type { loadUntrusted } from '../lifecycle/worldConfig';
import type { Cadence } from '../time/cadence';
import type { Position, Timeline } from '../time/timeline';
import type * as touchdownLog from '../touchdown/touchdownLog';
import type * as touchdownRing from '../touchdown/touchdownRing';
import type { Warn } from '../warnings';
import type { rowsWithin } from './rings/history';
import type { Fleet, Track } from './track';
import type { RowStep } from './rowStep';

/** Takes a part of a frame that was received at client wall second `now`. */
type TakeFrame = (sim: Simulation, receiver: Receiver, frame: ServerFrame) => void;
type TakeFrameAt = (sim: Simulation, receiver: Receiver, frame: ServerFrame, now: number) => void;
type TimeFrame<Frame> = (sim: Simulation, receiver: Receiver, frame: Frame, now: number) => number | null;

/** The optional parts of a predictor, as the simulation calls them. */
export interface Features {
  /** Learns from states; the next three and `spin` need it. */
  readonly learning?: {
    readonly learnFrom: (sim: Simulation, track: Track, newest: NewestState) => boolean;
    readonly holdLaw: typeof holdLaw;
  };
  readonly learnGround?: (sim: Simulation, track: Track, received: ReceivedState) => void;
  readonly chooseMotion?: (sim: Simulation, track: Track, compared: ComparedState) => boolean;
  /** Ground that the client has not loaded. */
  readonly unknownGround?: {
    readonly knowsGround: typeof unknownGround.knowsGround;
    readonly withoutGround: typeof unknownGround.withoutGround;
  };
  /** Extrapolates a ship. */
  readonly extrapolate?: (step: RowStep, sim: Simulation, track: Track) => void;
  /** The impact speed of a contact that was not predicted. */
  readonly replayImpact?: (sim: Simulation, track: Track, state: TickedRow) => number;
  readonly sleep?: Sleep;
  readonly touchdown?: {
    readonly rewindLog: (track: Track, sim: Simulation, to: touchdownRing.Adopted) => void;
    readonly keepLog: typeof touchdownRing.keepLog;
    readonly forgetLogsAfter: typeof touchdownRing.forgetLogsAfter;
    readonly resizeLogs: typeof touchdownRing.resizeLogs;
    readonly logLanded: typeof touchdownRing.logLanded;
    readonly logSubstep: typeof touchdownLog.logSubstep;
    readonly fillTouchdown: typeof touchdownLog.fillTouchdown;
  };
  /** Predicted, sent and settled events. */
  readonly events?: {
    readonly recordPredicted: (
      sim: Simulation,
      track: Track,
      event: number,
      at: Position,
      pass: number,
    ) => void;
    readonly confirmEvents: TakeFrame;
    readonly settleEvents: TakeFrameAt;
    readonly confirmEnd: (sim: Simulation, track: Track) => void;
  };
  /** Bounds the memory of many ships' predicted states. */
  readonly rowsWithin?: typeof rowsWithin;
  /** Completes a frame's bodies. */
  readonly completeBodies?: (
    sim: Simulation,
    receiver: Receiver,
    frame: ServerFrame,
  ) => readonly BodyMotion[] | null;
  /** Checks records that no decoder of this library made. */
  readonly records?: {
    readonly tickFault: typeof checkedRecords.tickFault;
    readonly recordsOf: typeof checkedRecords.recordsOf;
    readonly isPlaced: typeof checkedRecords.isPlaced;
    readonly shipFault: (given: unknown) => string | null;
    readonly loadUntrusted: typeof loadUntrusted;
    readonly writeBodyMotion: typeof writeBodyMotion;
  };
  /** Snapshots in parts. */
  readonly parts?: {
    readonly takeShips: TakeFrame;
    readonly takeOlder: TakeFrameAt;
    readonly takePart: TakeFrameAt;
    readonly receiveRest: (sim: Simulation, receiver: Receiver) => void;
  };
  /** Acknowledged inputs; without, the controls in the states show which were applied. */
  readonly acknowledgements?: {
    readonly acknowledgementOf: (sim: Simulation, frame: PartialFrame) => InputAcknowledgement | null;
    readonly applyAcknowledgement: (
      sim: Simulation,
      receiver: Receiver,
      inForce: StateControls,
    ) => InputOutcome;
  };
  /** Both values of a field that differed. */
  readonly describeDifference?: typeof describeDifference;
  readonly gameTimeScale?: typeof gameTimeScale;
  /** The tick rate of a server that does not send it. */
  readonly tickRates?: {
    readonly measureUnsentRate: TimeFrame<PartialFrame>;
    readonly sentUntimed: TimeFrame<ServerFrame>;
  };
  readonly spin?: {
    readonly createBodySpin: typeof bodySpin.createBodySpin;
    readonly spunMotion: typeof bodySpin.spunMotion;
    readonly measureByShip: typeof bodySpin.measureByShip;
  };
  /** Keeps a state of a ship that is interpolated. */
  readonly keepServerState?: (sim: Simulation, track: Track, row: Float64Array, at: Boundary) => void;
  /** By the name in the hello; without them only flat ground. */
  readonly terrains?: Readonly<Record<string, TerrainHeight>>;
  /** The test mode, at each tick boundary that the front passes. */
  readonly checkRollback?: (sim: Simulation, tick: number) => void;
}

/**
 * The simulation: all ships at one front, the first substep boundary at or after the drawn present. Plain data, owned by the predictor;
 * the functions of this folder work on it.
 */
export interface Simulation {
  world: World;
  /** The world for a flying ship above unknown ground. */
  groundless: World;
  readonly timeline: Timeline;
  bodies: BodyTrack;
  /** False once game time that was not sent passed while no bodies were sent: where they are is unknown until a frame has them. */
  bodiesKnown: boolean;
  /** The measured spin of each body, in the world's order. */
  readonly spins: readonly BodySpin[];
  readonly fleet: Fleet;
  /** Of the ships in step with the front, and of the ship that is replayed: each pass places it again. */
  readonly steps: { readonly front: RowStep; readonly replay: RowStep };
  readonly inputs: Inputs;
  readonly front: Position;
  /** The timeline changed or jumped: the front must move to the present, and every ship be replayed to it. */
  frontIsStale: boolean;
  /** 0 … 1: where the present lies between the substep boundary before the front and the front. */
  alpha: number;
  /** Ticks of predicted states in 10 s. */
  ringLength: number;
  /** Rows that each ship besides the player’s keeps, as memory allows. */
  historyRows: number;
  /** How often the server sends. */
  readonly cadence: Cadence;
  /** Tick of the newest accepted frame, -1 before the first. */
  newestTick: number;
  /** Not yet passed to listeners. */
  readonly notices: EventNotice[];
  /** Substeps spent in the frame of `tick` on fitting the ground of other pilots' ships. */
  readonly learning: { tick: number; spent: number };
  readonly features: Features;
  readonly counters: Diagnosis;
  /** Reports mistakes of the caller or the server; nothing stops. */
  readonly warn: Warn;
  /** Landed ships that agree with the server sleep; null without the feature, as while rollbacks are forced. */
  readonly sleep: Sleep | null;
}

/** The sleep of landed ships (sleep.ts). */
export interface Sleep {
  readonly sleepIfAtRest: (sim: Simulation, track: Track, bodies: Float64Array) => boolean;
  readonly sleepAtFirst: (sim: Simulation, track: Track, bodies: Float64Array) => void;
  readonly sleepsOn: (sim: Simulation, track: Track, bodies: Float64Array) => boolean;
  readonly sleepsThrough: (track: Track, sent: Float64Array) => boolean;
  readonly placeAsleep: (place: Place, sim: Simulation, track: Track, at: Boundary) => Place | null;
  readonly holdSleeping: (track: Track) => void;
  readonly wakeIfBurning: (sim: Simulation, track: Track, commanded: Float64Array) => boolean;
  readonly writeSleeping: (
    rows: Float64Array,
    at: number,
    track: Track,
    attitude: Float64Array,
    spin: Float64Array,
  ) => void;
}

/** The boundary of a tick, and where the bodies are at it. */
export interface Boundary {
  readonly tick: number;
  readonly bodies: Float64Array;
}

/** A ship's state at a tick. */
export interface TickedRow {
  readonly row: Float64Array;
  readonly tick: number;
}
