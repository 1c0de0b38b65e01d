import protobuf from 'protobufjs/minimal.js';
import type { Result } from '../dynamics';
import type { ServerMessage, WorldEvent } from './records';
import { notBytes } from './messages/envelope';
import { decodeServerMessage } from './messages/serverMessage';

/**
 * An undecoded message of the server: a page that was hidden for minutes decodes only the newest frame, and the events of the earlier
 * ones (PREDICTION, Absence).
 */
export interface PendingMessage {
  /** Whether it is a frame, which a newer one supersedes. */
  readonly isFrame: boolean;
  /** The whole message, checked, or an error that names the first invalid field. Never throws. */
  readonly decode: () => Result<ServerMessage>;
  /** A frame's events alone; none if they cannot be read. */
  readonly events: () => readonly WorldEvent[];
}

/** Field numbers of ServerMessage and ServerFrame in stream.proto. */
const FRAME = 2;
const BODIES = 5;
const SHIPS = 6;
const EVENTS = 7;
const LENGTH_DELIMITED = 2;

/**
 * Reads `bytes` only as far as needed. Never throws, whatever they are.
 *
 * @example
 * ```ts
 * predictor.receivePending(pendingServerMessage(bytes), now); // decoded by the next advance, if still needed
 * ```
 */
export function pendingServerMessage(bytes: Uint8Array): PendingMessage {
  const isBytes = notBytes(bytes) === '';
  return {
    isFrame: isBytes && bytes[0] === ((FRAME << 3) | LENGTH_DELIMITED),
    decode: () => decodeServerMessage(bytes),
    events() {
      const short = isBytes && mayHaveEvents(bytes) ? withoutShips(bytes) : null;
      if (short === null) return [];
      const decoded = decodeServerMessage(short);
      return decoded.ok && decoded.value.kind === 'frame' ? decoded.value.events : [];
    },
  };
}

const VARINT = 0;
const FIXED64 = 1;
const CONTINUES = 0x80;

/**
 * False for a frame without events. It runs over each frame that a page missed, twelve thousand in ten minutes at 20 Hz, and so steps
 * from field to field by hand; unknown fields count as true, for `withoutShips` to read.
 */
function mayHaveEvents(bytes: Uint8Array): boolean {
  let at = afterVarint(bytes, 1);
  while (at < bytes.length) {
    const tag = bytes[at]!;
    if (tag >= CONTINUES || tag >>> 3 === EVENTS) return true;
    at += 1;
    switch (tag & 7) {
      case VARINT:
        at = afterVarint(bytes, at);
        break;
      case FIXED64:
        at += 8;
        break;
      case LENGTH_DELIMITED:
        at = afterDelimited(bytes, at);
        break;
      default:
        return true;
    }
  }
  return false;
}

function afterVarint(bytes: Uint8Array, from: number): number {
  let at = from;
  while (bytes[at]! >= CONTINUES) at += 1;
  return at + 1;
}

/** The offset after a length-delimited field; NaN if its length has no end. The length is not negative, so every step advances. */
function afterDelimited(bytes: Uint8Array, from: number): number {
  let length = 0;
  let at = from;
  for (let unit = 1; ; unit *= CONTINUES) {
    const part = bytes[at]!;
    at += 1;
    length += (part % CONTINUES) * unit;
    if (!(part >= CONTINUES)) return at + length;
  }
}

/** The same frame without bodies and ships; null if it has no events, or is not a frame in one part. */
function withoutShips(bytes: Uint8Array): Uint8Array | null {
  try {
    const reader = protobuf.Reader.create(bytes);
    if (reader.uint32() >>> 3 !== FRAME) return null;
    const end = reader.uint32() + reader.pos;
    const parts: Uint8Array[] = [];
    let hasEvents = false;
    while (reader.pos < end) {
      const from = reader.pos;
      const tag = reader.uint32();
      const field = tag >>> 3;
      reader.skipType(tag & 7);
      if (field === EVENTS) hasEvents = true;
      if (field !== BODIES && field !== SHIPS) parts.push(bytes.subarray(from, reader.pos));
    }
    return hasEvents ? sealed(parts) : null;
  } catch {
    return null;
  }
}

function sealed(parts: readonly Uint8Array[]): Uint8Array {
  const inner = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    inner.set(part, at);
    at += part.length;
  }
  return protobuf.Writer.create()
    .uint32((FRAME << 3) | LENGTH_DELIMITED)
    .bytes(inner)
    .finish();
}
