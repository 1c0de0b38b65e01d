import type { Account } from './accounts';
import type { WorldFrame } from './redis/feed';
import type { Interest } from './clients/interest';

export interface GatewayOptions {
  /** redis://… */
  readonly redis: string;
  readonly host: string;
  /** 0: any that is free. */
  readonly port: number;
  readonly accounts: readonly Account[];
  /** Of the tokens; at least 32 characters, the same for all gateways of a game. */
  readonly secret: string;
  /** Life of a token, s. */
  readonly tokenLifetime: number;
  /** Pages that may connect, beside those of this machine and clients that send no origin. */
  readonly origins: readonly string[];
  /** Wall s since 1970. */
  readonly clock: () => number;
  /** A name nobody can guess, for each connection. */
  readonly nonce: () => string;
  readonly interest?: Interest;
  /** Gives players their ships; without it a player flies what the world has for him. */
  readonly hangar?: Hangar;
  /** Called with messages for operators. */
  readonly log: (line: string) => void;
}

export interface Hangar {
  /** The id of a player's ship. */
  readonly shipId: (playerId: string) => string;
  /** The `data` of a spawn command (REDIS.md), or null where there is none for him. */
  readonly spawn: (playerId: string, world: WorldFrame) => object | null;
  /** Wall s after the loss of a ship at which the next one comes. */
  readonly delay: number;
}
