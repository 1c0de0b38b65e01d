import protobuf from 'protobufjs/minimal.js';
import { type Result, ok, err } from '../../dynamics';

/** Most entries of each list of a message in an envelope, by field numbers of stream.proto. */
export interface Envelope {
  readonly maxBytes: number;
  readonly lists: ReadonlyMap<number, ReadonlyMap<number, ListLimit>>;
}

export interface ListLimit {
  /** The list's path, for the reason. */
  readonly name: string;
  readonly most: number;
}

/**
 * Decodes the bytes, or returns the reason why they are not the message. Lists are counted before anything is built:
 * 8 MB of empty entries would otherwise become 400 MB of objects.
 */
export function openEnvelope<T>(
  bytes: Uint8Array,
  envelope: Envelope,
  decode: (reader: protobuf.Reader) => T,
): Result<T> {
  const mistaken = notBytes(bytes);
  if (mistaken !== '') return err(`message: expected bytes in a Uint8Array, got ${mistaken}`);
  if (bytes.length > envelope.maxBytes)
    return err(`message: expected at most ${envelope.maxBytes} bytes, got ${bytes.length}`);
  try {
    const overfull = firstOverfull(bytes, envelope);
    if (overfull !== null) return err(overfull);
    const reader = protobuf.Reader.create(bytes);
    reader.discardUnknown = true;
    return ok(decode(reader));
  } catch (error) {
    const cause = error instanceof Error ? error.message : String(error);
    const hint = bytes[0] === BRACE && bytes[1] === QUOTE ? '; JSON text goes to decodeFrameJson' : '';
    return err(`message: not of this protocol (${cause})${hint}`);
  }
}

/** The characters that a JSON object begins with. */
const BRACE = 0x7b;
const QUOTE = 0x22;

/** '' for bytes; otherwise what was passed instead, and what to do. */
export function notBytes(value: unknown): string {
  if (value instanceof Uint8Array || Object.prototype.toString.call(value) === '[object Uint8Array]')
    return '';
  if (typeof value === 'string') return 'a string: JSON goes to decodeFrameJson';
  const kind = Object.prototype.toString.call(value).slice(8, -1);
  if (kind === 'ArrayBuffer') return 'an ArrayBuffer: pass new Uint8Array(buffer)';
  if (kind === 'Blob') return 'a Blob: set socket.binaryType to "arraybuffer"';
  if (kind === 'Promise') return 'a Promise: await it first';
  return kind === 'Object' || kind.endsWith('Event') ? 'an object: bytes are in the .data of an event' : kind;
}

/** The bytes in their own buffer, which may be transferred. */
export function sealEnvelope(writer: protobuf.Writer): Uint8Array<ArrayBuffer> {
  // The writer's bytes are part of a buffer that the next message shares.
  return new Uint8Array(writer.finish());
}

const LENGTH_DELIMITED = 2;

/** A message may come in several parts, which the decoder merges: entries are counted over all of them. */
function firstOverfull(bytes: Uint8Array, envelope: Envelope): string | null {
  const counts = new Map<ListLimit, number>();
  const reader = protobuf.Reader.create(bytes);
  while (reader.pos < reader.len) {
    const tag = reader.tag();
    const lists = envelope.lists.get(tag >>> 3);
    if (lists === undefined || (tag & 7) !== LENGTH_DELIMITED) {
      reader.skipType(tag & 7, 0, tag >>> 3);
      continue;
    }
    const end = reader.size() + reader.pos;
    while (reader.pos < end) {
      const inner = reader.tag();
      const list = lists.get(inner >>> 3);
      reader.skipType(inner & 7, 0, inner >>> 3);
      if (list === undefined || (inner & 7) !== LENGTH_DELIMITED) continue;
      const count = (counts.get(list) ?? 0) + 1;
      counts.set(list, count);
      if (count > list.most) return `${list.name}: expected at most ${list.most}, got more`;
    }
  }
  return null;
}
