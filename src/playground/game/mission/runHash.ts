import { hashRows } from '../../../dynamics';
import type { PartialFrame } from '../../../wire';

/** Tick and bits of the last state of the player's ship that belongs to the scenario: a landed ship continues to turn with the ground. */
export interface RunHash {
  readonly begin: (lastTick: number) => void;
  readonly take: (frame: PartialFrame) => void;
  /** `tick:hash`, '' before the first state. */
  readonly text: () => string;
  /** The scenario's last state has been hashed, or none is: no further state needs to be decoded for the hash. */
  readonly ended: () => boolean;
}

export function createRunHash(): RunHash {
  let lastTick = -1;
  let hashedTick = -1;
  let seenTick = -1;
  let text = '';
  return {
    begin(next) {
      lastTick = next;
      hashedTick = -1;
      seenTick = -1;
      text = '';
    },
    take(frame) {
      seenTick = Math.max(seenTick, frame.tick);
      if (frame.tick <= hashedTick || frame.tick > lastTick) return;
      const own = frame.ships.find(({ shipId }) => shipId === 'own');
      if (own?.relativePosition === undefined || own.relativePosition === null) return;
      hashedTick = frame.tick;
      const row = Float64Array.of(
        ...own.relativePosition,
        ...(own.relativeVelocity ?? []),
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
