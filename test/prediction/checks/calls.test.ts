/** Patterns of calls at their bounds: one less is no mistake yet. */
import { describe, expect, it } from 'vitest';
import {
  createCalls,
  noteAdvance,
  noteFrame,
  noteTaken,
  noteUntaken,
  noteView,
} from '../../../src/prediction/checks/calls';
import type { PartialFrame } from '../../../src/wire';
import { frame, ship } from './mistakes/given';

/** The calls of one predictor, and the codes that they were warned of, each once. */
function caller() {
  const calls = createCalls();
  const codes = new Set<string>();
  const warn = (code: string) => void codes.add(code);
  let now = 0;
  return {
    calls,
    codes: () => [...codes],
    /** Calls `advance` each `gap` s. */
    advance(times: number, gap: number) {
      for (let i = 0; i < times; i++) noteAdvance(warn, calls, (now += gap));
    },
    receive: (one: Partial<PartialFrame>, at: number, own = '') =>
      noteFrame(warn, calls, { ...frame, ...one }, at, own),
    view: (at: number) => noteView(warn, calls, at),
    untaken: (waiting: number) => noteUntaken(warn, calls, waiting),
    taken: (call: string) => noteTaken(warn, calls, call),
  };
}

/** The codes after the first call of advance and `times` more, each `gap` s later. */
function advanced(times: number, gap: number) {
  const made = caller();
  made.advance(1, 0);
  made.advance(times, gap);
  return made.codes();
}

describe('advance', () => {
  it.each([
    ['advance-twice', 0],
    ['advance-seldom', 0.151],
    ['advance-seldom', 3.9],
    ['now-in-milliseconds', 5],
    ['now-in-milliseconds', 300],
  ])('warns %s at the tenth gap of %d s', (code, gap) => {
    expect([9, 10].map((times) => advanced(times, gap))).toEqual([[], [code]]);
  });

  it('warns of both codes at gaps between 4 and 5 s', () => {
    expect(advanced(10, 4).toSorted()).toEqual(['advance-seldom', 'now-in-milliseconds']);
    expect(advanced(10, 4.99).toSorted()).toEqual(['advance-seldom', 'now-in-milliseconds']);
  });

  it.each([0.15, 300.1])('does not warn at gaps of %d s: a slow display, a hidden page', (gap) => {
    const made = caller();
    made.advance(1, 0);
    made.advance(20, gap);
    expect(made.codes()).toEqual([]);
  });

  it('does not warn if another gap interrupts the series', () => {
    for (const gap of [0.2, 5, 0]) {
      const made = caller();
      made.advance(1, 0.01);
      made.advance(9, gap);
      made.advance(2, 0.01);
      made.advance(9, gap);
      expect(made.codes()).toEqual([]);
    }
  });

  it('warns of two calls per frame if every second call repeats `now`', () => {
    const made = caller();
    for (let i = 0; i < 10; i++) {
      made.advance(1, 0.01);
      made.advance(1, 0);
    }
    expect(made.codes()).toEqual(['advance-twice']);
  });

  it('warns of another clock beyond 1e9 s, if it goes back, or more than 100 s from that of receive', () => {
    expect(advanced(1, 1e9)).toEqual([]);
    expect(advanced(1, 1e9 + 1)).toEqual(['now-of-calendar']);
    expect(advanced(1, -0.001)).toEqual(['now-went-back']);
    for (const [apart, codes] of [
      [100, []],
      [100.1, ['two-clocks']],
    ] as const) {
      const made = caller();
      made.receive({}, 1);
      made.advance(1, 1 + apart);
      expect(made.codes()).toEqual(codes);
    }
  });
});

describe('view', () => {
  it.each([Symbol('now'), 10n, { valueOf: () => Number.parseInt }, [[0]], 'soon', null])(
    'takes %s for no time of another clock',
    (now) => {
      const made = caller();
      made.advance(2, 1 / 60);
      made.view(now as never);
      expect(made.codes()).toEqual([]);
    },
  );

  it('warns of another clock more than 100 s from that of advance', () => {
    for (const [apart, codes] of [
      [100, []],
      [-100.1, ['two-clocks']],
    ] as const) {
      const made = caller();
      made.advance(1, 1);
      made.view(1 + apart);
      expect(made.codes()).toEqual(codes);
    }
  });

  it('warns at its tenth call without advance, once there is a frame to show', () => {
    const viewed = (times: number, frames: number) => {
      const made = caller();
      for (let i = 0; i < frames; i++) made.receive({}, 0);
      for (let i = 0; i < times; i++) made.view(0);
      return made.codes();
    };
    expect([viewed(9, 1), viewed(10, 1), viewed(10, 0)]).toEqual([[], ['advance-never'], []]);
  });
});

describe('outgoing messages', () => {
  it('are reported as not taken from the 300th call of advance on', () => {
    const made = caller();
    made.advance(5, 0.01);
    made.taken('takeControls');
    made.advance(299, 0.01);
    made.untaken(3);
    expect(made.codes()).toEqual([]);
    made.advance(1, 0.01);
    made.untaken(0);
    expect(made.codes()).toEqual([]);
    made.untaken(1);
    expect(made.codes()).toEqual(['outgoing-not-taken']);
  });

  it('are reported as taken twice if two different calls take them', () => {
    const made = caller();
    for (const call of ['takeControls', 'takeControls']) made.taken(call);
    expect(made.codes()).toEqual([]);
    made.taken('takeOutgoing');
    expect(made.codes()).toEqual(['outgoing-taken-twice']);
  });
});

describe('the player’s ship', () => {
  const received = (count: number, own: string, ships: readonly unknown[]) => {
    const made = caller();
    made.advance(1, 0);
    for (let i = 0; i < count; i++) made.receive({ tick: i, ships: ships as typeof frame.ships }, i, own);
    return made.codes();
  };

  it('is reported as never seen at the tenth frame without it; a spectator has none', () => {
    expect([9, 10].map((count) => received(count, 'b', [ship]))).toEqual([[], ['own-ship-never-seen']]);
    expect([received(10, 'a', [ship]), received(10, '', [ship])]).toEqual([[], []]);
    expect(received(10, 'a', [null, ship])).toEqual([]);
  });
});

describe('tick rate and game time', () => {
  /** Frames of `rate` Hz by their own account, each tick `gap` s after the last. */
  const paced = (count: number, tickRate: number, gap: number) => {
    const made = caller();
    made.advance(1, 0);
    for (let i = 0; i < count; i++) made.receive({ tick: i, tickRate }, 1 + i * gap);
    return made.codes();
  };

  it('are reported if ticks come five times too fast for three seconds', () => {
    expect(paced(40, 1, 0.21)).toEqual([]);
    expect(paced(40, 1, 0.19)).toEqual(['tick-rate']);
    // At 0.19 s per tick 3 s have passed with the 16th gap.
    expect([16, 17].map((count) => paced(count, 1, 0.19))).toEqual([[], ['tick-rate']]);
  });

  it('are reported if ten ticks in a row come five times too late, over three seconds', () => {
    expect(paced(40, 10, 0.49)).toEqual([]);
    expect([10, 11].map((count) => paced(count, 10, 0.51))).toEqual([[], ['tick-rate']]);
    expect([30, 31].map((count) => paced(count, 100, 0.1001))).toEqual([[], ['tick-rate']]);
  });

  it('are reported if game time grows a hundred times too fast or too slowly', () => {
    const grown = (perTick: number) => {
      const made = caller();
      made.advance(1, 0);
      for (let i = 0; i < 3; i++) made.receive({ tick: i, gameTime: 5 + i * perTick }, i);
      return made.codes();
    };
    expect([0.0101, 99.9].map(grown)).toEqual([[], []]);
    expect([0.0099, 100.1].map(grown)).toEqual([['game-time'], ['game-time']]);
  });
});
