/** The game's WebSocket: connect, authenticate, read its JSON, send controls. GAME.md says what the game publishes. */

/** The connection itself, with its words for what is wrong. */
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
/** What a person is told of a state. */
export { type LinkStatus, statusOf } from './words';
/** How the game packs its messages: replace where it differs. */
export { type GameMessage, openGameMessage, packControls } from './envelope';
