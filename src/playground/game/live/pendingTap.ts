import type { PendingMessage, ServerMessage, WorldEvent } from '../../../wire';

/** Events of superseded frames that are kept for the recording, as many as the predictor keeps. */
const MAX_EVENTS = 1000;

/** Wraps pending messages: those that the predictor decodes are also recorded, hashed and drawn from. */
export interface PendingTap {
  /** `took` a decoded message, as it was sent or with superseded frames' events; `passed` over a superseded frame. */
  readonly wrap: (
    message: PendingMessage,
    took: (message: ServerMessage, isAsSent: boolean) => void,
    passed: () => void,
  ) => PendingMessage;
  readonly clear: () => void;
}

/** A superseded frame is never decoded: its events go into the next frame that is decoded, as in the predictor. */
export function createPendingTap(): PendingTap {
  let superseded: WorldEvent[] = [];
  return {
    clear() {
      superseded = [];
    },
    wrap: (message, took, passed) => ({
      isFrame: message.isFrame,
      events() {
        passed();
        const events = message.events();
        superseded.push(...events);
        superseded.splice(0, Math.max(0, superseded.length - MAX_EVENTS));
        return events;
      },
      decode() {
        const decoded = message.decode();
        if (!decoded.ok) return decoded;
        const { value } = decoded;
        if (value.kind !== 'frame' || superseded.length === 0) took(value, true);
        else took({ ...value, events: [...superseded.splice(0), ...value.events] }, false);
        return decoded;
      },
    }),
  };
}
