import type { RedisClientType } from 'redis';
import { decodeFrameJson, type InputAcknowledgement, type ServerFrame, type WorldEvent } from '../../wire';

/** The world at one tick boundary, as the service wrote it (REDIS.md), checked. */
export interface WorldFrame {
  readonly frame: ServerFrame;
  /** Wall s by Redis's clock at which the boundary was due. */
  readonly due: number;
  /** The last input applied of each ship, and of which session it was. */
  readonly lastInputs: ReadonlyMap<string, InputAcknowledgement & { readonly session: string }>;
  readonly removed: readonly Removed[];
}

export interface Removed {
  readonly shipId: string;
  readonly playerId: string;
  readonly name: string;
  readonly reason: string;
  /** Of a destruction: on which body. */
  readonly body: string;
}

export interface FeedHandlers {
  readonly onFrame: (world: WorldFrame) => void;
  /** Called with the reason for each invalid part. */
  readonly onRefused: (reason: string) => void;
}

export interface Feed {
  readonly newest: () => WorldFrame | null;
  /** Reads until `stop`; the connection may come and go. */
  readonly run: () => Promise<void>;
  readonly stop: () => void;
  /** The events from `tick` on that Redis still has, in order; at most `most`. */
  readonly eventsSince: (tick: number, most: number) => Promise<readonly WorldEvent[]>;
}

const FRAMES = 'touchdown:frames';
const EVENTS = 'touchdown:events';
/** Wall ms for which a read waits. */
const BLOCK = 1000;
const RETRY = 200;
/** Frames taken in one read. */
const BATCH = 16;

/**
 * Reads the service's frames in order, from the newest on.
 * @param reader a separate connection, since a read blocks it
 * @param asker the connection for everything else
 */
export function createFeed(reader: RedisClientType, asker: RedisClientType, handlers: FeedHandlers): Feed {
  let newest: WorldFrame | null = null;
  let lastId = '';
  let stopped = false;
  const isStopped = () => stopped;

  async function readOn(): Promise<void> {
    if (lastId === '') await begin();
    const streams = await reader.xRead(
      { key: FRAMES, id: lastId === '' ? '0-0' : lastId },
      { BLOCK, COUNT: BATCH },
    );
    if (streams === null) {
      await rewindIfLost();
      return;
    }
    for (const { id, message } of (streams as unknown as StreamReply)[0]!.messages) {
      lastId = id;
      await takeFrame(message['frame'] ?? '');
    }
  }

  /** The newest frame in Redis. */
  async function begin(): Promise<void> {
    const entry = (await asker.xRevRange(FRAMES, '+', '-', { COUNT: 1 }))?.[0];
    if (entry === undefined) return;
    lastId = entry.id;
    await takeFrame(entry.message['frame'] ?? '');
  }

  /** A Redis that came back without its last entries counts on from an earlier one. */
  async function rewindIfLost(): Promise<void> {
    const entry = (await asker.xRevRange(FRAMES, '+', '-', { COUNT: 1 }))?.[0];
    if (entry !== undefined && isBefore(entry.id, lastId)) lastId = '';
  }

  async function takeFrame(text: string): Promise<void> {
    const world = readWorldFrame(text, handlers.onRefused);
    if (world === null) return;
    const gap = newest !== null && world.frame.tick > newest.frame.tick + 1;
    const missed = gap ? await missedEvents(asker, newest!.frame.tick, world.frame) : [];
    newest = missed.length === 0 ? world : withEvents(world, missed);
    handlers.onFrame(newest);
  }

  return {
    newest: () => newest,
    stop: () => {
      stopped = true;
    },
    eventsSince: (tick, most) => readEvents(asker, tick, most),
    async run() {
      while (!isStopped()) {
        try {
          await readOn();
        } catch (error) {
          if (!isStopped())
            handlers.onRefused(`redis: ${error instanceof Error ? error.message : String(error)}`);
          await new Promise((resolve) => setTimeout(resolve, RETRY));
        }
      }
    },
  };
}

/** Events of the ticks between two frames, where the later one is not the next. */
async function missedEvents(
  asker: RedisClientType,
  tick: number,
  { events }: ServerFrame,
): Promise<readonly WorldEvent[]> {
  const first = events[0]?.tick ?? Infinity;
  return (await readEvents(asker, tick, 1000)).filter((event) => event.tick < first);
}

async function readEvents(
  asker: RedisClientType,
  tick: number,
  most: number,
): Promise<readonly WorldEvent[]> {
  const entries = await asker.xRevRange(EVENTS, '+', '-', { COUNT: most });
  const sent = (entries ?? []).reverse().map(({ message }) => message);
  const decoded = decodeFrameJson({ tick: 2 ** 52, ships: [], events: sent });
  const events = decoded.ok ? decoded.value.events : undefined;
  return (events ?? []).filter((event) => event.tick >= tick);
}

type StreamReply = { messages: { id: string; message: Record<string, string> }[] }[];

/** Ids are "milliseconds-count". */
function isBefore(a: string, b: string): boolean {
  const [aTime = 0, aCount = 0] = a.split('-').map(Number);
  const [bTime = 0, bCount = 0] = b.split('-').map(Number);
  return aTime < bTime || (aTime === bTime && aCount < bCount);
}

function withEvents(world: WorldFrame, missed: readonly WorldEvent[]): WorldFrame {
  return { ...world, frame: { ...world.frame, events: [...missed, ...world.frame.events] } };
}

/** The frame, or null if it is invalid. Invalid ships and bodies are left out and reported. */
export function readWorldFrame(text: string, onRefused: (reason: string) => void): WorldFrame | null {
  let sent: Record<string, unknown>;
  try {
    sent = JSON.parse(text) as Record<string, unknown>;
  } catch {
    onRefused('frame: not JSON');
    return null;
  }
  const decoded = decodeFrameJson(sent);
  if (!decoded.ok) {
    onRefused(`frame.${decoded.reason}`);
    return null;
  }
  const { refusals, kind, tick, ships, gameTime, ...told } = decoded.value;
  for (const refusal of refusals) onRefused(`frame.${refusal}`);
  const untold = { tickRate: 1, timeScale: 1, paused: false, bodies: [], events: [], lastInput: null };
  const time = gameTime === undefined ? {} : { gameTime };
  return {
    frame: { ...untold, ...told, kind, tick, ships, ...time },
    due: typeof sent['due'] === 'number' ? sent['due'] : 0,
    lastInputs: lastInputsOf(sent['ships']),
    removed: removedOf(sent['removed'], told.events ?? []),
  };
}

function lastInputsOf(ships: unknown): WorldFrame['lastInputs'] {
  const found = new Map<string, InputAcknowledgement & { session: string }>();
  for (const ship of listOf(ships)) {
    const last = ship['last_input'] as Record<string, unknown> | undefined;
    if (last === undefined || typeof last !== 'object') continue;
    const { session, seq, tick, substep, margin } = last;
    const numbers = [seq, tick, substep, margin];
    if (typeof session !== 'string' || !numbers.every((value) => typeof value === 'number')) continue;
    const [s, t, sub, m] = numbers as [number, number, number, number];
    found.set(String(ship['ship_id']), { session, seq: s, tick: t, substep: sub, margin: m });
  }
  return found;
}

function removedOf(removed: unknown, events: readonly WorldEvent[]): Removed[] {
  return listOf(removed).map((ship) => ({
    shipId: textOf(ship['ship_id']),
    playerId: textOf(ship['player_id']),
    name: textOf(ship['name']),
    reason: textOf(ship['reason']),
    body:
      events.find(({ shipId, type }) => shipId === ship['ship_id'] && type === 'ship.destroyed')?.body ?? '',
  }));
}

function listOf(value: unknown): Record<string, unknown>[] {
  return Array.isArray(value)
    ? (value as Record<string, unknown>[]).filter((item) => typeof item === 'object')
    : [];
}

function textOf(value: unknown): string {
  return typeof value === 'string' ? value : '';
}
