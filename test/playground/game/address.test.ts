import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { createAddress } from '../../../src/playground/game/address';

/** Safari: 100 calls in 30 s, then an error. */
function createHistory() {
  const calls: { readonly at: number; readonly to: string }[] = [];
  return {
    calls,
    replaceState(_state: unknown, _title: string, to: string) {
      const recent = calls.filter(({ at }) => performance.now() - at < 30_000).length;
      if (recent >= 100) throw new DOMException('too many calls', 'SecurityError');
      calls.push({ at: performance.now(), to });
    },
  };
}

function open(history: ReturnType<typeof createHistory>) {
  const window = { history, location: { pathname: '/page', origin: 'http://host' } } as unknown as Window;
  const unused = {} as never;
  return createAddress(window, unused, unused);
}

describe('the page’s address', () => {
  beforeEach(() => {
    vi.useFakeTimers();
  });
  afterEach(() => {
    vi.useRealTimers();
  });

  it('is changed seldom enough for Safari, and ends at the last choice', () => {
    const history = createHistory();
    const address = open(history);
    for (let n = 0; n < 600; n++) {
      address.write(`?seed=${n}`);
      vi.advanceTimersByTime(50);
    }
    vi.advanceTimersByTime(1000);
    expect(history.calls.length).toBeLessThanOrEqual(100);
    expect(history.calls.at(-1)!.to).toBe('?seed=599');
  });

  it('that the browser refused is tried again', () => {
    const history = createHistory();
    const address = open(history);
    // Another script of the host has used all calls up.
    for (let n = 0; n < 100; n++) history.replaceState(null, '', 'theirs');
    address.write('?seed=7');
    expect(history.calls.at(-1)!.to).toBe('theirs');
    vi.advanceTimersByTime(40_000);
    expect(history.calls.at(-1)!.to).toBe('?seed=7');
  });
});
