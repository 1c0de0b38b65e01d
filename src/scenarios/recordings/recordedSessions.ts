import type { Hello, InputRecord, ServerFrame } from '../../wire';
import { isWhole, type Recording } from './recording';
import type { ScheduledInput } from '../runTick';

/** The part of a recording between two hellos: one connection, or one set of server settings. */
export interface RecordedSession {
  /** The world config in force; null if the server sends no hello. */
  readonly hello: Hello | null;
  /** The last frame of each tick: while paused a tick is repeated, and its last frame counts. */
  readonly frames: ReadonlyMap<number, ServerFrame>;
  /** Inputs that acted on the ship of the recording's player, by tick. */
  readonly inputs: ReadonlyMap<number, readonly ScheduledInput[]>;
}

interface Gathered {
  hello: Hello | null;
  readonly frames: Map<number, ServerFrame>;
  readonly sent: InputRecord[];
}

/**
 * The sessions in order; entries before the first hello belong to it. A server whose ticks continue across a new hello is the same one and
 * knows earlier inputs; a server whose ticks start again has restarted.
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
    // A frame without tempo and bodies cannot be compared with the dynamics.
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

/** The plan applies until the first input that was sent. */
function plannedBefore(
  first: InputRecord | undefined,
  plan: readonly ScheduledInput[],
): readonly ScheduledInput[] {
  if (first === undefined) return plan;
  return plan.filter(
    ({ tick, substep }) => tick < first.tick || (tick === first.tick && substep < first.substep),
  );
}

function byTick(inputs: readonly ScheduledInput[]): Map<number, ScheduledInput[]> {
  const found = new Map<number, ScheduledInput[]>();
  for (const input of inputs) {
    const there = found.get(input.tick);
    if (there === undefined) found.set(input.tick, [input]);
    else there.push(input);
  }
  return found;
}
