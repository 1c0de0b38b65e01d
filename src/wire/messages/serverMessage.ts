import { type Result, err } from '../../dynamics';
import { type Envelope, openEnvelope, sealEnvelope } from './envelope';
import { frameFields, readFrame } from './frame';
import { galaxy } from '../generated/codec.js';
import { helloFields, readHello } from './hello';
import {
  MAX_BODIES,
  MAX_EVENTS,
  MAX_SERVER_BYTES,
  MAX_SHIP_CLASSES,
  MAX_SHIPS,
  MAX_TICK,
  WALL_SECONDS,
} from '../limits';
import {
  beginReading,
  endReading,
  type Fields,
  fieldsOf,
  integerIn,
  numberIn,
  type Reading,
} from '../fields/reading';
import type { Pong, ServerMessage } from '../records';

/** Field numbers of ServerMessage, Hello and ServerFrame in stream.proto. */
const ENVELOPE: Envelope = {
  maxBytes: MAX_SERVER_BYTES,
  lists: new Map([
    [
      1,
      new Map([
        [4, { name: 'hello.ship_classes', most: MAX_SHIP_CLASSES }],
        [5, { name: 'hello.bodies', most: MAX_BODIES }],
      ]),
    ],
    [
      2,
      new Map([
        [5, { name: 'frame.bodies', most: MAX_BODIES }],
        [6, { name: 'frame.ships', most: MAX_SHIPS }],
        [7, { name: 'frame.events', most: MAX_EVENTS }],
      ]),
    ],
  ]),
};

/**
 * Decodes a server's message: checked, finite, plain; or the reason why it is refused, with the path of the first invalid field
 * ("frame.ships[3].relative_position.y: expected a finite number, got NaN"). Never throws, whatever the bytes.
 * SI units, ICRF axes, quaternions [x, y, z, w] (PREDICTION, Server messages).
 *
 * @example
 * ```ts
 * const message = decodeServerMessage(bytes); // new Uint8Array(event.data)
 * if (message.ok) predictor.receive(message.value, now);
 * else predictor.refused(message.reason);
 * ```
 */
export function decodeServerMessage(bytes: Uint8Array): Result<ServerMessage> {
  const opened = openEnvelope(bytes, ENVELOPE, (reader) => galaxy.stream.ServerMessage.decode(reader));
  if (!opened.ok) return opened;
  const { hello, frame, pong } = opened.value;
  if (hello) return read('hello', hello, readHello);
  if (frame) return read('frame', frame, readFrame);
  if (pong) return read('pong', pong, readPong);
  return err('message: expected a hello, a frame or a pong');
}

/**
 * Encodes a checked message into its own buffer. Decoding restores the record bit by bit.
 *
 * @example
 * ```ts
 * const bytesOfPong = encodeServerMessage({ kind: 'pong', id: 1, tick: 240, sinceTick: 0.25 });
 * console.log(bytesOfPong.length);
 * ```
 */
export function encodeServerMessage(message: ServerMessage): Uint8Array<ArrayBuffer> {
  return sealEnvelope(galaxy.stream.ServerMessage.encode(envelopeFields(message)));
}

function envelopeFields(message: ServerMessage): galaxy.stream.ServerMessage.$Properties {
  switch (message.kind) {
    case 'hello':
      return { hello: helloFields(message) };
    case 'frame':
      return { frame: frameFields(message) };
    case 'pong':
      return { pong: { id: message.id, tick: message.tick, since_tick: message.sinceTick } };
  }
}

function read<T>(name: string, message: unknown, reader: (r: Reading, from: Fields) => T): Result<T> {
  const r = beginReading('protobuf', name);
  return endReading(r, reader(r, fieldsOf(r, message)));
}

function readPong(r: Reading, from: Fields): Pong {
  return {
    kind: 'pong',
    id: integerIn(r, from, 'id', 0, Number.MAX_SAFE_INTEGER),
    tick: integerIn(r, from, 'tick', 0, MAX_TICK),
    sinceTick: numberIn(r, from, 'since_tick', WALL_SECONDS),
  };
}
