import type { RedisClientType } from 'redis';
import type { Hello } from '../wire';
import type { Accounts } from './accounts';
import type { Client } from './clients/client';
import type { GatewayOptions } from './options';
import type { Feed } from './redis/feed';
import type { Inbox } from './redis/inbox';

/** The state of one gateway. Losing it loses no game state: the world is in Redis. */
export interface GatewayState {
  readonly options: GatewayOptions;
  readonly accounts: Accounts;
  readonly redis: RedisClientType;
  readonly inbox: Inbox;
  readonly clients: Set<Client>;
  feed: Feed;
  /** World definition sent in each hello; null until the service has written it. */
  world: Hello | null;
  /** Redis clock minus local clock, s. */
  clockOffset: number;
  /** Number of invalid parts in frames and the world definition. */
  refused: number;
}

/** ID of the player's ship in the world, else of the one the hangar will spawn; '' for neither. */
export function shipOf({ feed, options }: GatewayState, playerId: string): string {
  const ship = feed.newest()?.frame.ships.find((candidate) => candidate.playerId === playerId);
  return ship?.shipId ?? options.hangar?.shipId(playerId) ?? '';
}
