/** The game's WebSocket: connect, authenticate, read its JSON, send controls. GAME.md describes the published protocol. */

/** The connection itself. */
export { createGameConnection, type GameConnection } from './connection';
export type { GameClock, GameConnectionOptions, GameHandlers } from './options';
export { type GameSocket, MAX_MESSAGE } from './socket';
/** The same link for another protocol. */
export { createDriver, type Driver, type DriverOptions } from './driver';
/** Its states as plain data. */
export {
  beginLink,
  type Ending,
  type Effect,
  type LinkEvent,
  type LinkState,
  type Phase,
  type Step,
  stepLink,
} from './link';
/** A description of a state for the player. */
export { type LinkStatus, statusOf } from './statusText';
/** The game's envelopes: replace them where they differ. */
export { type GameMessage, openGameMessage, packControls } from './envelope';
