import type { Hello, InputRecord, ServerFrame } from '../../wire';
import { isWhole, type Recording } from './recording';
import type { StagedInput } from '../scenario';

/** What a recording holds between one hello and the next: a connection, or the time after the server changed its settings. */
export interface RecordedSession {
  /** What was in force; null where the server says no hello. */
  readonly hello: Hello | null;
  /** The last frame of each tick: while paused a tick comes again, and what it says last holds. */
  readonly frames: ReadonlyMap<number, ServerFrame>;
  /** What acted on the recording's own ship, by tick. */
  readonly inputs: ReadonlyMap<number, readonly StagedInput[]>;
}

interface Gathered {
  hello: Hello | null;
  readonly frames: Map<number, ServerFrame>;
  readonly sent: InputRecord[];
}

/**
 * The sessions in their order; what came before the first hello belongs to it. A server whose ticks go on over a new hello is still
 * the same and knows the inputs that it had been sent; one that counts anew has begun anew.
 */
export function sessionsOf({ header, entries }: Recording): RecordedSession[] {
  const gathered = gather(entries);
  let known: InputRecord[] = [];
  let latest = -Infinity;
  return gathered.map(({ hello, frames, sent }) => {
    const ticks = [...frames.keys()];
    if (ticks.some((tick) => tick < latest)) known = [];
    latest = ticks.length === 0 ? latest : Math.max(...ticks);
    known = [...known, ...sent];
    return { hello, frames, inputs: byTick([...plannedBefore(known[0], header.plan ?? []), ...known]) };
  });
}

function gather(entries: Recording['entries']): Gathered[] {
  let session: Gathered = { hello: null, frames: new Map(), sent: [] };
  const sessions = [session];
  for (const entry of entries) {
    if (entry.kind === 'sent' && entry.message.kind === 'inputs') session.sent.push(...entry.message.inputs);
    if (entry.kind !== 'received') continue;
    const { message } = entry;
    // A frame that does not tell its tempo and bodies cannot be compared with the law.
    if (message.kind === 'frame' && isWhole(message)) session.frames.set(message.tick, message);
    if (message.kind !== 'hello') continue;
    if (session.hello !== null) {
      session = { hello: null, frames: new Map(), sent: [] };
      sessions.push(session);
    }
    session.hello = message;
  }
  return sessions;
}

/** A plan holds up to the first input that was sent. */
function plannedBefore(first: InputRecord | undefined, plan: readonly StagedInput[]): readonly StagedInput[] {
  if (first === undefined) return plan;
  return plan.filter(
    ({ tick, substep }) => tick < first.tick || (tick === first.tick && substep < first.substep),
  );
}

function byTick(inputs: readonly StagedInput[]): Map<number, StagedInput[]> {
  const found = new Map<number, StagedInput[]>();
  for (const input of inputs) {
    const there = found.get(input.tick);
    if (there === undefined) found.set(input.tick, [input]);
    else there.push(input);
  }
  return found;
}
