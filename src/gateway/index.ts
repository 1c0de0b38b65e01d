/** Connects browsers to Redis: the game's JSON on /ws, this project's protobuf on /stream. SCALING.md covers several machines. */

/** The gateway. */
export { createGateway, type Gateway } from './gateway';
export type { GatewayOptions, Hangar } from './options';
/** Accounts and tokens. */
export { type Account, type Accounts, createAccounts, type Player } from './accounts';
