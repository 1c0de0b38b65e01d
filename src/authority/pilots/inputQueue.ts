import { loadControls, writeControls } from '../../dynamics';
import type { InputAcknowledgement, InputRecord } from '../../wire';
import type { Counters } from './counters';

/** Inputs one player can have waiting: ten wall seconds at 0.1 Hz with a change every 10 ms, twice over. */
export const MAX_QUEUED = 2048;
/** Most substeps of a tick: 1,000 s, at 0.1 Hz and time scale 100. */
const MAX_SUBSTEPS = 100_000;
/** Wall seconds an input may be ahead, in addition to one tick. */
const MAX_AHEAD = 10;

/** An input that waits for its substep. */
interface QueuedInput {
  readonly record: InputRecord;
  /** When it is due: at its stamp, or at the next whole tick under granularity 'tick'. */
  readonly tick: number;
  readonly substep: number;
  /** Wall seconds. */
  readonly arrivedAt: number;
}

/** The inputs of one player. */
export interface InputQueue {
  /** Ordered by due time. */
  readonly queue: QueuedInput[];
  /** Sequence number of the input applied last; 0 before the first. */
  lastSeq: number;
  lastInput: InputAcknowledgement | null;
  /** No input has arrived since the player joined. */
  fresh: boolean;
}

/** The server's present when an input arrives or is due. */
export interface Present {
  readonly tick: number;
  /** Hz */
  readonly tickRate: number;
  readonly granularity: 'substep' | 'tick';
  /** Wall seconds at which the interval of a tick was or will be simulated. */
  readonly simulatedAt: (tick: number) => number;
}

export function createInputQueue(): InputQueue {
  return { queue: [], lastSeq: 0, lastInput: null, fresh: true };
}

/** Queues the inputs of one message. Returns the reason of the first refusal, or null; the other inputs are queued either way. */
export function queueInputs(
  player: InputQueue,
  counters: Counters,
  inputs: readonly InputRecord[],
  present: Present,
  now: number,
): string | null {
  let reason: string | null = null;
  for (const [i, record] of inputs.entries()) {
    // A reloaded page numbers its inputs from 1 again; a page that reconnects continues its count.
    if (player.fresh && record.seq === 1) player.lastSeq = 0;
    player.fresh = false;
    const refusal = queueInput(player, counters, record, present, now);
    if (refusal !== null) reason ??= `inputs[${i}].${refusal}`;
  }
  return reason;
}

function queueInput(
  player: InputQueue,
  counters: Counters,
  record: InputRecord,
  present: Present,
  now: number,
): string | null {
  const malformed = malformedField(record);
  const controls = loadControls(record.controls);
  if (malformed !== null || !controls.ok) {
    counters.inputsMalformed++;
    return malformed ?? (controls.ok ? null : `controls.${controls.reason}`);
  }
  if (record.seq <= player.lastSeq || player.queue.some((queued) => queued.record.seq === record.seq)) {
    counters.inputsDuplicate++;
    return null;
  }
  const latest = present.tick + 1 + Math.ceil(MAX_AHEAD * present.tickRate);
  if (record.tick > latest) {
    counters.inputsFromFuture++;
    return `tick: expected at most ${latest}, got ${record.tick}`;
  }
  if (player.queue.length >= MAX_QUEUED) {
    counters.inputsFlooded++;
    return `seq: ${MAX_QUEUED} inputs are waiting already`;
  }
  const wholeTick = present.granularity === 'tick' && record.substep > 0;
  insert(player.queue, {
    record: { ...record, controls: controls.value },
    tick: wholeTick ? record.tick + 1 : record.tick,
    substep: present.granularity === 'tick' ? 0 : record.substep,
    arrivedAt: now,
  });
  return null;
}

/**
 * Writes the inputs that are due at the start of substep `when.substep` of the present interval into the ship's row.
 * @returns whether there were any
 */
export function applyDue(
  player: InputQueue,
  counters: Counters,
  ship: { readonly rows: Float64Array; readonly at: number },
  when: Present & { readonly substep: number },
): boolean {
  const { queue } = player;
  const before = player.lastSeq;
  let due = 0;
  while (due < queue.length && isDue(queue[due]!, when)) due++;
  for (const queued of queue.splice(0, due)) {
    const { record } = queued;
    if (record.seq <= player.lastSeq) {
      counters.inputsSuperseded++;
      continue;
    }
    counters.inputsApplied++;
    if (queued.tick !== when.tick || queued.substep !== when.substep) counters.inputsLate++;
    writeControls(ship.rows, ship.at, record.controls);
    player.lastSeq = record.seq;
    player.lastInput = {
      seq: record.seq,
      tick: when.tick,
      substep: when.substep,
      margin: when.simulatedAt(queued.tick) - queued.arrivedAt,
    };
  }
  return player.lastSeq !== before;
}

function isDue(queued: QueuedInput, when: { tick: number; substep: number }): boolean {
  return queued.tick < when.tick || (queued.tick === when.tick && queued.substep <= when.substep);
}

function insert(queue: QueuedInput[], queued: QueuedInput): void {
  let i = queue.length;
  while (i > 0 && isAfter(queue[i - 1]!, queued)) i--;
  queue.splice(i, 0, queued);
}

function isAfter(a: QueuedInput, b: QueuedInput): boolean {
  if (a.tick !== b.tick) return a.tick > b.tick;
  if (a.substep !== b.substep) return a.substep > b.substep;
  return a.record.seq > b.record.seq;
}

function malformedField({ seq, tick, substep }: InputRecord): string | null {
  const malformed = notWhole('seq', seq, 1) ?? notWhole('tick', tick, 0) ?? notWhole('substep', substep, 0);
  if (malformed !== null || substep < MAX_SUBSTEPS) return malformed;
  return `substep: expected less than ${MAX_SUBSTEPS}, got ${substep}`;
}

function notWhole(field: string, value: number, least: number): string | null {
  if (Number.isSafeInteger(value) && value >= least) return null;
  return `${field}: expected a whole number ≥ ${least}, got ${String(value)}`;
}
