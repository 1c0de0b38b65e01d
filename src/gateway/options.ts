import type { Account } from './accounts';
import type { WorldFrame } from './redis/feed';
import type { Interest } from './clients/interest';

export interface GatewayOptions {
  /** URL, redis://… */
  readonly redis: string;
  readonly host: string;
  /** 0 for any free port. */
  readonly port: number;
  readonly accounts: readonly Account[];
  /** Signs the tokens; at least 32 characters, the same for all gateways of a game. */
  readonly secret: string;
  /** Lifetime of a token, s. */
  readonly tokenLifetime: number;
  /** Origins that may connect, besides localhost and clients that send no origin. */
  readonly origins: readonly string[];
  /** Wall s since 1970. */
  readonly clock: () => number;
  /** Returns an unguessable session ID. */
  readonly nonce: () => string;
  /** DEFAULT_INTEREST by default. */
  readonly interest?: Interest;
  /** Spawns ships for players without one. Without a hangar a player flies only a ship that the world already has. */
  readonly hangar?: Hangar;
  /** Called with messages for operators. */
  readonly log: (line: string) => void;
}

/** Spawns ships for players without one. */
export interface Hangar {
  /** ID of a player's ship. */
  readonly shipId: (playerId: string) => string;
  /** The `data` of a spawn command (REDIS.md), or null if the player gets no ship. */
  readonly spawn: (playerId: string, world: WorldFrame) => object | null;
  /** Time from the loss of a ship to the next spawn, wall s. */
  readonly delay: number;
}
