import { PROTOCOL_VERSION } from '../../protocol';
import type { Hello, InputAcknowledgement, ServerFrame, WorldEvent } from '../../wire';
import { type SharedFrame, shareFrame } from '../redis/broadcast';
import { type Client, mayTakeState, remember } from './client';
import type { Removed, WorldFrame } from '../redis/feed';
import { type Place, shipOf } from '../place';
import { NEARBY, shipsInSight } from './interest';
import { helloBytes, welcomeText } from './speech';

const shares = new WeakMap<WorldFrame, SharedFrame>();
/** Wall s between two spawns of a ship for the same player. */
const ORDER_AGAIN = 10;

/** A frame has come: each client keeps its events, and gets the newest state if its socket has room. */
export function tellAll(place: Place, world: WorldFrame): void {
  for (const client of place.clients) {
    if (client.player === null) continue;
    remember(client, world.frame.events, world.removed);
    supply(place, client, world);
    tell(place, client, world);
  }
}

/** Clients that were skipped get the newest state as soon as they have room. */
export function tellBehind(place: Place): void {
  const newest = place.feed.newest();
  if (newest === null) return;
  for (const client of place.clients)
    if (client.isBehind && client.player !== null) tell(place, client, newest);
}

/** A first state, at once. */
export function tellOne(place: Place, client: Client): void {
  const newest = place.feed.newest();
  if (newest === null) return;
  supply(place, client, newest);
  tell(place, client, newest);
}

/** The hello of a client, or null before there is a world. */
function helloFor(place: Place, client: Client): Hello | null {
  const newest = place.feed.newest();
  if (place.world === null || newest === null || client.player === null) return null;
  const { tick, tickRate, timeScale, bodies } = newest.frame;
  const { playerId } = client.player;
  return {
    ...place.world,
    protocolVersion: PROTOCOL_VERSION,
    playerId,
    shipId: shipOf(place, playerId),
    ...{ tick, tickRate, timeScale, bodies },
    inputGranularity: client.protocol === 'json' ? 'tick' : 'substep',
  };
}

function tell(place: Place, client: Client, world: WorldFrame): void {
  if (!mayTakeState(client, place.options.clock())) return;
  const { frame } = world;
  const { playerId } = client.player!;
  const own = frame.ships.findIndex((ship) => ship.playerId === playerId);
  const seen = shipsInSight(frame.ships, own, place.options.interest ?? NEARBY);
  const shared = sharedOf(world);
  followShip(place, client);
  if (client.shipId === null) return;
  const removed = client.removed.splice(0);
  const events = client.events.splice(0);
  if (client.protocol === 'json') {
    tellRemoved(client, removed);
    client.socket.send(shared.json(seen));
    return;
  }
  const lastInput = lastInputOf(client, world, own);
  client.socket.send(shared.bytes(seen, eventsInSight(events, frame, seen), lastInput));
}

function sharedOf(world: WorldFrame): SharedFrame {
  let shared = shares.get(world);
  if (shared === undefined) shares.set(world, (shared = shareFrame(world.frame)));
  return shared;
}

/** The game's two messages for a ship that is gone. */
function tellRemoved(client: Client, removed: readonly Removed[]): void {
  for (const { shipId, playerId, name, reason, body } of removed) {
    if (playerId === client.player?.playerId && reason === 'collision')
      client.socket.send(
        JSON.stringify({ type: 'ship.destroyed', ship_id: shipId, ship_name: name, body, reason }),
      );
    client.socket.send(JSON.stringify({ type: 'ship.removed', ship_id: shipId }));
  }
}

/** Events of ships in sight; those of a ship that is gone are sent to all. */
function eventsInSight(
  events: readonly WorldEvent[],
  { ships, tick }: ServerFrame,
  seen: readonly number[],
): WorldEvent[] {
  const near = new Set(seen.map((index) => ships[index]!.shipId));
  const there = new Set(ships.map(({ shipId }) => shipId));
  return events.filter((event) => event.tick <= tick && (near.has(event.shipId) || !there.has(event.shipId)));
}

/** Only of this client's session: another page of the same player has its own. */
function lastInputOf(
  client: Client,
  { frame, lastInputs }: WorldFrame,
  own: number,
): InputAcknowledgement | null {
  const last = lastInputs.get(frame.ships[own]?.shipId ?? '');
  if (last === undefined || last.session !== client.session || last.tick > frame.tick) return null;
  const { seq, tick, substep, margin } = last;
  return { seq, tick, substep, margin };
}

/** Another ship for the player is told by another welcome or hello. */
function followShip(place: Place, client: Client): void {
  if (shipOf(place, client.player!.playerId) !== client.shipId) sayHello(place, client);
}

/** The welcome: the player, the ship and the world. */
export function sayHello(place: Place, client: Client): void {
  const hello = helloFor(place, client);
  if (hello === null) return;
  client.shipId = hello.shipId;
  const { username } = client.player!;
  client.socket.send(client.protocol === 'json' ? welcomeText(hello, username) : helloBytes(hello));
}

/** A player without a ship gets one from the hangar. */
function supply(place: Place, client: Client, world: WorldFrame): void {
  const { hangar, clock } = place.options;
  const { playerId } = client.player!;
  if (world.frame.ships.some((ship) => ship.playerId === playerId)) {
    client.shiplessSince = Infinity;
    client.hadShip = true;
    return;
  }
  if (hangar === undefined || world.frame.paused) return;
  const now = clock();
  const isNew = client.shiplessSince === Infinity && !client.hadShip;
  if (client.shiplessSince === Infinity) client.shiplessSince = now - (isNew ? hangar.delay : 0);
  if (now - client.shiplessSince < hangar.delay) return;
  client.shiplessSince = now + ORDER_AGAIN - hangar.delay;
  const order = hangar.spawn(playerId, world);
  if (order !== null) place.inbox.command('spawn', order);
}
