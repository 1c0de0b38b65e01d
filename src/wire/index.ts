/** Bytes and the game's JSON <-> checked plain records. Nothing behind this folder sees anything else of the outside. */

/** What the checked records are. */
export type * from './records';
/** What a server says, as bytes. */
export { decodeServerMessage, encodeServerMessage } from './serverMessage';
/** What a client says, as bytes. */
export { decodeClientMessage, encodeClientMessage } from './clientMessage';
/** The game's ShipState as JSON. */
export {
  decodeShipStateJson,
  decodeShipStatesJson,
  encodeShipStateJson,
  type ShipStateJson,
} from './shipStateJson';
/** What a message may hold at most. */
export {
  MAX_BODIES,
  MAX_CLIENT_BYTES,
  MAX_EVENTS,
  MAX_INPUTS,
  MAX_SERVER_BYTES,
  MAX_SHIP_CLASSES,
  MAX_SHIPS,
  MAX_SUBSTEPS,
  MAX_TEXT,
} from './limits';
