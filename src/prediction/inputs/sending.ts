import type { Controls } from '../../dynamics';
import type { ClientMessage, InputRecord } from '../../wire';
import type { Simulation } from '../simulation/simulation';
import { indexOf, spanOf } from '../time/timeline';
import { type StoredInput, takeUnsent } from './inputs';

/**
 * Schedules the sending of own inputs. A server of whole-tick inputs applies one record per tick, so a dragged throttle makes many records
 * with one stamp: the first is sent at once, later ones replace each other and are sent at intervals, and always before the stamp is
 * due.
 */
export interface Sending {
  /** Stamp of the newest record sent, and when it was sent, client wall s. */
  tick: number;
  substep: number;
  at: number;
}

/** Shortest time between two records with the same stamp, s: usually, and when the stamp is due soon. */
const SELDOM = 0.5;
const OFTEN = 0.05;
/** s before its time at which a stamp is due soon; within two display frames, the second value, nothing waits. */
const SOON = 0.1;
const AT_ONCE = 0.035;

export function createSending(): Sending {
  return { tick: -1, substep: 0, at: Number.NEGATIVE_INFINITY };
}

/** The records that are to be sent at client wall second `now`. */
export function takeInputs(sim: Simulation, sending: Sending, now: number): InputRecord[] {
  const records = takeUnsent(sim.inputs, (stored) => waits(sim, sending, stored, now));
  const newest = records.at(-1);
  if (newest !== undefined) {
    sending.tick = newest.tick;
    sending.substep = newest.substep;
    sending.at = now;
  }
  return records;
}

/** The controls after all of these messages; null if none has any. */
export function lastControls(messages: readonly ClientMessage[]): Controls | null {
  const inputs = messages.findLast((message) => message.kind === 'inputs');
  return inputs?.inputs.at(-1)?.controls ?? null;
}

function waits(sim: Simulation, sending: Sending, { record }: StoredInput, now: number): boolean {
  if (record.tick !== sending.tick || record.substep !== sending.substep) return false;
  const due = wallUntil(sim, record);
  if (due <= AT_ONCE) return false;
  return now - sending.at < (due <= SOON ? OFTEN : SELDOM);
}

/** Wall s until the front reaches a stamp. */
function wallUntil({ timeline, front }: Simulation, { tick, substep }: InputRecord): number {
  const substeps = indexOf(timeline, tick, substep) - indexOf(timeline, front.tick, front.substep);
  const { timing, timeScale } = spanOf(timeline, front.tick);
  return (substeps * timing.dt) / timeScale;
}
