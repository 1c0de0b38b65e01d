import { hashRows } from '../../../dynamics';
import type { PartialFrame } from '../../../wire';

/** Tick and bits of the last state of the player's ship that belongs to the scenario: a landed ship continues to turn with the ground. */
export interface RunHash {
  readonly take: (frame: PartialFrame) => void;
  /** `tick:hash`, '' before the first state. */
  readonly text: () => string;
  /** The scenario's last state has been hashed, or none is: no further state needs to be decoded for the hash. */
  readonly ended: () => boolean;
}

/** @param lastTick of the scenario; by default nothing is hashed */
export function createRunHash(lastTick = -Infinity): RunHash {
  let hashedTick = -Infinity;
  let seenTick = -Infinity;
  let text = '';
  return {
    take(frame) {
      seenTick = Math.max(seenTick, frame.tick);
      if (frame.tick <= hashedTick || frame.tick > lastTick) return;
      const own = frame.ships.find(({ shipId }) => shipId === 'own');
      if (!own?.relativePosition || !own.relativeVelocity) return;
      hashedTick = frame.tick;
      const row = Float64Array.of(
        ...own.relativePosition,
        ...own.relativeVelocity,
        ...own.attitude,
        ...own.angularVelocity,
        own.fuel,
      );
      text = `${frame.tick}:${String(hashRows(row))}`;
    },
    text: () => text,
    ended: () => seenTick >= lastTick,
  };
}
