import type { RedisClientType } from 'redis';
import { decodeFrameJson, type InputAcknowledgement, type ServerFrame, type WorldEvent } from '../../wire';
import { createEventReader } from './events';
import { createFaults } from './faults';

/** The world at one tick boundary, written by the service (REDIS.md) and checked here. */
export interface WorldFrame {
  readonly frame: ServerFrame;
  /** When the boundary was due, wall s by Redis's clock. */
  readonly due: number;
  /** Each ship's last applied input and its session, by ship ID. */
  readonly lastInputs: ReadonlyMap<string, InputAcknowledgement & { readonly session: string }>;
  readonly removed: readonly Removed[];
}

export interface Removed {
  readonly shipId: string;
  readonly playerId: string;
  readonly name: string;
  readonly reason: string;
  /** Body that the ship was destroyed on; '' for other reasons. */
  readonly body: string;
}

export interface FeedHandlers {
  readonly onFrame: (world: WorldFrame) => void;
  /**
   * Called with the reason for each invalid part, and with each reason why Redis cannot be read. `isNew`: unless the same part of the
   * frame before was invalid too.
   */
  readonly onRefused: (reason: string, isNew: boolean) => void;
}

export interface Feed {
  readonly newest: () => WorldFrame | null;
  /** Reads until `stop`; retries while Redis is unavailable. */
  readonly run: () => Promise<void>;
  readonly stop: () => void;
  /** Events from `tick` on that Redis still has, in order: those among its newest `count`. */
  readonly eventsSince: (tick: number, count: number) => Promise<readonly WorldEvent[]>;
}

const FRAMES = 'touchdown:frames';
/** Longest wait of a blocking read, wall ms. */
const BLOCK = 1000;
/** Wait after a failed read, wall ms. */
const RETRY = 200;
/** Maximum frames per read. */
const BATCH = 16;

/**
 * Reads the service's frames in order, from the newest on.
 * @param reader a separate connection, since its reads block
 * @param redis the connection for other requests
 */
export function createFeed(reader: RedisClientType, redis: RedisClientType, handlers: FeedHandlers): Feed {
  const faults = createFaults((line) => handlers.onRefused(line, true));
  const events = createEventReader(redis, faults);
  let newest: WorldFrame | null = null;
  let lastId = '';
  const read = createFrameReader(handlers.onRefused);
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
      await handleFrame(message['frame'] ?? '');
    }
  }

  /** Takes the newest frame in Redis. */
  async function begin(): Promise<void> {
    const entry = await newestEntry(redis);
    if (entry === undefined) return;
    lastId = entry.id;
    await handleFrame(entry.message['frame'] ?? '');
  }

  /** Starts over if Redis restarted without its last entries: its IDs then continue from an earlier one. */
  async function rewindIfLost(): Promise<void> {
    const entry = await newestEntry(redis);
    if (entry !== undefined && isBefore(entry.id, lastId)) lastId = '';
  }

  async function handleFrame(text: string): Promise<void> {
    const world = read(text);
    if (world === null) return;
    const gap = newest !== null && world.frame.tick > newest.frame.tick + 1;
    const missed = gap ? await events.missed(newest!.frame.tick, world.frame) : [];
    newest = missed.length === 0 ? world : withEvents(world, missed);
    handlers.onFrame(newest);
  }

  return {
    newest: () => newest,
    stop: () => {
      stopped = true;
    },
    eventsSince: events.since,
    async run() {
      while (!isStopped()) {
        try {
          await readOn();
          faults.clear(FRAMES);
        } catch (error) {
          if (!isStopped()) faults.report(FRAMES, 'stream', error);
          await new Promise((resolve) => setTimeout(resolve, RETRY));
        }
      }
    },
  };
}

async function newestEntry(redis: RedisClientType) {
  return (await redis.xRevRange(FRAMES, '+', '-', { COUNT: 1 }))?.[0];
}

type StreamReply = { messages: { id: string; message: Record<string, string> }[] }[];

/** Reads one frame after another, and tells refusals of parts that were invalid in the frame before from new ones. */
function createFrameReader(onRefused: FeedHandlers['onRefused']) {
  let before: ReadonlySet<string> = new Set();
  return (text: string) => {
    const parts = new Set<string>();
    const world = readWorldFrame(text, (reason) => {
      const part = partOf(reason);
      parts.add(part);
      onRefused(reason, !before.has(part));
    });
    before = parts;
    return world;
  };
}

/** The path that a refusal begins with: the value after it may change from frame to frame. */
function partOf(refusal: string): string {
  return refusal.slice(0, refusal.indexOf(': '));
}

/** Compares stream IDs, "milliseconds-count". */
function isBefore(a: string, b: string): boolean {
  const [aTime, aCount] = a.split('-').map(Number) as [number, number];
  const [bTime, bCount] = b.split('-').map(Number) as [number, number];
  return aTime < bTime || (aTime === bTime && aCount < bCount);
}

function withEvents(world: WorldFrame, missed: readonly WorldEvent[]): WorldFrame {
  return { ...world, frame: { ...world.frame, events: [...missed, ...world.frame.events] } };
}

/** Reads a frame; null if it is invalid. Invalid ships and bodies are left out. Each refusal is reported. */
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
  const { refusals, ...given } = decoded.value;
  for (const refusal of refusals) onRefused(`frame.${refusal}`);
  const defaults = { tickRate: 1, timeScale: 1, paused: false, bodies: [], events: [], lastInput: null };
  return {
    frame: { ...defaults, ...given },
    due: typeof sent['due'] === 'number' ? sent['due'] : 0,
    lastInputs: lastInputsOf(sent['ships']),
    removed: removedOf(sent['removed'], given.events ?? []),
  };
}

function lastInputsOf(ships: unknown): WorldFrame['lastInputs'] {
  const found = new Map<string, InputAcknowledgement & { session: string }>();
  for (const ship of listOf(ships)) {
    const last = ship['last_input'];
    if (!isRecord(last)) continue;
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
  return Array.isArray(value) ? value.filter(isRecord) : [];
}

function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null;
}

function textOf(value: unknown): string {
  return typeof value === 'string' ? value : '';
}
