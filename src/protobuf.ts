/**
 * The stream's protobuf messages, bytes to checked records and back. A client that speaks the game's JSON does not need this
 * door: it costs another 25 kB.
 */
export {
  type ClientMessage,
  decodeClientMessage,
  decodeServerMessage,
  type PendingMessage,
  pendingServerMessage,
  encodeClientMessage,
  encodeServerMessage,
  type ServerMessage,
} from './wire';
