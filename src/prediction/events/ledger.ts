import {
  EVENT_CONTACT,
  EVENT_DESTROYED,
  EVENT_LANDED,
  EVENT_NAMES,
  EVENT_RIGHTED,
  EVENT_TIPPED,
} from '../../dynamics';
import type { ShipEventName } from '../../dynamics';
import { indexOf, isBefore, type Timeline } from '../time/timeline';
import type { WorldEvent } from '../../wire';
import type { EventNotice } from '../drawn/view';

/**
 * The events of one ship, predicted and sent (PREDICTION, Events). An event keeps its identity through replays: the same type within 50
 * substeps is the same event, and listeners are called for each at most once as predicted, once as confirmed, once as retracted.
 */
export interface Ledger {
  readonly shipId: string;
  readonly entries: LedgerEntry[];
}

export interface LedgerEntry {
  readonly event: number;
  /** It happened at the end of this substep. */
  tick: number;
  substep: number;
  status: 'predicted' | 'confirmed' | 'retracted';
  /** The newest simulation pass that produced it: one pass never has an event twice. */
  pass: number;
}

/** Substeps within which two events of a type are the same one. */
const SAME_EVENT = 50;
/** Beyond this, no event is predicted until an entry is settled. */
const MAX_ENTRIES = 64;

export function createLedger(shipId: string): Ledger {
  return { shipId, entries: [] };
}

/** Records an event that the simulation produced in pass `pass`. Returns a notice if it is new. */
export function predict(
  ledger: Ledger,
  event: number,
  birth: { readonly tick: number; readonly substep: number },
  timeline: Timeline,
  pass: number,
): EventNotice | null {
  const known = nearest(
    ledger,
    event,
    birth,
    timeline,
    (entry) => entry.pass !== pass && entry.status !== 'retracted',
  );
  if (known !== null) {
    known.pass = pass;
    if (known.status === 'predicted') {
      known.tick = birth.tick;
      known.substep = birth.substep;
    }
    return null;
  }
  if (!makeRoom(ledger)) return null;
  return noticeOf(ledger, add(ledger, event, birth, pass));
}

/** A server event in the ledger's form; null if the dynamics have no such event, or without a substep. */
export function knownEvent({
  type,
  tick,
  substep,
}: WorldEvent): { event: number; tick: number; substep: number } | null {
  const event = (EVENT_NAMES as readonly string[]).indexOf(type);
  return event <= 0 || substep === null ? null : { event, tick, substep };
}

/** Records an event that the server sent. Returns a notice unless it was sent before. */
export function confirm(
  ledger: Ledger,
  event: number,
  birth: { readonly tick: number; readonly substep: number },
  timeline: Timeline,
): EventNotice | null {
  const isReported = (entry: LedgerEntry) =>
    entry.status === 'confirmed' && entry.tick === birth.tick && entry.substep === birth.substep;
  if (ledger.entries.some((entry) => entry.event === event && isReported(entry))) return null;
  const entry =
    nearest(ledger, event, birth, timeline, (candidate) => candidate.status === 'predicted') ??
    addConfirmed(ledger, event, birth);
  entry.status = 'confirmed';
  entry.tick = birth.tick;
  entry.substep = birth.substep;
  return noticeOf(ledger, entry);
}

/**
 * A frame of `tick` arrived: retracts the oldest predicted event that it covers with 50 substeps to spare and that no server event has
 * confirmed. Call until null.
 */
export function retract(ledger: Ledger, tick: number, timeline: Timeline): EventNotice | null {
  for (const entry of ledger.entries) {
    if (entry.status !== 'predicted') continue;
    if (indexOf(timeline, tick, 0) - indexOf(timeline, entry.tick, entry.substep) < SAME_EVENT) continue;
    entry.status = 'retracted';
    return noticeOf(ledger, entry);
  }
  return null;
}

/**
 * For a server that sends no events: confirms the oldest predicted event whose surface state the frame of `tick` has. Call until null.
 */
export function confirmByState(
  ledger: Ledger,
  tick: number,
  state: string,
  crashed: boolean,
): EventNotice | null {
  for (const entry of ledger.entries) {
    if (entry.status !== 'predicted' || !isBefore(entry.tick, entry.substep, tick, 0)) continue;
    if (crashed ? entry.event !== EVENT_DESTROYED : !(SHOWN_BY[entry.event] ?? []).includes(state)) continue;
    entry.status = 'confirmed';
    return noticeOf(ledger, entry);
  }
  return null;
}

/** Surface states that show that each event has happened. */
const SHOWN_BY: Readonly<Record<number, readonly string[]>> = {
  [EVENT_CONTACT]: ['contact', 'landed', 'tipped'],
  [EVENT_LANDED]: ['landed'],
  [EVENT_TIPPED]: ['tipped'],
  [EVENT_RIGHTED]: ['contact', 'landed'],
};

/** The pass that produced a prediction, and the tick at which the pass began. */
export interface PredictedBy {
  readonly pass: number;
  readonly fromTick: number;
}

/**
 * The server's state of `tick` agrees with the prediction: its events are confirmed, and those of abandoned passes are not. Settles the
 * oldest predicted event that the frame covers with 50 substeps to spare; null if there is none. Call until null.
 */
export function settleByAgreement(
  ledger: Ledger,
  tick: number,
  timeline: Timeline,
  by: PredictedBy,
): EventNotice | null {
  for (const entry of ledger.entries) {
    if (entry.status !== 'predicted' || entry.tick < by.fromTick) continue;
    if (indexOf(timeline, tick, 0) - indexOf(timeline, entry.tick, entry.substep) < SAME_EVENT) continue;
    entry.status = entry.pass === by.pass ? 'confirmed' : 'retracted';
    return noticeOf(ledger, entry);
  }
  return null;
}

/** Forgets entries that were settled before `tick`. */
export function pruneLedger(ledger: Ledger, tick: number): void {
  const { entries } = ledger;
  while (entries.length > 0 && entries[0]!.tick < tick && entries[0]!.status !== 'predicted') entries.shift();
}

function nearest(
  ledger: Ledger,
  event: number,
  birth: { readonly tick: number; readonly substep: number },
  timeline: Timeline,
  may: (entry: LedgerEntry) => boolean,
): LedgerEntry | null {
  const at = indexOf(timeline, birth.tick, birth.substep);
  let found: LedgerEntry | null = null;
  let least = SAME_EVENT;
  for (const entry of ledger.entries) {
    if (entry.event !== event || !may(entry)) continue;
    const apart = Math.abs(indexOf(timeline, entry.tick, entry.substep) - at);
    if (apart > least || (apart === least && found !== null)) continue;
    least = apart;
    found = entry;
  }
  return found;
}

function addConfirmed(
  ledger: Ledger,
  event: number,
  birth: { readonly tick: number; readonly substep: number },
): LedgerEntry {
  if (!makeRoom(ledger)) ledger.entries.shift();
  return add(ledger, event, birth, -1);
}

function add(
  ledger: Ledger,
  event: number,
  birth: { readonly tick: number; readonly substep: number },
  pass: number,
): LedgerEntry {
  const { tick, substep } = birth;
  const entry: LedgerEntry = { event, tick, substep, status: 'predicted', pass };
  ledger.entries.push(entry);
  return entry;
}

/** Whether there is room for one more: the oldest settled one is dropped. An unsettled one would be reported again by the next replay. */
function makeRoom({ entries }: Ledger): boolean {
  if (entries.length < MAX_ENTRIES) return true;
  const settled = entries.findIndex(({ status }) => status !== 'predicted');
  if (settled < 0) return false;
  entries.splice(settled, 1);
  return true;
}

function noticeOf(ledger: Ledger, entry: LedgerEntry): EventNotice {
  const { tick, substep, status: kind, event } = entry;
  return { kind, type: EVENT_NAMES[event] as ShipEventName, shipId: ledger.shipId, tick, substep };
}
