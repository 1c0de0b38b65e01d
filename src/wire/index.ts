/** Bytes and the game's JSON <-> checked plain records. Other rooms see outside data only as these records. */

/** The checked records. */
export type * from './records';
/** Server messages, as bytes. */
export { decodeServerMessage, encodeServerMessage } from './messages/serverMessage';
/** Server messages that are decoded on demand. */
export { type PendingMessage, pendingServerMessage } from './pendingMessage';
/** A frame for many clients: each ship encoded once. */
export { encodeCommonPart, encodeOwnPart, encodeShipPart, joinFrameParts } from './messages/frameParts';
/** Client messages, as bytes. */
export { decodeClientMessage, encodeClientMessage } from './messages/clientMessage';
/** The game's JSON, without its envelope: frames, hellos, controls, single states. */
export {
  decodeFrameJson,
  type DecodedFrame,
  decodeLeanFrameJson,
  encodeFrameJson,
  type FrameJsonOptions,
} from './json/frameJson';
export { decodeHelloJson, type DecodedHello, encodeHelloJson } from './json/helloJson';
export { decodeControlsJson, encodeControlsJson } from './json/controlsJson';
export {
  decodeShipStateJson,
  decodeShipStatesJson,
  encodeShipStateJson,
  type ShipStateJson,
} from './json/shipStateJson';
/** Why a string cannot be a name or an id on the wire. */
export { textFault } from './fields/reading';
/** Limits of a message. */
export {
  MAX_BODIES,
  MAX_CLIENT_BYTES,
  MAX_INPUTS,
  MAX_SERVER_BYTES,
  MAX_SHIPS,
  MAX_TEXT,
  MAX_TICK,
} from './limits';
