/** Bytes and the game's JSON <-> checked plain records. Nothing behind this folder sees anything else of the outside. */

/** What the checked records are. */
export type * from './records';
/** What a server says, as bytes. */
export { decodeServerMessage, encodeServerMessage } from './messages/serverMessage';
/** The same, decoded only when it is wanted. */
export { type PendingMessage, pendingServerMessage } from './pendingMessage';
/** A frame for many clients: each ship encoded once. */
export { encodeCommonPart, encodeOwnPart, encodeShipPart, joinFrameParts } from './messages/frameParts';
/** What a client says, as bytes. */
export { decodeClientMessage, encodeClientMessage } from './messages/clientMessage';
/** The game's JSON, under any envelope: a frame, what stands in for a hello, controls, states by themselves. */
export { decodeFrameJson, type DecodedFrame, encodeFrameJson, type FrameJsonOptions } from './json/frameJson';
export { decodeHelloJson, type DecodedHello, encodeHelloJson } from './json/helloJson';
export { decodeControlsJson, encodeControlsJson } from './json/controlsJson';
export {
  decodeShipStateJson,
  decodeShipStatesJson,
  encodeShipStateJson,
  type ShipStateJson,
} from './json/shipStateJson';
/** Why a text cannot be a name or an id on the wire. */
export { textComplaint } from './fields/reading';
/** What a message may hold at most. */
export {
  MAX_BODIES,
  MAX_CLIENT_BYTES,
  MAX_INPUTS,
  MAX_SERVER_BYTES,
  MAX_SHIP_CLASSES,
  MAX_SHIPS,
  MAX_TEXT,
  MAX_TICK,
} from './limits';
