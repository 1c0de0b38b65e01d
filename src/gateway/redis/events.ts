import type { RedisClientType } from 'redis';
import { decodeFrameJson, MAX_TICK, type ServerFrame, type WorldEvent } from '../../wire';
import { type Faults, isWrongType } from './faults';

/** Events in Redis, beyond those of the newest frames. */
export interface EventReader {
  /** Events from `tick` on that Redis still has, in order: those among its newest `count`. */
  readonly since: (tick: number, count: number) => Promise<readonly WorldEvent[]>;
  /** Events of the ticks between a received frame, of `tick`, and the next one received; none if their stream is not one. */
  readonly missed: (tick: number, next: ServerFrame) => Promise<readonly WorldEvent[]>;
}

const EVENTS = 'touchdown:events';
/** Newest events that are searched for those of missed ticks. */
const MAX_MISSED = 1000;

export function createEventReader(redis: RedisClientType, faults: Faults): EventReader {
  async function since(tick: number, count: number): Promise<readonly WorldEvent[]> {
    const entries = await redis.xRevRange(EVENTS, '+', '-', { COUNT: count });
    faults.clear(EVENTS);
    const sent = (entries ?? []).reverse().map(({ message }) => message);
    // Events may not be after their frame's tick: the highest admits all.
    const decoded = decodeFrameJson({ tick: MAX_TICK, ships: [], events: sent });
    const events = decoded.ok ? decoded.value.events : undefined;
    return (events ?? []).filter((event) => event.tick >= tick);
  }

  return {
    since,
    async missed(tick, { events }) {
      const first = events[0]?.tick ?? Infinity;
      try {
        return (await since(tick, MAX_MISSED)).filter((event) => event.tick < first);
      } catch (error) {
        if (!isWrongType(error)) throw error;
        faults.report(EVENTS, 'stream', error);
        return [];
      }
    },
  };
}
