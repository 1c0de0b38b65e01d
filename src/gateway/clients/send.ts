import { PROTOCOL_VERSION } from '../../protocol';
import type { Hello, InputAcknowledgement, ServerFrame, WorldEvent } from '../../wire';
import { type SharedFrame, shareFrame } from '../redis/sharedFrame';
import { type Client, canSendState, queueEvents } from './client';
import type { Removed, WorldFrame } from '../redis/feed';
import { type GatewayState, shipOf } from '../state';
import { DEFAULT_INTEREST, shipsInSight } from './interest';
import { helloBytes, welcomeText } from './messages';

const sharedFrames = new WeakMap<WorldFrame, SharedFrame>();
/** Minimum time between two spawn commands for one player, wall s. */
const RESPAWN_INTERVAL = 10;

/** Queues a new frame's events for each client and sends its state to clients whose socket has room. */
export function broadcastFrame(gateway: GatewayState, world: WorldFrame): void {
  for (const client of gateway.clients) {
    if (client.player === null) continue;
    queueEvents(client, world.frame.events, world.removed);
    spawnIfShipless(gateway, client, world);
    sendState(gateway, client, world);
  }
}

/** Sends the newest state to skipped clients whose socket has room again. */
export function resendToSlow(gateway: GatewayState): void {
  const newest = gateway.feed.newest();
  if (newest === null) return;
  for (const client of gateway.clients)
    if (client.isBehind && client.player !== null) sendState(gateway, client, newest);
}

/** Sends one client the newest state without waiting for the next frame. */
export function sendNewest(gateway: GatewayState, client: Client): void {
  const newest = gateway.feed.newest();
  if (newest === null) return;
  spawnIfShipless(gateway, client, newest);
  sendState(gateway, client, newest);
}

/** The hello for a client, or null before there is a world. */
function helloFor(gateway: GatewayState, client: Client): Hello | null {
  const newest = gateway.feed.newest();
  if (gateway.world === null || newest === null || client.player === null) return null;
  const { tick, tickRate, timeScale, bodies } = newest.frame;
  const { playerId } = client.player;
  return {
    ...gateway.world,
    protocolVersion: PROTOCOL_VERSION,
    playerId,
    shipId: shipOf(gateway, playerId),
    tick,
    tickRate,
    timeScale,
    bodies,
    inputGranularity: client.protocol === 'json' ? 'tick' : 'substep',
  };
}

function sendState(gateway: GatewayState, client: Client, world: WorldFrame): void {
  if (!canSendState(client, gateway.options.clock())) return;
  const { frame } = world;
  const { playerId } = client.player!;
  const own = frame.ships.findIndex((ship) => ship.playerId === playerId);
  const seen = shipsInSight(frame.ships, own, gateway.options.interest ?? DEFAULT_INTEREST);
  const shared = sharedFrameOf(world);
  updateShip(gateway, client);
  if (client.shipId === null) return;
  const removed = client.removed.splice(0);
  const events = client.events.splice(0);
  if (client.protocol === 'json') {
    sendRemovals(client, removed);
    client.socket.send(shared.json(seen));
    return;
  }
  const lastInput = lastInputOf(client, world, own);
  client.socket.send(shared.bytes(seen, eventsInSight(events, frame, seen), lastInput));
}

function sharedFrameOf(world: WorldFrame): SharedFrame {
  let shared = sharedFrames.get(world);
  if (shared === undefined) sharedFrames.set(world, (shared = shareFrame(world.frame)));
  return shared;
}

/** Sends the game's `ship.destroyed` (to the owner, after a collision) and `ship.removed`. */
function sendRemovals(client: Client, removed: readonly Removed[]): void {
  for (const { shipId, playerId, name, reason, body } of removed) {
    if (playerId === client.player?.playerId && reason === 'collision')
      client.socket.send(
        JSON.stringify({ type: 'ship.destroyed', ship_id: shipId, ship_name: name, body, reason }),
      );
    client.socket.send(JSON.stringify({ type: 'ship.removed', ship_id: shipId }));
  }
}

/** Events of ships in the client's area of interest, and of ships that no longer exist. */
function eventsInSight(
  events: readonly WorldEvent[],
  { ships, tick }: ServerFrame,
  seen: readonly number[],
): WorldEvent[] {
  const near = new Set(seen.map((index) => ships[index]!.shipId));
  const there = new Set(ships.map(({ shipId }) => shipId));
  return events.filter((event) => event.tick <= tick && (near.has(event.shipId) || !there.has(event.shipId)));
}

/** The last applied input, if it came from this client's session; another page of the same player has its own. */
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

/** Sends a new hello if the player has another ship. */
function updateShip(gateway: GatewayState, client: Client): void {
  if (shipOf(gateway, client.player!.playerId) !== client.shipId) sendHello(gateway, client);
}

/** Sends player, ship and world: the game's welcome on /ws, a hello on /stream. */
export function sendHello(gateway: GatewayState, client: Client): void {
  const hello = helloFor(gateway, client);
  if (hello === null) return;
  client.shipId = hello.shipId;
  const { username } = client.player!;
  client.socket.send(client.protocol === 'json' ? welcomeText(hello, username) : helloBytes(hello));
}

/** Has the hangar spawn a ship for a player without one. */
function spawnIfShipless(gateway: GatewayState, client: Client, world: WorldFrame): void {
  const { hangar, clock } = gateway.options;
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
  client.shiplessSince = now + RESPAWN_INTERVAL - hangar.delay;
  const command = hangar.spawn(playerId, world);
  if (command !== null) gateway.inbox.command('spawn', command);
}
