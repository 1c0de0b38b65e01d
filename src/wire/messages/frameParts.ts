import protobuf from 'protobufjs/minimal.js';
import { frameFields } from './frame';
import { galaxy } from '../generated/codec.js';
import type { InputAcknowledgement, ServerFrame, ShipState, WorldEvent } from '../records';
import { shipStateFields } from '../fields/shipState';
import { eventFields } from '../fields/worldEvent';

/**
 * A frame's ServerMessage in parts, to send one world to many clients: each ship is encoded once, and a
 * client's frame is composed from the bytes of the ships it sees. The parts of a message may come in any order.
 */

/** Tags of length-delimited fields: ServerMessage.frame = 2, ServerFrame.ships = 6 (stream.proto). */
const FRAME_TAG = (2 << 3) | 2;
const SHIPS_TAG = (6 << 3) | 2;

/** One ship. */
export function encodeShipPart(state: ShipState): Uint8Array {
  const writer = protobuf.Writer.create().uint32(SHIPS_TAG).fork();
  return galaxy.physics.ShipState.encode(shipStateFields(state), writer).ldelim().finish();
}

/** The part common to all clients: tick, tempo, bodies. */
export function encodeCommonPart(frame: ServerFrame): Uint8Array {
  const common = frameFields({ ...frame, ships: [], events: [], lastInput: null });
  return galaxy.stream.ServerFrame.encode(common).finish();
}

/** The part of one client. */
export function encodeOwnPart(
  events: readonly WorldEvent[],
  lastInput: InputAcknowledgement | null,
): Uint8Array {
  const own = {
    events: events.map(eventFields),
    ...(lastInput !== null && { last_input: { ...lastInput } }),
  };
  return galaxy.stream.ServerFrame.encode(own).finish();
}

/** Joins the parts into the message: equal to encodeServerMessage of the whole frame, except for the order of fields. */
export function joinFrameParts(parts: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  let length = 0;
  for (const part of parts) length += part.length;
  const head = protobuf.Writer.create().uint32(FRAME_TAG).uint32(length).finish();
  const message = new Uint8Array(head.length + length);
  message.set(head);
  let at = head.length;
  for (const part of parts) {
    message.set(part, at);
    at += part.length;
  }
  return message;
}
