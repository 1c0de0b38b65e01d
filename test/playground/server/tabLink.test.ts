import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { ConnectionHandlers } from '../../../src/playground/server/connection';
import { openTab, type TabChannel, type ToGuest, type ToHost } from '../../../src/playground/server/tabLink';

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

/** A guest whose channel's other end is the test. */
function openGuest() {
  const sent: (ToHost | ToGuest)[] = [];
  const told: string[] = [];
  const channel: TabChannel = {
    onmessage: null,
    postMessage: (message) => sent.push(message),
    close: vi.fn(),
  };
  const nothing = () => undefined;
  const handlers: ConnectionHandlers = {
    ...{ onFrame: nothing, onClosed: nothing, onWelcome: nothing, onShipGone: nothing, onRun: nothing },
    onOpen: (what) => told.push(`open ${what}`),
    onPending: () => told.push('message'),
    onLink: (words) => told.push(`link ${words}`),
    onRefused: (reason) => told.push(reason),
    onScenario: (scenario, terrain) => told.push(`${scenario} on ${terrain}`),
  };
  const connection = openTab('tab:test', { guest: 'me', name: 'Bob' }, handlers, channel);
  const hear = (message: object) => channel.onmessage?.({ data: { to: 'me', ...message } });
  return { connection, channel, hear, sent, told };
}

const WORLD = { kind: 'world', scenario: 'settle', terrain: 'hills' };
const JOIN = { kind: 'join', from: 'me', name: 'Bob' };

describe('a guest', () => {
  it('knocks every 1.5 s until the other tab lets it in, and then no more', () => {
    const { hear, sent, told } = openGuest();
    vi.advanceTimersByTime(4600);
    expect(sent).toEqual([JOIN, JOIN, JOIN, JOIN]);
    expect(new Set(told)).toEqual(new Set(['link Waiting for the other tab …']));
    hear(WORLD);
    expect(told.slice(-3)).toEqual(['link ', 'settle on hills', 'open world']);
    for (let s = 0; s < 20; s++) {
      vi.advanceTimersByTime(1000);
      hear({ kind: 'bytes', bytes: new Uint8Array() });
    }
    expect(sent).toHaveLength(4);
    expect(told.slice(-20)).toEqual(Array.from({ length: 20 }, () => 'message'));
  });

  it('that the other tab refuses receives the reason, and keeps knocking', () => {
    const { hear, sent, told } = openGuest();
    hear({ kind: 'refused', reason: 'it is full' });
    expect(told.at(-1)).toBe('link The other tab refused: it is full.');
    vi.advanceTimersByTime(1600);
    expect(sent).toEqual([JOIN, JOIN]);
  });

  it('notices after 6 s of silence that the other tab has gone, and knocks until it is back', () => {
    const { hear, sent, told } = openGuest();
    hear(WORLD);
    vi.advanceTimersByTime(6000);
    expect(sent).toEqual([JOIN]);
    vi.advanceTimersByTime(3000);
    expect(sent).toEqual([JOIN, JOIN, JOIN]);
    expect(told.at(-1)).toBe('link The other tab has gone. Waiting for it …');
    hear(WORLD);
    vi.advanceTimersByTime(6000);
    expect(sent).toHaveLength(3);
    expect(told.slice(-3)).toEqual(['link ', 'settle on hills', 'open world']);
  });

  it('ignores messages for another guest, which do not end its own silence', () => {
    const { channel, hear, sent, told } = openGuest();
    hear(WORLD);
    const heard = told.length;
    for (let s = 0; s < 8; s++) {
      channel.onmessage?.({ data: { ...WORLD, to: 'other' } });
      channel.onmessage?.({ data: null });
      vi.advanceTimersByTime(1000);
    }
    expect(told.slice(heard)).toEqual(['link The other tab has gone. Waiting for it …']);
    expect(sent).toEqual([JOIN, JOIN]);
  });

  it('leaves when its page is closed, and knocks again if the page comes back', () => {
    const window = new EventTarget();
    vi.stubGlobal('window', window);
    const { connection, channel, hear, sent } = openGuest();
    hear(WORLD);
    window.dispatchEvent(new Event('pagehide'));
    expect(sent.at(-1)).toEqual({ kind: 'leave', from: 'me' });
    vi.advanceTimersByTime(1500);
    expect(sent.at(-1)).toEqual(JOIN);
    connection.dispose();
    expect(sent.at(-1)).toEqual({ kind: 'leave', from: 'me' });
    expect(channel.close).toHaveBeenCalledOnce();
    const ended = sent.length;
    window.dispatchEvent(new Event('pagehide'));
    vi.advanceTimersByTime(60_000);
    expect(sent).toHaveLength(ended);
  });

  it('cannot command the world', () => {
    const { connection, sent, told } = openGuest();
    connection.operate({ kind: 'restart' });
    connection.setSpeed(0.5);
    connection.setSpeed(1);
    expect(told.slice(1)).toEqual([
      'restart: only the host can do that',
      'slow motion: only the host can do that',
    ]);
    expect(sent).toEqual([JOIN]);
  });
});
