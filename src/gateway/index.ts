/** Browsers on one side, Redis on the other: /ws speaks the game's JSON, /stream this project's protobuf. SCALING.md says how it grows. */

/** The gateway. */
export { createGateway, type Gateway } from './gateway';
export type { GatewayOptions, Hangar } from './options';
/** Who may sign in. */
export { type Account, type Accounts, createAccounts, type Player } from './accounts';
