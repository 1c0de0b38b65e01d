import {
  CONTACT,
  CRASHED,
  FLYING,
  IMPACT_SPEED,
  POSITION,
  ATTITUDE,
  readControls,
  SURFACE_STATE,
  SURFACE_STATES,
  TIPPED,
  THRUST_LEVEL,
} from '../../dynamics';
import { take } from './rotation';
import type { Track } from '../simulation/track';
import type { Provenance, ShipView } from './view';
import { type Timeline, wallOfTick } from '../time/timeline';

/** The instant of a view. */
export interface Instant {
  /** Client wall s. */
  now: number;
  /** Server wall s of the present that is drawn. */
  present: number;
  /** Client wall s since the last view. */
  elapsed: number;
  /** Silence, s, after which a ship's state is stale. */
  staleAfter: number;
  /** s after a server state for which it confirms the drawn pose: until the next one is due, plus the lead. */
  confirms: number;
  paused: boolean;
  /** Where the bodies are is known. */
  bodiesKnown: boolean;
  /** Gives the server wall s of tick boundaries. */
  readonly timeline: Timeline;
  /** The last tick looked up in this view, and its wall s: most ships arrive in one frame. */
  serverTick: number;
  serverWall: number;
}

/** Shortest time for which CONTACT is shown, s. */
const CONTACT_DWELL = 0.3;
/** m/s: a slower rebound is no bounce. */
const HOP = 0.3;
/** Consecutive sends without a ship after which its state is stale. */
const STALE_SENDS = 2;

/**
 * A ship's shown state and its provenance (PREDICTION, Shown state).
 * @param rows holds the state at the present at `from`
 */
export function fillStatus(out: ShipView, track: Track, rows: Float64Array, from: number, at: Instant): void {
  const { status } = track.picture;
  const state = surfaceStateOf(track, rows, from);
  if (status.state !== state) {
    if (state === CONTACT) status.contactUntil = at.now + CONTACT_DWELL;
    status.state = state;
    status.since = at.present;
  }
  const crashes = rows[from + CRASHED] === 1;
  out.shownState = shownState(track, state, crashes, at);
  out.provenance = provenanceOf(out, track, crashes, at);
  const age = at.present - (out.provenance === 'predicted' ? status.since : status.serverWall);
  out.age = age > 0 ? age : 0;
  out.withdrawn = at.now < status.withdrawnUntil ? status.withdrawn : '';
}

/**
 * The predicted surface state; for a touch that bounces where the dynamics keep the ship on the ground, flight until the server's states
 * end it.
 */
export function surfaceStateOf({ fit, serverRow }: Track, rows: Float64Array, from: number): number {
  const bounces = fit.bounces && fit.rebound * rows[from + IMPACT_SPEED]! > HOP;
  return bounces && serverRow[SURFACE_STATE] === FLYING ? FLYING : rows[from + SURFACE_STATE]!;
}

/** Fills in the ship's newest server state, for its ghost, if there is a newer one. Returns whether there is. */
export function fillServerState(out: ShipView, track: Track, at: Instant): boolean {
  if (track.picture.status.serverTick === track.serverTick) return false;
  track.picture.status.serverTick = track.serverTick;
  if (at.serverTick !== track.serverTick) {
    at.serverTick = track.serverTick;
    at.serverWall = wallOfTick(at.timeline, track.serverTick);
  }
  track.picture.status.serverWall = at.serverWall;
  out.serverKnown = track.serverTick >= 0;
  take(out.serverPosition, track.serverRow, POSITION);
  take(out.serverAttitude, track.serverRow, ATTITUDE);
  return true;
}

/** CONTACT dwells only in the shown state, never in the simulated one. A crash is final once the server confirms it. */
function shownState(track: Track, state: number, crashes: boolean, at: Instant): ShipView['shownState'] {
  if (track.serverRow[CRASHED] === 1 && (crashes || track.policy === 'predict')) return 'crashed';
  if (crashes) return 'contact';
  if (state !== TIPPED && at.now < track.picture.status.contactUntil) return 'contact';
  return SURFACE_STATES[state]!;
}

function provenanceOf(out: ShipView, track: Track, crashes: boolean, at: Instant): Provenance {
  if (track.off || track.unpredictable) return 'off';
  const crashed = track.serverRow[CRASHED] === 1;
  const silent = at.now - track.seenAt > at.staleAfter || out.missingSends >= STALE_SENDS;
  if (!at.paused && !crashed && silent) return 'stale';
  if (crashed) return 'confirmed';
  if (!at.bodiesKnown && !track.exact) return 'predicted';
  if (track.policy !== 'predict') return 'confirmed';
  const { state, serverWall } = track.picture.status;
  if (!at.paused && at.present - serverWall > at.confirms) return 'predicted';
  const { fit, serverRow } = track;
  const agrees = serverRow[SURFACE_STATE] === state && !crashes && fit.extrapolated === '' && !fit.bounces;
  return agrees ? 'confirmed' : 'predicted';
}

/** Creates a new record only if a command has changed. */
export function fillControls(out: ShipView, commands: Float64Array, rows: Float64Array, from: number): void {
  const at = from + THRUST_LEVEL;
  for (let k = 0; k < commands.length; k++) {
    if (commands[k] === rows[at + k]) continue;
    take(commands, rows, at);
    out.controls = readControls(rows, from);
    return;
  }
}
