import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { FromServer, ToServer } from '../../../src/playground/server/connection';
import type { Operation } from '../../../src/playground/server/operation';
import { serve } from '../../../src/playground/server/worker';
import { NETWORK_PRESETS } from '../../../src/scenarios';
import { decodeServerMessage, encodeClientMessage } from '../../../src/wire';
import { input, valueOf } from '../../authority/moon';

const LOAD: Operation = {
  kind: 'load',
  scenario: 'opening',
  body: '',
  shipClass: '',
  terrain: '',
  tickRate: 1,
  timeScale: 1,
  network: NETWORK_PRESETS.lan,
  seed: 1,
  legacy: false,
  others: 0,
};

/** The worker's file with a virtual scope, clock and timers. */
interface Scope {
  onmessage: (event: { data: ToServer }) => void;
  postMessage: (message: FromServer, options: { transfer: Transferable[] }) => void;
}

describe('the worker', () => {
  let scope: Scope;
  let posted: FromServer[];
  const post = (data: ToServer) => scope.onmessage({ data });
  const operate = (operation: Operation) => post({ kind: 'operate', operation });

  /** Messages posted since the last call; those of the protocol by their kind. */
  function heard(): string[] {
    return posted.splice(0).flatMap((message) => {
      if (message.kind !== 'bytes') return [message.kind];
      return [valueOf(decodeServerMessage(message.bytes)).kind];
    });
  }

  beforeEach(() => {
    vi.useFakeTimers();
    posted = [];
    scope = {
      onmessage: () => undefined,
      postMessage: (message, { transfer }) => {
        // As in a real worker: transferred data is detached on this side.
        posted.push(structuredClone(message, { transfer }));
      },
    };
    vi.stubGlobal('self', scope);
  });
  afterEach(() => {
    vi.useRealTimers();
    vi.unstubAllGlobals();
  });

  it('first handles what arrived while its program was loading', () => {
    serve([new MessageEvent<ToServer>('message', { data: { kind: 'operate', operation: LOAD } })]);
    operate({ kind: 'drop' });
    expect(heard()).toEqual(['open', 'closed']);
  });

  it('opens a world, then delivers bytes on the page’s clock', () => {
    serve([]);
    operate(LOAD);
    expect(heard()).toEqual(['open']);
    vi.advanceTimersByTime(5);
    expect(heard()).toEqual(['hello', 'frame']);
    vi.advanceTimersByTime(3000);
    expect(heard()).toEqual(['frame', 'frame', 'frame']);
  });

  it('receives the protocol’s bytes and answers', () => {
    serve([]);
    operate(LOAD);
    post({ kind: 'bytes', bytes: encodeClientMessage({ kind: 'ping', id: 4 }) });
    const inputs = [input(1, 0, 50, { thrustLevel: 1 })];
    post({ kind: 'bytes', bytes: encodeClientMessage({ kind: 'inputs', inputs }) });
    vi.advanceTimersByTime(1010);
    const frames = posted.flatMap((message) => {
      const decoded = message.kind === 'bytes' ? valueOf(decodeServerMessage(message.bytes)) : null;
      return decoded?.kind === 'frame' ? [decoded] : [];
    });
    expect(frames.at(-1)).toMatchObject({ tick: 1, lastInput: { seq: 1, substep: 50 } });
    expect(heard()).toContain('pong');
  });

  it('refuses an invalid command by name and goes on', () => {
    serve([]);
    operate({ ...LOAD, scenario: 'heist' });
    expect(posted).toEqual([{ kind: 'refused', reason: 'scenario: no scenario named heist' }]);
    operate(LOAD);
    heard();
    vi.advanceTimersByTime(5);
    expect(heard()).toEqual(['hello', 'frame']);
  });

  it('closes and reopens a dropped connection', () => {
    serve([]);
    operate(LOAD);
    vi.advanceTimersByTime(100);
    heard();
    operate({ kind: 'drop' });
    expect(heard()).toEqual(['closed']);
    vi.advanceTimersByTime(5000);
    expect(heard()).toEqual([]);
    operate({ kind: 'reconnect' });
    expect(heard()).toEqual(['open']);
    vi.advanceTimersByTime(5);
    expect(heard()).toEqual(['hello', 'frame']);
  });

  it('sends only what the page needs, and does not wake before something is due', () => {
    serve([]);
    operate({ ...LOAD, network: NETWORK_PRESETS.broadband });
    vi.advanceTimersByTime(10_000);
    expect(new Set(posted.map(({ kind }) => kind))).toEqual(new Set(['open', 'bytes']));
    // Counts wakings: a timer set to a fraction of a millisecond would run several times for one message.
    posted = [];
    let wakings = 0;
    while (posted.length < 10) {
      vi.advanceTimersToNextTimer();
      wakings++;
    }
    expect(wakings).toBeLessThan(25);
  });
});
