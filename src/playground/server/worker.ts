import { createPageClock } from '../game/pageClock';
import type { FromServer, ToServer } from './connection';
import type { Operation } from './operation';
import { createSession } from './session';
import { createTabHost, openChannel, type TabHost } from './tabLink';

// The server in a Web Worker: the clock, the timer and the two message channels around a Session. Bytes are the protocol's own.

const session = createSession();
/** null until other tabs are invited. */
let host: TabHost | null = null;
let timer: ReturnType<typeof setTimeout> | undefined;

const clock = createPageClock(() => performance.now() / 1000);

function post(message: FromServer, transfer: Transferable[] = []): void {
  self.postMessage(message, { transfer });
}

function run(): void {
  const now = clock.now();
  for (const { bytes } of session.run(now)) {
    // A copy: the buffer is transferred to the page, and a duplicate in flight must keep it.
    const copy = bytes.slice();
    post({ kind: 'bytes', bytes: copy }, [copy.buffer]);
  }
  for (const guest of host?.guests() ?? [])
    for (const { bytes } of session.deliverTo(guest, now)) host!.deliver(guest, bytes);
  schedule(now);
}

function schedule(now: number): void {
  clearTimeout(timer);
  const wait = (session.nextAt() - now) / clock.speed();
  // A freeze has nothing to wait for; setTimeout holds at most 2³¹ ms, and drops fractions: too early, it would run again and again.
  if (Number.isFinite(wait)) timer = setTimeout(run, Math.min(Math.max(0, Math.ceil(wait * 1000)), 60_000));
}

/** Serves the page; `early` came while this program was still loading. */
export function serve(early: readonly MessageEvent<ToServer>[]): void {
  for (const event of early) take(event);
  self.onmessage = take;
}

function take({ data }: MessageEvent<ToServer>): void {
  if (data.kind === 'speed') clock.setSpeed(data.speed);
  else if (data.kind === 'bytes') session.send(data.bytes, clock.now());
  else operate(data.operation);
  run();
}

function operate(operation: Operation): void {
  const reason = session.operate(operation, clock.now());
  if (reason !== null) post({ kind: 'refused', reason });
  else if (operation.kind === 'load') {
    post({ kind: 'open', what: 'world' });
    host?.worldBegan();
  } else if (operation.kind === 'invite') invite(operation.address);
  else if (operation.kind === 'reconnect') post({ kind: 'open', what: 'again' });
  else if (operation.kind === 'run') post({ kind: 'run', inputs: session.applied() });
  else if (operation.kind === 'drop') post({ kind: 'closed', reason: 'the connection was dropped' });
}

/** Once: the address is the page's own for as long as it is open. */
function invite(address: string): void {
  host ??= createTabHost(openChannel(address), {
    join: (guest, name) => {
      const reason = session.join(guest, name, clock.now());
      // After the answer, so that the guest knows its world before the first frame.
      setTimeout(run);
      return reason;
    },
    leave: session.leave,
    send(guest, bytes) {
      session.sendFrom(guest, bytes, clock.now());
      run();
    },
    world: session.world,
  });
}
