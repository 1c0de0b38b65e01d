import type { InputRecord, WorldEvent } from '../../wire';
import { type Client, countExcess, disconnect } from './client';
import type { GatewayState } from '../state';
import type { OwnInput } from '../redis/inbox';
import { CLOSE, consume, MAX_BUFFERED, MAX_QUEUED_MESSAGES, MAX_RESENT_EVENTS } from './limits';
import { errorText, pongBytes, readBytes, readText, type ClientMessage } from './messages';
import { sendHello, sendNewest } from './send';

/** ms: setTimeout holds no more. */
const MAX_TIMER = 2 ** 31 - 1;

/** Handles a client's message. An invalid message can at worst close its own connection. */
export function receive(gateway: GatewayState, client: Client, data: Buffer, isBinary: boolean): void {
  if (client.isClosing) return;
  if (!consume(client.messages, 1, gateway.options.clock())) {
    countExcess(client, gateway.options.clock());
    return;
  }
  if (isBinary && client.protocol === 'json') {
    refuse(gateway, client, 'message: expected text');
    return;
  }
  const message = isBinary ? readBytes(new Uint8Array(data)) : readText(data.toString());
  if (client.player !== null) handle(gateway, client, message);
  else if (client.queued !== null) {
    if (client.queued.length < MAX_QUEUED_MESSAGES) client.queued.push(message);
  } else if (message.kind === 'auth') startSignIn(gateway, client, message);
  else disconnect(client, CLOSE.auth, 'Sign in first');
}

/** Handles a WebSocket ping frame, which browsers cannot send. It counts as a message and is answered if the socket has room. */
export function receivePing(gateway: GatewayState, client: Client, data: Buffer): void {
  if (client.isClosing) return;
  const now = gateway.options.clock();
  if (!consume(client.messages, 1, now)) countExcess(client, now);
  else if (client.socket.bufferedAmount <= MAX_BUFFERED) client.socket.pong(data);
}

/** Starts the sign-in. Messages that arrive before the token is verified are queued. */
function startSignIn(gateway: GatewayState, client: Client, auth: ClientMessage & { kind: 'auth' }): void {
  client.queued = [];
  signIn(gateway, client, auth)
    .then(() => {
      const { queued, player } = client;
      client.queued = null;
      if (player !== null) for (const message of queued ?? []) handle(gateway, client, message);
    })
    .catch(() => disconnect(client, CLOSE.auth, 'Sign-in failed'));
}

function handle(gateway: GatewayState, client: Client, message: ClientMessage): void {
  switch (message.kind) {
    case 'auth':
      // Signed in already.
      break;
    case 'ping':
      answerPing(gateway, client, message.id);
      break;
    case 'control':
      if (client.protocol === 'stream') {
        refuse(gateway, client, 'control: /stream takes inputs');
        return;
      }
      client.seq += 1;
      forward(gateway, client, { seq: client.seq, controls: message.controls, stamp: null });
      break;
    case 'inputs':
      forwardInputs(gateway, client, message.inputs);
      break;
    case 'refused':
      refuse(gateway, client, message.reason);
      break;
  }
}

async function signIn(
  gateway: GatewayState,
  client: Client,
  { token, session, since }: ClientMessage & { kind: 'auth' },
): Promise<void> {
  const player = await gateway.accounts.verify(token);
  if (player === null) {
    disconnect(client, CLOSE.auth, 'Invalid or expired token');
    return;
  }
  const missed = since === null || client.protocol === 'json' ? [] : await eventsSince(gateway, since);
  if (client.socket.readyState !== client.socket.OPEN) return;
  for (const timer of client.timers) clearTimeout(timer);
  client.timers.clear();
  client.player = player;
  client.session = session === '' ? gateway.options.nonce() : session;
  client.events.push(...missed);
  announceJoin(gateway, client);
  scheduleTokenRenewal(gateway, client);
  sendHello(gateway, client);
  sendNewest(gateway, client);
}

/** Events that the client missed; none if Redis fails, so that the client can still sign in. */
async function eventsSince({ feed }: GatewayState, since: number): Promise<readonly WorldEvent[]> {
  try {
    return await feed.eventsSince(since, MAX_RESENT_EVENTS);
  } catch {
    return [];
  }
}

function announceJoin({ clients }: GatewayState, client: Client): void {
  const { playerId, username } = client.player!;
  const text = JSON.stringify({ type: 'player_joined', player_id: playerId, username });
  for (const other of clients)
    if (other !== client && other.player !== null && other.protocol === 'json' && !other.isBehind)
      other.socket.send(text);
}

/** On /ws, renews the token halfway through its life. Closes the connection when the token expires. */
function scheduleTokenRenewal(gateway: GatewayState, client: Client): void {
  const player = client.player!;
  const left = Math.max(0, player.expires - gateway.options.clock());
  const after = (seconds: number, callback: () => void) =>
    client.timers.add(setTimeout(callback, Math.min(seconds * 1000, MAX_TIMER)));
  after(left, () => disconnect(client, CLOSE.auth, 'The token has expired'));
  if (client.protocol === 'stream') return;
  after(left / 2, () => {
    gateway.accounts
      .renew(player)
      .then((token) => client.socket.send(JSON.stringify({ type: 'token_refresh', token })))
      .catch((error: unknown) => gateway.options.log(`token: ${String(error)}`));
  });
}

function answerPing(gateway: GatewayState, client: Client, id: number | null): void {
  const newest = gateway.feed.newest();
  if (id === null) client.socket.send(JSON.stringify({ type: 'pong' }));
  else if (newest !== null) {
    const since = gateway.options.clock() + gateway.clockOffset - newest.due;
    client.socket.send(pongBytes(id, newest.frame.tick, Math.max(-1e9, Math.min(1e9, since))));
  }
}

function forwardInputs(gateway: GatewayState, client: Client, inputs: readonly InputRecord[]): void {
  if (!consume(client.inputs, inputs.length, gateway.options.clock())) {
    countExcess(client, gateway.options.clock());
    return;
  }
  for (const { seq, tick, substep, controls } of inputs)
    forward(gateway, client, { seq, controls, stamp: { tick, substep } });
}

/** Forwards controls to the service, always for the player's ship. */
function forward(
  gateway: GatewayState,
  { player, session }: Client,
  input: Pick<OwnInput, 'seq' | 'controls' | 'stamp'>,
): void {
  const { playerId } = player!;
  const ship = gateway.feed.newest()?.frame.ships.find((candidate) => candidate.playerId === playerId);
  if (ship !== undefined) gateway.inbox.controls({ ...input, shipId: ship.shipId, playerId, session });
}

function refuse(gateway: GatewayState, client: Client, reason: string): void {
  if (countExcess(client, gateway.options.clock())) return;
  if (client.protocol === 'json') client.socket.send(errorText('E001', reason));
}
