import { createPageClock, type PageClock } from '../game/live/pageClock';
import type { FromServer, ToServer } from './connection';
import type { Operation } from './operation';
import { createSession, type Session } from './session';
import { createTabHost, openChannel, type TabHost } from './tabLink';

// The server in a Web Worker: the clock, the timer and the two message channels around a Session. Bytes are the protocol's own.

interface Server {
  readonly session: Session;
  readonly clock: PageClock;
  /** null until other tabs are invited. */
  host: TabHost | null;
  timer: ReturnType<typeof setTimeout> | undefined;
}

function post(message: FromServer, transfer: Transferable[] = []): void {
  self.postMessage(message, { transfer });
}

function run(server: Server): void {
  const { session, clock, host } = server;
  const now = clock.now();
  for (const { bytes } of session.run(now)) {
    // A copy: the buffer is transferred to the page, and a duplicate in flight must keep it.
    const copy = bytes.slice();
    post({ kind: 'bytes', bytes: copy }, [copy.buffer]);
  }
  for (const guest of host?.guests() ?? [])
    for (const { bytes } of session.deliverTo(guest, now)) host!.deliver(guest, bytes);
  schedule(server, now);
}

function schedule(server: Server, now: number): void {
  const { session, clock } = server;
  clearTimeout(server.timer);
  const wait = (session.nextAt() - now) / clock.speed();
  // While frozen there is nothing to wait for. setTimeout takes at most 2³¹ ms and drops fractions: too early, it would run again and again.
  if (!Number.isFinite(wait)) return;
  server.timer = setTimeout(() => run(server), Math.min(Math.max(0, Math.ceil(wait * 1000)), 60_000));
}

/** Serves the page; `early` came while this program was still loading. */
export function serve(early: readonly MessageEvent<ToServer>[]): void {
  const clock = createPageClock(() => performance.now() / 1000);
  const server: Server = { session: createSession(), clock, host: null, timer: undefined };
  for (const event of early) take(server, event.data);
  self.onmessage = ({ data }: MessageEvent<ToServer>) => take(server, data);
}

function take(server: Server, data: ToServer): void {
  const { session, clock } = server;
  if (data.kind === 'speed') clock.setSpeed(data.speed);
  else if (data.kind === 'bytes') session.send(data.bytes, clock.now());
  else operate(server, data.operation);
  run(server);
}

function operate(server: Server, operation: Operation): void {
  const { session, clock } = server;
  const reason = session.operate(operation, clock.now());
  if (reason !== null) post({ kind: 'refused', reason });
  else if (operation.kind === 'load') {
    post({ kind: 'open', what: 'world' });
    server.host?.worldBegan();
  } else if (operation.kind === 'invite') invite(server, operation.address);
  else if (operation.kind === 'reconnect') post({ kind: 'open', what: 'again' });
  else if (operation.kind === 'run') post({ kind: 'run', inputs: session.applied() });
  else if (operation.kind === 'drop') post({ kind: 'closed', reason: 'the connection was dropped' });
}

/** Invites once: the address is valid as long as the page is open. */
function invite(server: Server, address: string): void {
  const { session, clock } = server;
  server.host ??= createTabHost(openChannel(address), {
    join: (guest, name) => {
      const reason = session.join(guest, name, clock.now());
      // After the answer, so that the guest knows its world before the first frame.
      setTimeout(() => run(server));
      return reason;
    },
    leave: session.leave,
    send(guest, bytes) {
      session.sendFrom(guest, bytes, clock.now());
      run(server);
    },
    world: session.world,
  });
}
