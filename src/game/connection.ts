import type { Controls } from '../dynamics';
import { decodeFrameJson } from '../wire';
import { asObject, type GameMessage, openGameMessage, packControls } from './envelope';
import { beginLink, dueAt, type Effect, type LinkEvent, type LinkState, type Step, stepLink } from './link';
import type { GameConnectionOptions, GameHandlers } from './options';
import { abandon, type GameSocket, isTooLarge, MAX_MESSAGE, OPEN } from './socket';
import { type LinkStatus, statusOf } from './words';

/** One link to the game's server, which reconnects by itself; at most one socket at any time. */
export interface GameConnection {
  readonly state: () => LinkState;
  readonly status: () => LinkStatus;
  /** Own controls; false when they could not be sent (not live, or too large). */
  readonly sendControls: (controls: Controls) => boolean;
  /** Any other message of the game's: service, attitude modes. */
  readonly send: (message: unknown) => boolean;
  /** Tries again at once, after a refusal too. */
  readonly retry: () => void;
  readonly dispose: () => void;
}

interface Link {
  readonly options: GameConnectionOptions;
  readonly handlers: GameHandlers;
  state: LinkState;
  token: string;
  socket: GameSocket | null;
  cancelTimer: (() => void) | null;
  told: string;
  lastStateAt: number;
  /** Usual wall s between two states. */
  interval: number;
}

/** Connects at once. Nothing throws, whatever the server sends. */
export function createGameConnection(options: GameConnectionOptions, handlers: GameHandlers): GameConnection {
  const first = beginLink(options.clock.now());
  const link: Link = {
    options,
    handlers,
    state: first.state,
    token: options.token,
    socket: null,
    cancelTimer: null,
    told: '',
    lastStateAt: NaN,
    interval: 1,
  };
  apply(link, first);
  return {
    state: () => link.state,
    status: () => statusOf(link.state, options.address, options.clock.now()),
    sendControls: (controls) => say(link, (options.pack ?? packControls)(controls)),
    send: (message) => say(link, message),
    retry: () => happen(link, { kind: 'retry' }),
    dispose: () => happen(link, { kind: 'end' }),
  };
}

function happen(link: Link, event: LinkEvent): void {
  const { clock, dice } = link.options;
  apply(link, stepLink(link.state, event, clock.now(), dice()));
}

function apply(link: Link, { state, effects }: Step): void {
  link.state = state;
  const failed = effects.map((effect) => perform(link, effect)).find((reason) => reason !== null);
  schedule(link);
  tellStatus(link);
  if (failed !== undefined) happen(link, { kind: 'closed', code: 0, reason: failed });
}

/** Why no socket could be made, or null. */
function perform(link: Link, effect: Effect): string | null {
  switch (effect) {
    case 'open':
      drop(link);
      return open(link);
    case 'auth':
      write(link, { type: 'auth', token: link.token });
      return null;
    case 'ping':
      write(link, { type: 'ping' });
      return null;
    case 'close':
      drop(link);
      return null;
  }
}

function drop(link: Link): void {
  const { socket } = link;
  link.socket = null;
  if (socket !== null) abandon(socket);
}

function open(link: Link): string | null {
  link.lastStateAt = NaN;
  let socket: GameSocket;
  try {
    socket = link.options.openSocket(link.options.address);
  } catch (error) {
    return error instanceof Error ? error.message : String(error);
  }
  link.socket = socket;
  socket.onopen = () => happen(link, { kind: 'opened' });
  socket.onmessage = ({ data }) => take(link, data);
  socket.onclose = ({ code, reason }) => happen(link, { kind: 'closed', code, reason });
  // Told by the close that follows.
  socket.onerror = () => undefined;
  return null;
}

function schedule(link: Link): void {
  const { clock } = link.options;
  const due = dueAt(link.state);
  link.cancelTimer?.();
  link.cancelTimer =
    due === Infinity
      ? null
      : clock.after(Math.max(0, due - clock.now()), () => happen(link, { kind: 'time' }));
}

function tellStatus(link: Link): void {
  const status = statusOf(link.state, link.options.address, link.options.clock.now());
  const key = `${status.phase} ${status.words}`;
  if (key === link.told) return;
  link.told = key;
  link.handlers.onStatus?.(status);
}

function say(link: Link, message: unknown): boolean {
  return link.state.phase === 'live' && write(link, message);
}

function write(link: Link, message: unknown): boolean {
  const text = JSON.stringify(message);
  if (link.socket?.readyState !== OPEN) return false;
  if (isTooLarge(text)) {
    link.handlers.onRefused?.(`message: expected at most ${MAX_MESSAGE} bytes`);
    return false;
  }
  link.socket.send(text);
  return true;
}

function take(link: Link, data: unknown): void {
  const refuse = (reason: string) => link.handlers.onRefused?.(reason);
  if (typeof data !== 'string') return refuse('message: expected text, got bytes');
  if (isTooLarge(data))
    return refuse(`message: expected at most ${MAX_MESSAGE} bytes, got ${data.length} characters`);
  let message: unknown;
  try {
    message = JSON.parse(data);
  } catch {
    return refuse('message: not JSON');
  }
  act(link, (link.options.open ?? openGameMessage)(message));
}

function act(link: Link, message: GameMessage): void {
  const { handlers } = link;
  switch (message.kind) {
    case 'welcome':
      if (link.state.phase !== 'authenticating') return;
      happen(link, { kind: 'welcome' });
      handlers.onWelcome?.(asObject(message.about));
      break;
    case 'state':
      takeState(link, message.frame);
      break;
    case 'pong':
      happen(link, { kind: 'pong' });
      break;
    case 'token':
      if (typeof message.token !== 'string')
        return handlers.onRefused?.('token_refresh.token: expected a text');
      link.token = message.token;
      handlers.onToken?.(message.token);
      break;
    case 'destroyed':
    case 'removed':
      takeGone(link, message);
      break;
    case 'other':
      handlers.onOther?.(message.type, message.message);
      break;
  }
}

function takeState(link: Link, sent: unknown): void {
  const { handlers, options } = link;
  if (link.state.phase !== 'live') return handlers.onRefused?.('state: came before the welcome');
  const now = options.clock.now();
  const frame = decodeFrameJson(sent, options.bodies === undefined ? {} : { bodies: options.bodies });
  if (!frame.ok) return handlers.onRefused?.(`state.${frame.reason}`);
  const { tickRate } = frame.value;
  const measured = now - link.lastStateAt;
  if (tickRate !== undefined)
    link.interval = Math.max(1 / tickRate, Number.isNaN(measured) ? 0 : Math.min(measured, 10));
  else if (!Number.isNaN(measured)) link.interval += (Math.min(measured, 10) - link.interval) / 4;
  link.lastStateAt = now;
  happen(link, { kind: 'state', interval: link.interval });
  handlers.onFrame(frame.value, now);
}

function takeGone(link: Link, message: GameMessage & { kind: 'destroyed' | 'removed' }): void {
  const about = asObject(message.about);
  const text = (...names: string[]) => {
    const found = names.map((name) => about[name]).find((value) => typeof value === 'string');
    return typeof found === 'string' ? found : '';
  };
  const shipId = text('ship_id', 'shipId');
  if (shipId === '') return link.handlers.onRefused?.(`${message.kind}.ship_id: expected a text`);
  const own = { name: text('ship_name', 'shipName'), body: text('body'), reason: text('reason') };
  link.handlers.onShipGone?.(shipId, message.kind === 'destroyed' ? own : null);
}
