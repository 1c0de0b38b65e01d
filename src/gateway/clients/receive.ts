import type { InputRecord, WorldEvent } from '../../wire';
import { type Client, countExcess, dismiss } from './client';
import type { Place } from '../place';
import type { OwnInput } from '../redis/inbox';
import { CLOSE, MAX_BUFFERED, MAX_EARLY, take } from './limits';
import { errorText, pongBytes, readBytes, readText, type Said } from './speech';
import { sayHello, tellOne } from './tell';

/** Handles a client's message: an invalid one can end its connection, nothing else. */
export function receive(place: Place, client: Client, data: Buffer, isBinary: boolean): void {
  if (client.isDismissed) return;
  if (!take(client.messages, 1, place.options.clock())) {
    countExcess(client, place.options.clock());
    return;
  }
  if (isBinary && client.protocol === 'json') {
    refuse(place, client, 'message: expected text');
    return;
  }
  const said = isBinary ? readBytes(new Uint8Array(data)) : readText(data.toString());
  if (client.player !== null) act(place, client, said);
  else if (client.early !== null) {
    if (client.early.length < MAX_EARLY) client.early.push(said);
  } else if (said.kind === 'auth') beginSignIn(place, client, said);
  else dismiss(client, CLOSE.auth, 'Sign in first');
}

/** A ping of the WebSocket's own, which a browser cannot send: a message like any other, answered where there is room. */
export function receivePing(place: Place, client: Client, data: Buffer): void {
  if (client.isDismissed) return;
  const now = place.options.clock();
  if (!take(client.messages, 1, now)) countExcess(client, now);
  else if (client.socket.bufferedAmount <= MAX_BUFFERED) client.socket.pong(data);
}

/** Messages that follow the sign-in at once wait until the token has been verified. */
function beginSignIn(place: Place, client: Client, auth: Said & { kind: 'auth' }): void {
  client.early = [];
  signIn(place, client, auth)
    .then(() => {
      const { early, player } = client;
      client.early = null;
      if (player !== null) for (const said of early ?? []) act(place, client, said);
    })
    .catch(() => dismiss(client, CLOSE.auth, 'Sign-in failed'));
}

function act(place: Place, client: Client, said: Said): void {
  switch (said.kind) {
    case 'auth':
      // Signed in already.
      break;
    case 'ping':
      answerPing(place, client, said.id);
      break;
    case 'control':
      if (client.protocol === 'stream') {
        refuse(place, client, 'control: /stream takes inputs');
        return;
      }
      client.seq += 1;
      pass(place, client, { seq: client.seq, controls: said.controls, stamp: null });
      break;
    case 'inputs':
      passInputs(place, client, said.inputs);
      break;
    case 'refused':
      refuse(place, client, said.reason);
      break;
  }
}

async function signIn(
  place: Place,
  client: Client,
  { token, session, since }: Said & { kind: 'auth' },
): Promise<void> {
  const player = await place.accounts.verify(token);
  if (player === null) {
    dismiss(client, CLOSE.auth, 'Invalid or expired token');
    return;
  }
  const missed = since === null || client.protocol === 'json' ? [] : await eventsSince(place, since);
  if (client.socket.readyState !== client.socket.OPEN) return;
  for (const timer of client.timers) clearTimeout(timer);
  client.timers.clear();
  client.player = player;
  client.session = session === '' ? place.options.nonce() : session;
  client.events.push(...missed);
  announce(place, client);
  keepToken(place, client);
  sayHello(place, client);
  tellOne(place, client);
}

/** Sends the events of the client's absence; a failure of Redis does not keep it out. */
async function eventsSince({ feed }: Place, since: number): Promise<readonly WorldEvent[]> {
  try {
    return await feed.eventsSince(since, 500);
  } catch {
    return [];
  }
}

function announce({ clients }: Place, client: Client): void {
  const { playerId, username } = client.player!;
  const text = JSON.stringify({ type: 'player_joined', player_id: playerId, username });
  for (const other of clients)
    if (other !== client && other.player !== null && other.protocol === 'json' && !other.isBehind)
      other.socket.send(text);
}

/** A new token half-way through the old one's life, on /ws; the end of the connection at its end. */
function keepToken(place: Place, client: Client): void {
  const player = client.player!;
  const left = Math.max(0, player.expires - place.options.clock());
  const after = (seconds: number, act: () => void) =>
    // setTimeout holds at most 2³¹ ms.
    client.timers.add(setTimeout(act, Math.min(seconds * 1000, 2 ** 31 - 1)));
  after(left, () => dismiss(client, CLOSE.auth, 'The token has expired'));
  if (client.protocol === 'stream') return;
  after(left / 2, () => {
    place.accounts
      .renew(player)
      .then((token) => client.socket.send(JSON.stringify({ type: 'token_refresh', token })))
      .catch((error: unknown) => place.options.log(`token: ${String(error)}`));
  });
}

function answerPing(place: Place, client: Client, id: number | null): void {
  const newest = place.feed.newest();
  if (id === null) client.socket.send(JSON.stringify({ type: 'pong' }));
  else if (newest !== null) {
    const since = place.options.clock() + place.clockOffset - newest.due;
    client.socket.send(pongBytes(id, newest.frame.tick, Math.max(-1e9, Math.min(1e9, since))));
  }
}

function passInputs(place: Place, client: Client, inputs: readonly InputRecord[]): void {
  if (!take(client.inputs, inputs.length, place.options.clock())) {
    countExcess(client, place.options.clock());
    return;
  }
  for (const { seq, tick, substep, controls } of inputs)
    pass(place, client, { seq, controls, stamp: { tick, substep } });
}

/** Always for the player's own ship. */
function pass(
  place: Place,
  { player, session }: Client,
  input: Pick<OwnInput, 'seq' | 'controls' | 'stamp'>,
): void {
  const { playerId } = player!;
  const ship = place.feed.newest()?.frame.ships.find((candidate) => candidate.playerId === playerId);
  if (ship !== undefined) place.inbox.controls({ ...input, shipId: ship.shipId, playerId, session });
}

function refuse(place: Place, client: Client, reason: string): void {
  if (countExcess(client, place.options.clock())) return;
  if (client.protocol === 'json') client.socket.send(errorText('E001', reason));
}
