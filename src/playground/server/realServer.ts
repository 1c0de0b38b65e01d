import {
  createDriver,
  createGameConnection,
  type GameClock,
  type GameSocket,
  type LinkStatus,
} from '../../game';
import {
  type ClientMessage,
  encodeClientMessage,
  MAX_TICK,
  pendingServerMessage,
  type PendingMessage,
  type ServerMessage,
} from '../../wire';
import type { Connection, ConnectionHandlers } from './connection';

/**
 * A real server (`?server=`). An address that ends in /ws speaks the game's JSON; any other this project's bytes, as the
 * gateway's /stream does. A `token` in the address's query signs in, and is not shown.
 *
 * It takes no commands: pause, restart, scenario and slow motion do not reach it, and onRefused reports that.
 */
export function openServer(given: string, handlers: ConnectionHandlers): Connection {
  const { address, token } = splitToken(given);
  const link = isGameAddress(address)
    ? openGame(address, token, handlers)
    : openStream(address, token, handlers);
  return {
    ...link,
    operate: ({ kind }) => handlers.onRefused(`${kind}: only available with the built-in server`),
    setSpeed(speed) {
      if (speed !== 1) handlers.onRefused('slow motion: only available with the built-in server');
    },
  };
}

type Link = Pick<Connection, 'send' | 'reconnect' | 'dispose'>;

/** The address as far as it can be parsed: an invalid one is reported like a server that does not answer. */
function splitToken(given: string): { readonly address: string; readonly token: string } {
  if (!URL.canParse(given)) return { address: given, token: '' };
  const url = new URL(given);
  const token = url.searchParams.get('token') ?? '';
  url.searchParams.delete('token');
  const address = url.toString();
  return { address: url.pathname === '/' && url.search === '' ? address.slice(0, -1) : address, token };
}

function isGameAddress(address: string): boolean {
  return URL.canParse(address) && new URL(address).pathname.endsWith('/ws');
}

const clock: GameClock = {
  now: () => performance.now() / 1000,
  after(seconds, act) {
    const timer = setTimeout(act, seconds * 1000);
    return () => clearTimeout(timer);
  },
};

function openSocket(address: string): GameSocket {
  const socket = new WebSocket(address);
  socket.binaryType = 'arraybuffer';
  return socket;
}

const MACHINE = { clock, jitter: () => Math.random(), openSocket };

/**
 * Handlers of every link: the first welcome begins a world, later ones continue in it. While the link waits, its text counts the seconds
 * to the next attempt.
 * @param statusNow the link's status at the time of the call
 */
function createLinkReporter(handlers: ConnectionHandlers, statusNow: () => LinkStatus) {
  let isOpened = false;
  let countdown: ReturnType<typeof setInterval> | undefined;
  return {
    opened() {
      handlers.onOpen(isOpened ? 'again' : 'world');
      isOpened = true;
    },
    status: ({ phase, text }: LinkStatus) => {
      clearInterval(countdown);
      if (phase === 'waiting') countdown = setInterval(() => handlers.onLink(statusNow().text), 1000);
      handlers.onLink(text);
    },
  };
}

function openGame(address: string, token: string, handlers: ConnectionHandlers): Link {
  const reporter = createLinkReporter(handlers, () => game.status());
  /** The present connection has been reported. */
  let isIn = false;
  const game = createGameConnection(
    { address, token, ...MACHINE },
    {
      onStatus(status) {
        isIn &&= status.phase === 'live';
        reporter.status(status);
      },
      onWelcome(about) {
        if (!isIn) reporter.opened();
        isIn = true;
        handlers.onWelcome(about);
      },
      onFrame: handlers.onFrame,
      onShipGone: handlers.onShipGone,
      onRefused: handlers.onRefused,
    },
  );
  return {
    send(message) {
      // The game has no stamps: the last controls act from its next tick on.
      const controls = message.kind === 'inputs' ? message.inputs.at(-1)?.controls : undefined;
      if (controls !== undefined) game.sendControls(controls);
    },
    reconnect: game.retry,
    dispose: game.dispose,
  };
}

/** The predictor gives this ID to no ping. */
const OWN_PING: ClientMessage = { kind: 'ping', id: MAX_TICK };

function openStream(address: string, token: string, handlers: ConnectionHandlers): Link {
  const reporter = createLinkReporter(handlers, () => driver.status());
  // One page load is one session: inputs that are sent again after a break are known as the same.
  const session = Array.from({ length: 4 }, () => Math.random().toString(36).slice(2, 10)).join('');
  let since = -1;
  /** Seconds between two states, if a frame has it. */
  let interval: number | undefined;

  function hear(message: ServerMessage): void {
    const { phase } = driver.state();
    if (message.kind === 'hello' && phase === 'authenticating') {
      driver.dispatch({ kind: 'welcome' });
      reporter.opened();
    } else if (message.kind === 'pong') driver.dispatch({ kind: 'pong' });
  }

  /** A frame that reads its tick for the next connection when it is decoded. */
  function noting(message: PendingMessage): PendingMessage {
    return {
      ...message,
      decode() {
        const decoded = message.decode();
        if (decoded.ok && decoded.value.kind === 'frame') {
          since = decoded.value.tick;
          interval = 1 / decoded.value.tickRate;
        }
        return decoded;
      },
    };
  }

  const driver = createDriver({
    address,
    ...MACHINE,
    auth: () =>
      token === '' ? null : JSON.stringify({ type: 'auth', token, session, ...(since >= 0 && { since }) }),
    ping: () => encodeClientMessage(OWN_PING),
    onStatus: reporter.status,
    onData(data) {
      if (!(data instanceof ArrayBuffer)) {
        handlers.onRefused(`${address} sent text, but its protocol is binary`);
        return;
      }
      const message = pendingServerMessage(new Uint8Array(data));
      if (message.isFrame) {
        driver.stateReceived(interval);
        handlers.onPending(noting(message));
        return;
      }
      const decoded = message.decode();
      if (decoded.ok) hear(decoded.value);
      handlers.onPending({ ...message, decode: () => decoded });
    },
  });
  return {
    send: (message) => void driver.write(encodeClientMessage(message)),
    reconnect: () => driver.dispatch({ kind: 'retry' }),
    dispose: () => driver.dispatch({ kind: 'end' }),
  };
}
