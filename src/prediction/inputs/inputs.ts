import { type Controls, NEUTRAL_CONTROLS } from '../../dynamics';
import type { InputAcknowledgement, InputRecord, StateControls } from '../../wire';
import { isBefore, type Position } from '../time/timeline';
import { sameControls } from './command';

/**
 * Own controls as records (PREDICTION, Inputs): sampled once, stored, sent as stored, and applied by client and server at
 * the same substep. The server's acknowledgements override them.
 */
export interface Inputs {
  /** Scheduled inputs of the player's ship until the first record acts; ascending in time, cleared once they are long past. */
  plan: readonly ScheduledInput[];
  readonly records: StoredInput[];
  /** Index of the first record that has not been sent. */
  unsent: number;
  nextSeq: number;
  /** The server acknowledges inputs. Servers of the game's own kind do not. */
  acknowledges: boolean;
  /** Highest sequence number known to be applied. */
  applied: number;
  /** Dropped records of a lost connection, never acknowledged. */
  lostUpTo: number;
  /** Records dropped because the host did not take them: MAX_RECORDS. */
  dropped: number;
}

/** Controls from the start of a substep on, known to client and server beforehand. */
export type ScheduledInput = Omit<InputRecord, 'seq'>;

export interface StoredInput {
  readonly record: InputRecord;
  /** When it acts, as far as is known: at its stamp or later. */
  tick: number;
  substep: number;
  /** Client wall s. */
  readonly sampledAt: number;
  /** Steering of the lead at its sampling, s. */
  readonly steer: number;
}

/** Result of a frame's acknowledgement. */
export type InputOutcome = 'asPredicted' | 'late' | 'lost';

/** Most records: slightly more than 10 s at 100 changes per second. */
const MAX_RECORDS = 1024;
/** An input unacknowledged for longer than this after it was due counts as lost, wall s. */
const LOST_AFTER = 2;

export function createInputs(plan: readonly ScheduledInput[] = []): Inputs {
  return {
    plan,
    records: [],
    unsent: 0,
    nextSeq: 1,
    acknowledges: false,
    applied: 0,
    lostUpTo: 0,
    dropped: 0,
  };
}

/** Stores checked `controls` from (tick, substep) on. */
export function store(
  inputs: Inputs,
  controls: Controls,
  stamp: Position,
  sampledAt: number,
  steer: number,
): StoredInput {
  const last = inputs.records.at(-1);
  // Not before the previous record: records act in the order of their numbers.
  const early = last !== undefined && isBefore(stamp.tick, stamp.substep, last.tick, last.substep);
  const tick = early ? last.tick : stamp.tick;
  const substep = early ? last.substep : stamp.substep;
  // The last record has the same stamp and is not sent yet: replace it under the same number.
  if (
    last !== undefined &&
    inputs.unsent < inputs.records.length &&
    last.tick === tick &&
    last.substep === substep
  ) {
    const replaced = { ...last, record: { ...last.record, controls } };
    inputs.records[inputs.records.length - 1] = replaced;
    return replaced;
  }
  const record: InputRecord = { seq: inputs.nextSeq++, tick, substep, controls };
  const stored: StoredInput = { record, tick, substep, sampledAt, steer };
  inputs.records.push(stored);
  if (inputs.records.length > MAX_RECORDS) {
    if (inputs.unsent === 0) inputs.dropped += 1;
    drop(inputs, 1);
  }
  return stored;
}

/** The unsent records, except those that may still be replaced according to `waits`; they count as sent from now on. */
export function takeUnsent(
  inputs: Inputs,
  waits: (stored: StoredInput) => boolean = sendsAll,
): InputRecord[] {
  const { records } = inputs;
  const newest = records.at(-1);
  const held = newest !== undefined && inputs.unsent < records.length && waits(newest) ? 1 : 0;
  const sent = records.slice(inputs.unsent, records.length - held).map((stored) => stored.record);
  inputs.unsent = records.length - held;
  return sent;
}

const sendsAll = (): boolean => false;

/** After a reconnect, unacknowledged records may not have arrived and are sent again as stored. */
export function resend(inputs: Inputs): void {
  const first = inputs.records.findIndex((stored) => stored.record.seq > inputs.applied);
  inputs.unsent = first < 0 ? inputs.records.length : first;
}

/**
 * Applies the frame of `tick`: acknowledged records act when it says. Records that were due before and are not acknowledged are late and
 * act from the frame's boundary on, the earliest possible time.
 * @param acknowledgement the acknowledgement, or null if the server sends none
 * @param inForce the ship's controls in that frame
 */
export function acknowledge(
  inputs: Inputs,
  tick: number,
  acknowledgement: InputAcknowledgement | null,
  inForce: StateControls,
  now: number,
): InputOutcome {
  if (acknowledgement !== null) inputs.acknowledges = true;
  if (!inputs.acknowledges) return inferApplied(inputs, tick, inForce, now);
  return settle(inputs, tick, acknowledgement, now);
}

/** The same for a server that does not acknowledge inputs: the ship's controls `inForce` show which were applied. */
export function inferApplied(
  inputs: Inputs,
  tick: number,
  inForce: StateControls,
  now: number,
): InputOutcome {
  return settle(inputs, tick, inferred(inputs, tick, inForce), now);
}

function settle(inputs: Inputs, tick: number, last: InputAcknowledgement | null, now: number): InputOutcome {
  let outcome: InputOutcome = 'asPredicted';
  if (last !== null && last.seq > inputs.applied) {
    const stored = inputs.records.find((candidate) => candidate.record.seq === last.seq);
    if (stored !== undefined && (stored.tick !== last.tick || stored.substep !== last.substep)) {
      outcome = 'late';
      stored.tick = last.tick;
      stored.substep = last.substep;
    }
    inputs.applied = last.seq;
  }
  return delayUnapplied(inputs, tick, now) ?? outcome;
}

/** Moves late records to the start of `tick`; drops those overdue for too long. */
function delayUnapplied(inputs: Inputs, tick: number, now: number): InputOutcome | null {
  let outcome: InputOutcome | null = null;
  for (let i = inputs.records.length - 1; i >= 0; i--) {
    const stored = inputs.records[i]!;
    if (stored.record.seq <= inputs.applied) break;
    if (!isBefore(stored.tick, stored.substep, tick, 0)) continue;
    if (now - stored.sampledAt > LOST_AFTER + 1) {
      inputs.lostUpTo = Math.max(inputs.lostUpTo, stored.record.seq);
      dropIndex(inputs, i);
      outcome = 'lost';
    } else {
      stored.tick = tick;
      stored.substep = 0;
      outcome ??= 'late';
    }
  }
  return outcome;
}

/** The newest record due before `tick` whose controls are in force there: without acknowledgements, the server must have applied it. */
function inferred(inputs: Inputs, tick: number, inForce: StateControls): InputAcknowledgement | null {
  for (let i = inputs.records.length - 1; i >= 0; i--) {
    const stored = inputs.records[i]!;
    if (stored.record.seq <= inputs.applied) return null;
    if (!isBefore(stored.tick, stored.substep, tick, 0)) continue;
    if (!sameControls(stored.record.controls, inForce)) continue;
    return { seq: stored.record.seq, tick: stored.tick, substep: stored.substep, margin: 0 };
  }
  return null;
}

/** Drops records that acted before `tick`, except the newest. */
export function prune(inputs: Inputs, tick: number): void {
  let n = 0;
  while (
    n < inputs.records.length - 1 &&
    inputs.records[n]!.tick < tick &&
    inputs.records[n]!.record.seq <= inputs.applied
  )
    n++;
  if (n > 0) drop(inputs, n);
}

/** Drops all records: their ticks are of another timeline. */
export function forgetRecords(inputs: Inputs): void {
  if (inputs.records.length > 0) inputs.plan = [];
  inputs.records.length = 0;
  inputs.unsent = 0;
}

function drop(inputs: Inputs, count: number): void {
  // The record that ended the plan is dropped, so the plan is dropped too.
  inputs.plan = [];
  inputs.records.splice(0, count);
  inputs.unsent = Math.max(0, inputs.unsent - count);
}

function dropIndex(inputs: Inputs, index: number): void {
  inputs.records.splice(index, 1);
  if (inputs.unsent > index) inputs.unsent -= 1;
}

/** The controls with all keys released: sticks centred, the throttle lever unchanged. */
export function releaseKeys(controls: Controls): Controls {
  const { rotationInput, translationInput } = NEUTRAL_CONTROLS;
  return { ...controls, rotationInput, translationInput };
}
