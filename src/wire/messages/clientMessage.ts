import { type Result, err } from '../../dynamics';
import { controlFields, readControlFields } from '../fields/controls';
import { type Envelope, openEnvelope, sealEnvelope } from './envelope';
import { galaxy } from '../generated/codec.js';
import { MAX_CLIENT_BYTES, MAX_INPUTS, MAX_SUBSTEPS, MAX_TICK } from '../limits';
import {
  beginReading,
  endReading,
  type Fields,
  fieldsOf,
  integerIn,
  listIn,
  messageIn,
  type Reading,
} from '../fields/reading';
import type { ClientMessage, InputRecord } from '../records';

/** Field numbers of ClientMessage and ClientFrame in stream.proto. */
const ENVELOPE: Envelope = {
  maxBytes: MAX_CLIENT_BYTES,
  lists: new Map([[1, new Map([[1, { name: 'inputs', most: MAX_INPUTS }]])]]),
};

/**
 * Decodes a client's message, for the authority: checked, finite, plain; or the reason why it is refused, with the path of the
 * first invalid field ("inputs[2].controls.thrust_level: …"). Controls are clamped into range. Never throws, whatever the
 * bytes (PREDICTION, Inputs).
 *
 * @example
 * ```ts
 * const message = decodeClientMessage(bytes);
 * if (message.ok && message.value.kind === 'inputs') console.log(message.value.inputs.length);
 * ```
 */
export function decodeClientMessage(bytes: Uint8Array): Result<ClientMessage> {
  const opened = openEnvelope(bytes, ENVELOPE, (reader) => galaxy.stream.ClientMessage.decode(reader));
  if (!opened.ok) return opened;
  const { inputs, ping } = opened.value;
  if (inputs) {
    const r = beginReading('protobuf');
    return endReading(r, {
      kind: 'inputs',
      inputs: listIn(r, fieldsOf(r, inputs), 'inputs', MAX_INPUTS, readInput),
    });
  }
  if (ping) {
    const r = beginReading('protobuf', 'ping');
    return endReading(r, {
      kind: 'ping',
      id: integerIn(r, fieldsOf(r, ping), 'id', 0, Number.MAX_SAFE_INTEGER),
    });
  }
  return err('message: expected inputs or a ping');
}

/**
 * Encodes a checked message into its own buffer. Decoding restores the record bit by bit.
 * @throws RangeError for anything but a message from takeOutgoing
 *
 * @example
 * ```ts
 * for (const message of predictor.takeOutgoing()) socket.send(encodeClientMessage(message));
 * ```
 */
export function encodeClientMessage(message: ClientMessage): Uint8Array<ArrayBuffer> {
  const kind: unknown = (message as ClientMessage | null | undefined)?.kind;
  if (kind !== 'ping' && kind !== 'inputs')
    throw new RangeError(
      `message.kind: expected inputs or ping, got ${String(kind)}. Encode each message of takeOutgoing.`,
    );
  const fields: galaxy.stream.ClientMessage.$Properties =
    message.kind === 'ping'
      ? { ping: { id: message.id } }
      : { inputs: { inputs: message.inputs.map(inputFields) } };
  return sealEnvelope(galaxy.stream.ClientMessage.encode(fields));
}

function readInput(r: Reading, from: Fields): InputRecord {
  return {
    seq: integerIn(r, from, 'seq', 1, Number.MAX_SAFE_INTEGER),
    tick: integerIn(r, from, 'tick', 0, MAX_TICK),
    substep: integerIn(r, from, 'substep', 0, MAX_SUBSTEPS - 1),
    controls: messageIn(r, from, 'controls', readControlFields),
  };
}

function inputFields({ seq, tick, substep, controls }: InputRecord): galaxy.stream.Input.$Properties {
  return { seq, tick, substep, controls: controlFields(controls) };
}
