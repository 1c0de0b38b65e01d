import {
  encodeCommonPart,
  encodeFrameJson,
  encodeOwnPart,
  encodeShipPart,
  encodeShipStateJson,
  type InputAcknowledgement,
  joinFrameParts,
  type ServerFrame,
  type ShipState,
  type WorldEvent,
} from '../../wire';
import { MAX_STATE } from '../clients/limits';

/** One frame encoded for many clients: each ship is encoded once. */
export interface SharedFrame {
  readonly frame: ServerFrame;
  /** The game's state message with the ships of `indices`, in that order, as many as fit in 64 KB. */
  readonly json: (indices: readonly number[]) => string;
  /** The protobuf frame with the ships of `indices`. */
  readonly bytes: (
    indices: readonly number[],
    events: readonly WorldEvent[],
    lastInput: InputAcknowledgement | null,
  ) => Uint8Array;
}

/** Fields that the game's own state message does not have. They are left out on /ws, so that a client receives exactly the game's format. */
const EXTENSION_FIELDS = [
  'contact_impact_speed',
  'reference_body',
  'relative_position',
  'relative_velocity',
  'crashed',
] as const;

export function shareFrame(frame: ServerFrame): SharedFrame {
  const { ships } = frame;
  const texts = new Array<Sized | undefined>(ships.length);
  const parts = new Array<Uint8Array | undefined>(ships.length);
  let headText: string | null = null;
  let common: Uint8Array | null = null;
  return {
    frame,
    json(indices) {
      headText ??= headOf(frame);
      // The end, "]}", and no comma before the first ship.
      let size = Buffer.byteLength(headText) + 1;
      const included: string[] = [];
      for (const index of indices) {
        const { text, bytes } = (texts[index] ??= sized(shipText(ships[index]!)));
        size += bytes + 1;
        if (size > MAX_STATE) break;
        included.push(text);
      }
      return `${headText}${included.join(',')}]}`;
    },
    bytes(indices, events, lastInput) {
      common ??= encodeCommonPart(frame);
      const seen = indices.map((index) => (parts[index] ??= encodeShipPart(ships[index]!)));
      return joinFrameParts([common, ...seen, encodeOwnPart(events, lastInput)]);
    },
  };
}

interface Sized {
  readonly text: string;
  readonly bytes: number;
}

function sized(text: string): Sized {
  return { text, bytes: Buffer.byteLength(text) };
}

/** The state message up to its ships, which come last. */
function headOf({ kind, tick, tickRate, timeScale, gameTime, paused, bodies }: ServerFrame): string {
  const time = gameTime === undefined ? {} : { gameTime };
  const encoded = encodeFrameJson({ kind, tick, tickRate, timeScale, ...time, paused, bodies, ships: [] });
  const text = JSON.stringify({ type: 'state', ...encoded, ships: undefined });
  return `${text.slice(0, -1)},"ships":[`;
}

function shipText(ship: ShipState): string {
  const fields: Record<string, unknown> = { ...encodeShipStateJson(ship) };
  return JSON.stringify(fields, (key, value: unknown) =>
    (EXTENSION_FIELDS as readonly string[]).includes(key) ? undefined : value,
  );
}
