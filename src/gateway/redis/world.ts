import type { RedisClientType } from 'redis';
import { decodeHelloJson, type Hello } from '../../wire';
import { createFaults, isWrongType } from './faults';

const WORLD = 'touchdown:world';

/**
 * Creates a reader of the world definition that the service writes.
 * @param log takes why a definition is invalid, once for each reason, and each invalid part of a valid one
 * @returns a function that reads the definition; null if there is no valid one. It rejects if Redis is unavailable
 */
export function createWorldReader(
  redis: RedisClientType,
  log: (line: string) => void,
): () => Promise<Hello | null> {
  const faults = createFaults(log);

  function refuse(error: unknown): null {
    faults.report(WORLD, 'string', error);
    return null;
  }

  return async () => {
    const text = await redis.get(WORLD).catch((error: unknown) => {
      if (!isWrongType(error)) throw error;
      return refuse(error);
    });
    if (text === null) return null;
    const sent = parsed(text);
    if (sent === undefined) return refuse(`${WORLD}: not JSON`);
    const hello = decodeHelloJson(sent);
    if (!hello.ok) return refuse(`${WORLD}: ${hello.reason}`);
    const { refusals, ...world } = hello.value;
    for (const refusal of refusals) log(`${WORLD}: ${refusal}`);
    return world;
  };
}

/** undefined if the text is not JSON. */
function parsed(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}
