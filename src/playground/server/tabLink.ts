import { encodeClientMessage, pendingServerMessage } from '../../wire';
import type { Connection, ConnectionHandlers } from './connection';
import { MAX_PILOT_NAME } from './tabAddress';

/** Guest → host, over a channel that every tab of the browser receives. */
export type ToHost =
  | { readonly kind: 'join'; readonly from: string; readonly name: string }
  | { readonly kind: 'bytes'; readonly from: string; readonly bytes: Uint8Array }
  | { readonly kind: 'leave'; readonly from: string };

/** Host → guest. */
export type ToGuest =
  /** A world has begun; its messages come after this. */
  | { readonly kind: 'world'; readonly to: string; readonly scenario: string; readonly terrain: string }
  | { readonly kind: 'bytes'; readonly to: string; readonly bytes: Uint8Array }
  | { readonly kind: 'refused'; readonly to: string; readonly reason: string };

/** The members of a BroadcastChannel that are used. */
export interface TabChannel {
  postMessage: (message: ToHost | ToGuest) => void;
  onmessage: ((event: { readonly data: unknown }) => void) | null;
  close: () => void;
}

/** One name for all tabs of this host, so that two pages of it do not hear each other. */
export function openChannel(address: string): TabChannel {
  return new BroadcastChannel(`touchdown ${address}`) as unknown as TabChannel;
}

/** The host's calls for its guests. */
export interface GuestCalls {
  /** A guest joins or rejoins; returns the reason why it cannot, or null. */
  readonly join: (guest: string, name: string) => string | null;
  readonly leave: (guest: string) => void;
  readonly send: (guest: string, bytes: Uint8Array) => void;
  /** The present world. */
  readonly world: () => { readonly scenario: string; readonly terrain: string };
}

export interface TabHost {
  readonly guests: () => readonly string[];
  readonly deliver: (guest: string, bytes: Uint8Array) => void;
  /** A new world: every guest is let in again. */
  readonly worldBegan: () => void;
}

const MAX_GUESTS = 7;
/** Bytes of one message: far more than the protocol's inputs take. */
const MAX_BYTES = 65_536;

/** Listens for guests. Messages on the channel are from other pages, so they are checked. */
export function createTabHost(channel: TabChannel, calls: GuestCalls): TabHost {
  const names = new Map<string, string>();
  const admit = (from: string, name: string) => {
    const reason =
      names.size >= MAX_GUESTS && !names.has(from)
        ? `it has ${MAX_GUESTS} guests already`
        : calls.join(from, name);
    if (reason !== null) {
      channel.postMessage({ kind: 'refused', to: from, reason });
      return;
    }
    names.set(from, name);
    channel.postMessage({ kind: 'world', to: from, ...calls.world() });
  };
  channel.onmessage = ({ data }) => {
    const message = readToHost(data);
    if (message === null) return;
    if (message.kind === 'join') admit(message.from, message.name);
    else if (!names.has(message.from)) return;
    else if (message.kind === 'bytes') calls.send(message.from, message.bytes);
    else {
      names.delete(message.from);
      calls.leave(message.from);
    }
  };
  return {
    guests: () => [...names.keys()],
    deliver: (to, bytes) => channel.postMessage({ kind: 'bytes', to, bytes }),
    worldBegan() {
      for (const [guest, name] of names) admit(guest, name);
    },
  };
}

function readToHost(data: unknown): ToHost | null {
  if (typeof data !== 'object' || data === null) return null;
  const { kind, from, name, bytes } = data as Partial<Record<string, unknown>>;
  if (typeof from !== 'string' || !/^[\w-]{1,40}$/.test(from)) return null;
  if (kind === 'leave') return { kind, from };
  if (kind === 'join' && typeof name === 'string')
    return {
      kind,
      from,
      name:
        name
          .replace(/\p{Surrogate}/gu, '')
          .trim()
          .slice(0, MAX_PILOT_NAME) || 'Guest',
    };
  if (kind === 'bytes' && bytes instanceof Uint8Array && bytes.length <= MAX_BYTES)
    return { kind, from, bytes };
  return null;
}

/** Wall ms between two knocks, and of silence after which the host counts as gone. */
const KNOCK = 1500;
const SILENT = 6000;

/**
 * A world that another tab of this browser runs: that page is the host, this one flies as a guest.
 * @param guest this page's own name on the channel: letters, digits, - and _
 */
export function openTab(
  address: string,
  { guest, name }: { readonly guest: string; readonly name: string },
  handlers: ConnectionHandlers,
  channel: TabChannel = openChannel(address),
): Connection {
  let heardAt = -Infinity;
  let isIn = false;
  const knock = () => {
    const isSilent = performance.now() - heardAt > SILENT;
    if (isIn && !isSilent) return;
    handlers.onLink(isIn ? 'The other tab has gone. Waiting for it …' : 'Waiting for the other tab …');
    channel.postMessage({ kind: 'join', from: guest, name });
  };
  const timer = setInterval(knock, KNOCK);
  channel.onmessage = ({ data }) => {
    const message = data as ToGuest;
    if ((message as Partial<ToGuest> | null)?.to !== guest) return;
    heardAt = performance.now();
    if (message.kind === 'refused') handlers.onLink(`The other tab refused: ${message.reason}.`);
    else if (message.kind === 'world') {
      isIn = true;
      handlers.onLink('');
      handlers.onScenario?.(message.scenario, message.terrain);
      handlers.onOpen('world');
    } else handlers.onPending(pendingServerMessage(message.bytes));
  };
  const leave = () => {
    isIn = false;
    channel.postMessage({ kind: 'leave', from: guest });
  };
  // Closing a tab removes its ship; a tab that returns knocks again.
  const { window } = globalThis as { readonly window?: Window };
  window?.addEventListener('pagehide', leave);
  knock();
  return {
    send: (message) =>
      channel.postMessage({ kind: 'bytes', from: guest, bytes: encodeClientMessage(message) }),
    operate: ({ kind }) => handlers.onRefused(`${kind}: only the host can do that`),
    reconnect: knock,
    setSpeed(speed) {
      if (speed !== 1) handlers.onRefused('slow motion: only the host can do that');
    },
    dispose() {
      clearInterval(timer);
      window?.removeEventListener('pagehide', leave);
      leave();
      channel.close();
    },
  };
}
