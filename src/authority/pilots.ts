import { loadControls, writeControls } from '../dynamics';
import type { ClientMessage, InputAcknowledgement, InputRecord, Pong } from '../wire';

/** What came from pilots, by what became of it. Monotone. */
export interface Counters {
  inputsApplied: number;
  /** Of those applied: after their stamp's substep had been simulated. */
  inputsLate: number;
  /** Of a sequence number that is queued or applied already. */
  inputsDuplicate: number;
  /** Overtaken by an input of a higher sequence number: never applied. */
  inputsSuperseded: number;
  /** Refused: too far ahead. */
  inputsFromFuture: number;
  /** Refused: more than the queue holds. */
  inputsFlooded: number;
  /** Refused: malformed. */
  inputsMalformed: number;
  /** Refused: of someone who has not joined, or who flies no ship. */
  inputsOfStrangers: number;
  pings: number;
  pingsFlooded: number;
}

export function createCounters(): Counters {
  return {
    inputsApplied: 0,
    inputsLate: 0,
    inputsDuplicate: 0,
    inputsSuperseded: 0,
    inputsFromFuture: 0,
    inputsFlooded: 0,
    inputsMalformed: 0,
    inputsOfStrangers: 0,
    pings: 0,
    pingsFlooded: 0,
  };
}

/** An input on its way to its substep. */
interface QueuedInput {
  readonly record: InputRecord;
  /** Where it is due: its stamp, or the next whole tick under granularity 'tick'. */
  readonly tick: number;
  readonly substep: number;
  /** Wall seconds. */
  readonly arrivedAt: number;
}

/** A client that has joined. It can move no ship but its own. */
export interface Pilot {
  readonly playerId: string;
  /** '' for a spectator. */
  shipId: string;
  /** In the order they are due. */
  readonly queue: QueuedInput[];
  lastSeq: number;
  lastInput: InputAcknowledgement | null;
  /** No input has come since it joined. */
  fresh: boolean;
  /** Pings answered in the wall second that began at `pingsSince`. */
  pings: number;
  pingsSince: number;
}

/** Where the server stands when something arrives or falls due. */
export interface Present {
  readonly tick: number;
  /** Hz */
  readonly tickRate: number;
  readonly granularity: 'substep' | 'tick';
  /** Wall seconds at which the interval of a tick was simulated, or will be. */
  readonly simulatedAt: (tick: number) => number;
}

/** Inputs a pilot can have waiting: ten wall seconds at 0.1 Hz with a change every 10 ms, twice over. */
export const MAX_QUEUED = 2048;
/** A substep's number is below this: 100 s of game time a tick rate of 0.1 Hz and time scale 100 make 100,000. */
const MAX_SUBSTEPS = 100_000;
/** Wall seconds an input may be ahead, beside one tick. */
const MAX_AHEAD = 10;
const MAX_PINGS_A_SECOND = 100;

export function createPilot(playerId: string, shipId: string): Pilot {
  return {
    playerId,
    shipId,
    queue: [],
    lastSeq: 0,
    lastInput: null,
    fresh: true,
    pings: 0,
    pingsSince: 0,
  };
}

/** Queues the inputs of one message; the reason of the first that was refused, or null. The others are queued all the same. */
export function queueInputs(
  pilot: Pilot,
  counters: Counters,
  inputs: readonly InputRecord[],
  present: Present,
  now: number,
): string | null {
  let reason: string | null = null;
  for (const [i, record] of inputs.entries()) {
    // A page that was loaded anew numbers its inputs from 1 again; one that reconnects goes on.
    if (pilot.fresh && record.seq === 1) pilot.lastSeq = 0;
    pilot.fresh = false;
    const refusal = queueInput(pilot, counters, record, present, now);
    if (refusal !== null) reason ??= `inputs[${i}].${refusal}`;
  }
  return reason;
}

function queueInput(
  pilot: Pilot,
  counters: Counters,
  record: InputRecord,
  present: Present,
  now: number,
): string | null {
  const malformed =
    notWhole('seq', record.seq, 1) ??
    notWhole('tick', record.tick, 0) ??
    notWhole('substep', record.substep, 0);
  const controls = loadControls(record.controls);
  if (malformed !== null || !controls.ok || record.substep >= MAX_SUBSTEPS) {
    counters.inputsMalformed++;
    if (malformed !== null) return malformed;
    return controls.ok
      ? `substep: expected less than ${MAX_SUBSTEPS}, got ${record.substep}`
      : `controls.${controls.reason}`;
  }
  if (record.seq <= pilot.lastSeq || pilot.queue.some((queued) => queued.record.seq === record.seq)) {
    counters.inputsDuplicate++;
    return null;
  }
  const latest = present.tick + 1 + Math.ceil(MAX_AHEAD * present.tickRate);
  if (record.tick > latest) {
    counters.inputsFromFuture++;
    return `tick: expected at most ${latest}, got ${record.tick}`;
  }
  if (pilot.queue.length >= MAX_QUEUED) {
    counters.inputsFlooded++;
    return `seq: ${MAX_QUEUED} inputs are waiting already`;
  }
  const wholeTick = present.granularity === 'tick' && record.substep > 0;
  insert(pilot.queue, {
    record: { ...record, controls: controls.value },
    tick: wholeTick ? record.tick + 1 : record.tick,
    substep: present.granularity === 'tick' ? 0 : record.substep,
    arrivedAt: now,
  });
  return null;
}

/** Writes into the ship's row what is due at the start of substep `substep` of the present interval; whether anything was. */
export function applyDue(
  pilot: Pilot,
  counters: Counters,
  ship: { readonly rows: Float64Array; readonly at: number },
  when: Present & { readonly substep: number },
): boolean {
  const { queue } = pilot;
  const before = pilot.lastSeq;
  let due = 0;
  while (due < queue.length && isDue(queue[due]!, when)) due++;
  for (const queued of queue.splice(0, due)) {
    const { record } = queued;
    if (record.seq <= pilot.lastSeq) {
      counters.inputsSuperseded++;
      continue;
    }
    const late = queued.tick !== when.tick || queued.substep !== when.substep;
    counters.inputsApplied++;
    if (late) counters.inputsLate++;
    writeControls(ship.rows, ship.at, record.controls);
    pilot.lastSeq = record.seq;
    pilot.lastInput = {
      seq: record.seq,
      tick: when.tick,
      substep: when.substep,
      margin: when.simulatedAt(queued.tick) - queued.arrivedAt,
    };
  }
  return pilot.lastSeq !== before;
}

/** The answer to a ping, or null when there were too many in this wall second. */
export function answerPing(
  pilot: Pilot,
  counters: Counters,
  message: Extract<ClientMessage, { kind: 'ping' }>,
  server: { readonly tick: number; readonly since: number },
  now: number,
): Pong | null {
  if (!(now - pilot.pingsSince < 1)) {
    pilot.pingsSince = now;
    pilot.pings = 0;
  }
  if (pilot.pings >= MAX_PINGS_A_SECOND) {
    counters.pingsFlooded++;
    return null;
  }
  pilot.pings++;
  counters.pings++;
  return { kind: 'pong', id: message.id, tick: server.tick, sinceTick: server.since };
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

function notWhole(field: string, value: number, least: number): string | null {
  if (Number.isSafeInteger(value) && value >= least) return null;
  return `${field}: expected a whole number ≥ ${least}, got ${String(value)}`;
}
