import type { RedisClientType } from 'redis';
import { type Controls } from '../../dynamics';
import { MAX_QUEUED_ENTRIES } from '../clients/limits';
import { createFaults } from './faults';

/** Sends inputs and commands to the service through one stream (REDIS.md, touchdown:inbox). */
export interface Inbox {
  /** Sends a ship's controls; without a stamp they apply at the next tick. */
  readonly controls: (input: OwnInput) => void;
  readonly command: (type: 'spawn' | 'respawn' | 'remove' | 'maneuver', data: object) => void;
  /** Sends entries queued while Redis was unavailable. */
  readonly flush: () => void;
  /** Entries queued now, and entries dropped because the queue was full. */
  readonly counts: () => { readonly waiting: number; readonly dropped: number };
}

export interface OwnInput {
  readonly shipId: string;
  readonly playerId: string;
  readonly session: string;
  readonly seq: number;
  /** Absent members stay unchanged. */
  readonly controls: Partial<Controls>;
  readonly stamp: { readonly tick: number; readonly substep: number } | null;
}

type Entry = Record<string, string>;

const INBOX = 'touchdown:inbox';
/** Approximate maximum length of the stream, entries. */
const MAX_LENGTH = 100_000;

/**
 * Resends entries that Redis did not acknowledge; the service detects repeated inputs by session and sequence number.
 * @param log takes why entries cannot be written although Redis is available, once for each reason
 */
export function createInbox(redis: RedisClientType, log: (line: string) => void): Inbox {
  const faults = createFaults(log);
  const waiting: Entry[] = [];
  let dropped = 0;
  let isFlushing = false;

  function enqueue(entry: Entry): void {
    waiting.push(entry);
    if (waiting.length <= MAX_QUEUED_ENTRIES) return;
    waiting.shift();
    dropped += 1;
  }

  function send(entry: Entry): void {
    // A new entry must not overtake queued ones.
    if (waiting.length > 0 || !redis.isReady) enqueue(entry);
    else
      write(entry).catch((error: unknown) => {
        report(error);
        enqueue(entry);
      });
  }

  async function write(entry: Entry): Promise<void> {
    await redis.xAdd(INBOX, '*', entry, {
      TRIM: { strategy: 'MAXLEN', strategyModifier: '~', threshold: MAX_LENGTH },
    });
    faults.clear(INBOX);
  }

  function report(error: unknown): void {
    if (redis.isReady) faults.report(INBOX, 'stream', error);
  }

  async function flush(): Promise<void> {
    if (isFlushing) return;
    isFlushing = true;
    try {
      while (waiting.length > 0 && redis.isReady) {
        await write(waiting[0]!);
        waiting.shift();
      }
    } catch (error) {
      // The rest stays queued.
      report(error);
    } finally {
      isFlushing = false;
    }
  }

  return {
    controls({ shipId, playerId, session, seq, controls, stamp }) {
      send({
        type: 'controls',
        ship_id: shipId,
        player_id: playerId,
        session,
        seq: String(seq),
        ...(stamp !== null && { tick: String(stamp.tick), substep: String(stamp.substep) }),
        controls: JSON.stringify(inArrays(controls)),
      });
    },
    command: (type, data) => send({ type, data: JSON.stringify(data) }),
    flush: () => void flush(),
    counts: () => ({ waiting: waiting.length, dropped }),
  };
}

/** The service's format: vectors [x, y, z], quaternion [w, x, y, z]. JSON omits undefined members. */
function inArrays(controls: Partial<Controls>): Record<string, unknown> {
  const target = controls.targetAttitude;
  return {
    thrust_level: controls.thrustLevel,
    translation_input: controls.translationInput,
    rotation_input: controls.rotationInput,
    attitude_hold: controls.attitudeHold,
    attitude_mode: controls.attitudeMode,
    target_attitude: target && [target[3], target[0], target[1], target[2]],
  };
}
