import type { RedisClientType } from 'redis';
import { type Controls } from '../../dynamics';
import { MAX_WAITING } from '../clients/limits';

/** The way into the service: one stream (REDIS.md, touchdown:inbox). */
export interface Inbox {
  /** Own controls; without a stamp they act at the next tick. */
  readonly controls: (input: OwnInput) => void;
  readonly command: (type: 'spawn' | 'respawn' | 'remove' | 'maneuver', data: object) => void;
  /** Sends what waited while Redis was unavailable. */
  readonly flush: () => void;
  /** Entries that wait, and that were dropped because too many did. */
  readonly counts: () => { readonly waiting: number; readonly dropped: number };
}

export interface OwnInput {
  readonly shipId: string;
  readonly playerId: string;
  readonly session: string;
  readonly seq: number;
  /** Members that are absent stay as they are. */
  readonly controls: Partial<Controls>;
  readonly stamp: { readonly tick: number; readonly substep: number } | null;
}

type Entry = Record<string, string>;

const INBOX = 'touchdown:inbox';
const KEPT = 100_000;

/** An entry without an answer is sent again: the service recognises repeated inputs by session and number. */
export function createInbox(redis: RedisClientType): Inbox {
  const waiting: Entry[] = [];
  let dropped = 0;
  let isFlushing = false;

  function keep(entry: Entry): void {
    waiting.push(entry);
    if (waiting.length <= MAX_WAITING) return;
    waiting.shift();
    dropped += 1;
  }

  function add(entry: Entry): void {
    // In the order in which they came: nothing overtakes what waits.
    if (waiting.length > 0 || !redis.isReady) keep(entry);
    else write(entry).catch(() => keep(entry));
  }

  async function write(entry: Entry): Promise<void> {
    await redis.xAdd(INBOX, '*', entry, {
      TRIM: { strategy: 'MAXLEN', strategyModifier: '~', threshold: KEPT },
    });
  }

  async function flush(): Promise<void> {
    if (isFlushing) return;
    isFlushing = true;
    try {
      while (waiting.length > 0 && redis.isReady) {
        await write(waiting[0]!);
        waiting.shift();
      }
    } catch {
      // Redis is unavailable again; the rest waits.
    } finally {
      isFlushing = false;
    }
  }

  return {
    controls({ shipId, playerId, session, seq, controls, stamp }) {
      add({
        type: 'controls',
        ship_id: shipId,
        player_id: playerId,
        session,
        seq: String(seq),
        ...(stamp !== null && { tick: String(stamp.tick), substep: String(stamp.substep) }),
        controls: JSON.stringify(inArrays(controls)),
      });
    },
    command: (type, data) => add({ type, data: JSON.stringify(data) }),
    flush: () => void flush(),
    counts: () => ({ waiting: waiting.length, dropped }),
  };
}

/** Vectors [x, y, z], the quaternion [w, x, y, z], as the service reads them; JSON leaves out what is undefined. */
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
