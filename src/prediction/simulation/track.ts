import { SHIP_STRIDE } from '../../dynamics';
import { createPicture, type Picture } from '../drawn/picture';
import { createLedger, type Ledger } from '../events/ledger';
import { createLawFit, type LawFit } from '../snapshots/reconcile/lawErrors';
import { createHistory, type History } from './rings/history';
import { createLearnedGround, type LearnedGround } from '../ground/learnedGround';
import { createLastState, type LastState } from '../ground/lastState';
import type { TouchdownRing } from '../touchdown/touchdownRing';
import type { ServerStates } from './rings/serverStates';

/** How a ship's present state is obtained. */
export type Mode =
  /** Simulated to the front, substep by substep. */
  | 'stepping'
  /** Landed, and the server agrees: constant in the body's axes, no substep. */
  | 'sleeping'
  /** No usable prediction: its replay has not reached the front yet. */
  | 'waiting'
  /** Not simulated: too fast to follow, or no server state for longer than the ring. Drawn at its last server state. */
  | 'held';

/** How a ship is drawn. */
export type Policy =
  /** Simulated to the present (the default). */
  | 'predict'
  /** Interpolated between the two server states around one send interval ago: smooth and late. */
  | 'interpolate'
  /** At its newest server state, turning with its body. */
  | 'hold';

/** The predictor's record of one ship. Its rows are in the fleet's arrays at `at`. */
export interface Track {
  readonly shipId: string;
  playerId: string;
  name: string;
  own: boolean;
  /** Offset of its row in each of the fleet's arrays. */
  at: number;
  mode: Mode;
  /** Switched off because time is faster than the budget allows. */
  off: boolean;
  /** The caller's choice of how it is drawn. */
  policy: Policy;
  /** Its last server states, under policy interpolate. */
  states: ServerStates | null;
  /** Its class or surface state is unknown: it is drawn from its server states. */
  unpredictable: boolean;

  history: History;
  /** Newest tick with a server state, -1 before the first; its row, and its body's attitude then. */
  serverTick: number;
  readonly serverRow: Float64Array;
  readonly serverBodyAttitude: Float64Array;
  /** Fields 33 and 34 were sent: comparable to the micrometre. */
  exact: boolean;
  /** Client wall s. */
  seenAt: number;
  /** How long the server was silent before its newest state, s. */
  silence: number;
  /** The last send (Cadence) that included it. */
  lastSend: number;
  /** Newest tick whose server state agreed with the prediction, -1 for none: NaN would make it a double, which V8 boxes. */
  agreedTick: number;

  /** Position of the replay in the fleet's `replayed` row. */
  replaying: boolean;
  replayTick: number;
  replaySubstep: number;
  /** Tick of the newest adopted state: history before it is of an abandoned prediction. */
  adoptedTick: number;
  /** The replay adopts a state that makes easing meaningless: respawned, or on another body. */
  replaySnaps: boolean;
  /** Numbers of the simulation passes of this ship: the front's, the replay's, and the last begun. */
  pass: number;
  replayPass: number;
  passes: number;

  /** Where another pilot's controls are released; -1 for nowhere. */
  releaseTick: number;
  releaseSubstep: number;

  /** The sleeping pose: position, m, and attitude, in the body's axes. */
  readonly sleepPlace: Float64Array;
  readonly sleepAttitude: Float64Array;

  readonly ledger: Ledger;
  /** The ground learned from its states, and the state to compare the next with. */
  readonly ground: LearnedGround;
  readonly evidence: LastState;
  /** Decides whether it is simulated by the dynamics or extrapolated. */
  readonly fit: LawFit;
  /** Of the player's ship; null for others. */
  log: TouchdownRing | null;
  /** Its drawn and shown state. The simulation does not read it. */
  readonly picture: Picture;
}

/** All ships: their tracks, and one row per ship in each of three arrays. */
export interface Fleet {
  /** The player's ship, once it is present. */
  own: Track | null;
  readonly tracks: Track[];
  readonly byId: Map<string, Track>;
  /** One substep before the front. */
  previous: Float64Array;
  /** At the front: the first substep boundary at or after the present. */
  front: Float64Array;
  /** Where replays are. */
  replayed: Float64Array;
}

export function createFleet(): Fleet {
  return {
    own: null,
    tracks: [],
    byId: new Map(),
    previous: new Float64Array(0),
    front: new Float64Array(0),
    replayed: new Float64Array(0),
  };
}

/** A new track at the end of the fleet. */
export function addTrack(fleet: Fleet, shipId: string, ringLength: number): Track {
  const at = fleet.tracks.length * SHIP_STRIDE;
  if (fleet.front.length < at + SHIP_STRIDE) grow(fleet);
  const track: Track = {
    shipId,
    playerId: '',
    name: '',
    own: false,
    at,
    mode: 'waiting',
    off: false,
    policy: 'predict',
    states: null,
    unpredictable: false,
    history: createHistory(ringLength),
    serverTick: -1,
    serverRow: new Float64Array(SHIP_STRIDE),
    serverBodyAttitude: Float64Array.of(0, 0, 0, 1),
    exact: false,
    seenAt: 0,
    silence: 0,
    lastSend: 0,
    agreedTick: -1,
    replaying: false,
    replayTick: 0,
    replaySubstep: 0,
    adoptedTick: 0,
    replaySnaps: false,
    pass: 0,
    replayPass: 0,
    passes: 0,
    releaseTick: -1,
    releaseSubstep: 0,
    sleepPlace: new Float64Array(3),
    sleepAttitude: Float64Array.of(0, 0, 0, 1),
    ledger: createLedger(shipId),
    ground: createLearnedGround(),
    evidence: createLastState(),
    fit: createLawFit(),
    log: null,
    picture: createPicture(),
  };
  fleet.tracks.push(track);
  fleet.byId.set(shipId, track);
  return track;
}

/** Removes all tracks. */
export function clearFleet(fleet: Fleet): void {
  fleet.own = null;
  fleet.tracks.length = 0;
  fleet.byId.clear();
}

/** Removes a track; the last one takes over its rows. */
export function removeTrack(fleet: Fleet, track: Track): void {
  const last = fleet.tracks.pop()!;
  fleet.byId.delete(track.shipId);
  if (fleet.own === track) fleet.own = null;
  if (last === track) return;
  for (const rows of [fleet.previous, fleet.front, fleet.replayed])
    rows.copyWithin(track.at, last.at, last.at + SHIP_STRIDE);
  last.at = track.at;
  fleet.tracks[track.at / SHIP_STRIDE] = last;
}

function grow(fleet: Fleet): void {
  const length = Math.max(8 * SHIP_STRIDE, fleet.front.length * 2);
  const grown = (rows: Float64Array) => {
    const next = new Float64Array(length);
    next.set(rows);
    return next;
  };
  fleet.previous = grown(fleet.previous);
  fleet.front = grown(fleet.front);
  fleet.replayed = grown(fleet.replayed);
}

/** Copies one row between two arrays. */
export function copyRow(to: Float64Array, toAt: number, from: Float64Array, fromAt: number): void {
  for (let k = 0; k < SHIP_STRIDE; k++) to[toAt + k] = from[fromAt + k]!;
}
