import type { Controls, Result } from '../../dynamics';
import type { ClientMessage, PartialFrame, PendingMessage, ServerMessage } from '../../wire';
import type { EventNotice, WorldView } from '../drawn/view';
import type { PredictorSnapshot } from '../lifecycle/snapshot';
import type { Defaults } from '../options';
import type { Removal } from '../ownership';
import type { Policy } from '../simulation/track';

/**
 * Server states + own controls → the present pose (PREDICTION). `now` is an argument, in monotonic wall seconds; nothing reads a clock,
 * and nothing that a server or a pilot sends makes it throw.
 */
export interface LeanPredictor {
  /** Receives a checked message of the server; a frame needs only tick and ships. */
  receive: (message: ServerMessage | PartialFrame, now: number) => void;
  /** Reports a frame that the wire refused; it is counted, and the diagnosis keeps its reason. */
  refused: (reason: string) => void;
  /** Called once per display frame: samples own controls (null for a spectator, or without input) and simulates up to the present. Controls that are not finite are ignored. */
  advance: (controls: Controls | null, now: number) => void;
  /** The world at the present; one record, valid until the next call. */
  view: (now: number) => WorldView;
  /** The messages to send since the last call. */
  takeOutgoing: () => ClientMessage[];
  /**
   * For a server of the game's JSON, instead of takeOutgoing: the controls to send since the last call (encodeControlsJson), or null
   * when nothing has changed. Pings are left to the connection.
   */
  takeControls: () => Controls | null;
  /** Predicted, confirmed and retracted events, in order, during `receive` and `advance`. Returns a function that stops listening. */
  onEvent: (listener: (notice: EventNotice) => void) => () => void;
  /** Makes `shipId` the player's ship; null for a spectator. Inputs made for the previous ship are dropped, never sent for this one. */
  setOwnShip: (shipId: string | null) => void;
  /** Removes the ship from the view at once. A later frame that has it restores it. */
  removeShip: (shipId: string, reason: Removal) => void;
  /** Announces that the server moves the ship elsewhere: its next state is shown at once and counts as no error. */
  teleported: (shipId: string) => void;
  /** Clears ships, time, inputs and the clock, as for another server of the same world. The player's ship and listeners stay. */
  reset: () => void;
  /** Releases everything, listeners too; later calls do nothing. */
  dispose: () => void;
}

/** A predictor with all features; `createLeanPredictor` creates a smaller one. */
export interface Predictor extends LeanPredictor {
  /**
   * Receives an undecoded message of the server (pendingServerMessage of wire): the next `advance` decodes it, unless newer frames
   * supersede it. For a page that may be hidden while hundreds of ships are sent.
   */
  receivePending: (message: PendingMessage, now: number) => void;
  /**
   * Sets how the ship is drawn, present or not: simulated to the present (`predict`, the default), between its
   * server states about one send ago (`interpolate`), or where its newest server state has it (`hold`). The change is
   * eased. A ship that is not predicted has no predicted events and is `confirmed` or `stale`.
   */
  setPolicy: (shipId: string, policy: Policy) => void;
  /**
   * Changes settings (member by member), ship classes, terrain or bodies while running. Ships, time, inputs and listeners stay, and each
   * ship continues from its newest server state; only another list of body names begins a new world. A hello with other values does the
   * same. An error names the invalid field, and nothing changes.
   */
  configure: (changes: Partial<Defaults>) => Result<null>;
  /** The last messages as plain data for JSON.stringify, to continue from after a reload or in a worker. */
  snapshot: (now: number) => PredictorSnapshot;
  /** Continues from a snapshot, as if its frame had arrived `age` s ago; or returns an error that names the invalid field, and nothing changes. */
  restore: (snapshot: unknown, now: number) => Result<null>;
}
