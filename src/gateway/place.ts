import type { RedisClientType } from 'redis';
import type { Hello } from '../wire';
import type { Accounts } from './accounts';
import type { Client } from './clients/client';
import type { GatewayOptions } from './options';
import type { Feed } from './redis/feed';
import type { Inbox } from './redis/inbox';

/** The state of one gateway. It may be lost at any time: the world is in Redis. */
export interface Place {
  readonly options: GatewayOptions;
  readonly accounts: Accounts;
  readonly redis: RedisClientType;
  readonly inbox: Inbox;
  readonly clients: Set<Client>;
  feed: Feed;
  /** The world definition for every hello; null before the service has written it. */
  world: Hello | null;
  /** Redis's clock less ours, s. */
  clockOffset: number;
  refused: number;
}

/** The ship that the world has for a player, or that it will have. */
export function shipOf({ feed, options }: Place, playerId: string): string {
  const ship = feed.newest()?.frame.ships.find((candidate) => candidate.playerId === playerId);
  return ship?.shipId ?? options.hangar?.shipId(playerId) ?? '';
}
