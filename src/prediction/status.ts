import {
  CONTACT,
  CRASHED,
  EVENT_NAMES,
  POSITION,
  ATTITUDE,
  readControls,
  SURFACE_STATE,
  SURFACE_STATES,
  TIPPED,
  THRUST_LEVEL,
} from '../dynamics';
import { take } from './rotation';
import type { Simulation } from './simulation';
import { wallOfTick } from './timeline';
import type { Track } from './track';
import type { Provenance, ShipView } from './view';

/** The instant a view is of. */
export interface Instant {
  /** Client wall s. */
  now: number;
  /** Server wall s of the present that is drawn. */
  present: number;
  /** Client wall s since the last view. */
  elapsed: number;
  /** Hz */
  tickRate: number;
  paused: boolean;
}

/** Least time for which CONTACT is shown once it is, s. */
const CONTACT_DWELL = 0.3;
/** A withdrawn prediction is told for this long, s. */
export const WITHDRAWN_SHOWN = 2;
/** Silent for two ticks, and at fast servers for this long, a ship's state is stale, s: a stall of a mobile link alone is 0.2 s. */
const STALE_AFTER = 0.3;
/** Ticks without a state after which a ship's state is stale. */
const STALE_TICKS = 2;

/** What is shown of a ship's states, and how far it can be trusted (PREDICTION, States and events as predicted things). */
export function fillStatus(
  out: ShipView,
  sim: Simulation,
  track: Track,
  shown: { readonly row: Float64Array; readonly at: Instant },
): void {
  const { status } = track;
  const { row, at } = shown;
  const state = row[SURFACE_STATE]!;
  if (status.state !== state) {
    if (state === CONTACT) status.contactUntil = at.now + CONTACT_DWELL;
    status.state = state;
    status.since = at.present;
  }
  fillControls(out, status.commands, row);
  out.serverKnown = track.serverTick >= 0;
  take(out.serverPosition, track.serverRow, POSITION);
  take(out.serverAttitude, track.serverRow, ATTITUDE);
  out.missingTicks = sim.newestTick - track.serverTick;
  out.shownState = shownState(track, row, at);
  out.provenance = provenanceOf(track, row, at);
  const since = out.provenance === 'predicted' ? status.since : wallOfTick(sim.timeline, track.serverTick);
  out.age = Math.max(0, at.present - since);
  const withdrawn = at.now < status.withdrawnUntil ? EVENT_NAMES[status.withdrawn]! : '';
  out.withdrawn = withdrawn === '' ? '' : (withdrawn.slice('ship.'.length) as ShipView['withdrawn']);
}

/** Simulation state is never dwelled: only what is shown. A crash is final once the server says so. */
function shownState(track: Track, row: Float64Array, at: Instant): ShipView['shownState'] {
  if (track.serverRow[CRASHED] === 1) return 'crashed';
  const state = row[SURFACE_STATE]!;
  if (row[CRASHED] === 1) return 'contact';
  if (state !== TIPPED && at.now < track.status.contactUntil) return 'contact';
  return SURFACE_STATES[state]!;
}

function provenanceOf(track: Track, row: Float64Array, at: Instant): Provenance {
  if (track.off) return 'off';
  const crashed = track.serverRow[CRASHED] === 1;
  const silent = at.now - track.seenAt;
  if (!at.paused && !crashed && silent > Math.max(STALE_TICKS / at.tickRate, STALE_AFTER)) return 'stale';
  if (crashed) return 'confirmed';
  const told = track.serverRow[SURFACE_STATE] === row[SURFACE_STATE] && row[CRASHED] === 0;
  // A flight is confirmed as a flight: nothing of it has a name that could be wrong.
  return told ? 'confirmed' : 'predicted';
}

/** A new record only where a command has changed. */
function fillControls(out: ShipView, commands: Float64Array, row: Float64Array): void {
  let same = true;
  for (let k = 0; k < commands.length; k++) if (commands[k] !== row[THRUST_LEVEL + k]) same = false;
  if (same) return;
  for (let k = 0; k < commands.length; k++) commands[k] = row[THRUST_LEVEL + k]!;
  out.controls = readControls(row, 0);
}
