import { describe, expect, it } from 'vitest';
import { beginLink, type LinkEvent, type LinkState, statusOf, type Step, stepLink } from '../../src/game';
import { dueAt } from '../../src/game/link';

const ADDRESS = 'wss://game.example/ws';
const words = (state: LinkState, now: number) => statusOf(state, ADDRESS, now).text;

/** Plays events at their times, with jitter 0. */
function play(...events: readonly [number, LinkEvent][]): Step {
  let step = beginLink(0);
  for (const [now, event] of events) step = stepLink(step.state, event, now, 0.5);
  return step;
}

const OPENED = [0.1, { kind: 'opened' }] as const;
const WELCOME = [0.2, { kind: 'welcome' }] as const;
const LIVE = [[...OPENED], [...WELCOME]] as [number, LinkEvent][];
const TIME: LinkEvent = { kind: 'time' };
const closed = (code: number, reason = ''): LinkEvent => ({ kind: 'closed', code, reason });

describe('a link', () => {
  it('opens, authenticates and is welcomed', () => {
    expect(beginLink(0).effects).toEqual(['open']);
    expect(play([...OPENED]).effects).toEqual(['auth']);
    expect(words(play([...OPENED]).state, 1)).toBe('Connected to wss://game.example/ws; signing in…');
    expect(play(...LIVE).state).toMatchObject({ phase: 'live', failures: 0, pingAt: 30.2 });
    expect(words(play(...LIVE).state, 1)).toBe('');
    // It pings when no state has followed within 2 s.
    expect(dueAt(play(...LIVE).state)).toBe(2.2);
  });

  it('ignores a socket that closes after the link has given it up', () => {
    const waiting = play([...OPENED], [10.1, TIME]).state;
    const refused = play([...OPENED], [1, closed(4001, 'no')]).state;
    const ended = play(...LIVE, [1, { kind: 'end' }]).state;
    expect([waiting, refused, ended].map(({ phase }) => phase)).toEqual(['waiting', 'refused', 'ended']);
    for (const state of [waiting, refused, ended])
      expect(stepLink(state, closed(1006), 10.2, 0.5)).toEqual({ state, effects: [] });
  });

  it('gives up after 10 s without a welcome', () => {
    const waiting = play([...OPENED]);
    expect(dueAt(waiting.state)).toBe(10.1);
    const step = stepLink(waiting.state, TIME, 10.1, 0.5);
    expect(step.effects).toEqual(['close']);
    expect(step.state.ended).toEqual({ cause: 'noWelcome', code: 0, reason: '' });
    expect(words(step.state, 10.1)).toBe(
      'wss://game.example/ws accepted the connection but sent no welcome within 10 s. Retrying in 1 s.',
    );
  });

  it('pings each 30 s, and closes after 10 s without an answer', () => {
    const steady: [number, LinkEvent][] = [...LIVE, [29, { kind: 'state', interval: 1 }]];
    const pinged = play(...steady, [30.2, TIME]);
    expect(pinged.effects).toEqual(['ping']);
    expect(pinged.state).toMatchObject({ pingAt: 60.2, pongBy: 40.2 });
    const answered = stepLink(pinged.state, { kind: 'pong' }, 30.3, 0.5);
    expect(answered.state.pongBy).toBe(Infinity);
    const dead = play(...steady, [30.2, TIME], [40, { kind: 'state', interval: 1 }], [40.2, TIME]);
    expect(dead.state.phase).toBe('waiting');
    expect(dead.state.ended).toEqual({ cause: 'noPong', code: 0, reason: '' });
    expect(words(dead.state, 40.2)).toBe(
      'wss://game.example/ws did not answer a ping within 10 s. Retrying in 1 s.',
    );
  });

  it('distinguishes a paused server, which answers, from one that is gone', () => {
    const asked = play(...LIVE, [1, { kind: 'state', interval: 1 }], [4, TIME]);
    expect(asked.effects).toEqual(['ping']);
    expect(words(asked.state, 4)).toContain('pinging it');
    const paused = stepLink(asked.state, { kind: 'pong' }, 4.1, 0.5);
    expect(words(paused.state, 4.1)).toBe('The server answers but sends no states: the game is paused.');
    const again = stepLink(paused.state, { kind: 'state', interval: 1 }, 60, 0.5);
    expect(words(again.state, 60)).toBe('');
    expect(stepLink(asked.state, TIME, 14, 0.5).state.phase).toBe('waiting');
  });

  it('does not mistake a slow server for a silent one', () => {
    const slow = play(...LIVE, [1, { kind: 'state', interval: 10 }]);
    expect(slow.state.stateBy).toBe(31);
  });

  it('backs off from attempt to attempt, with a quarter of jitter, to about half a minute at most', () => {
    let { state } = beginLink(0);
    let now = 0;
    const waits: number[] = [];
    for (let attempt = 0; attempt < 8; attempt++) {
      state = stepLink(state, closed(1006), now, attempt % 2).state;
      expect(words(state, now)).toContain(
        'Nothing answers at wss://game.example/ws (code 1006). Is the server running?',
      );
      waits.push(state.retryAt - now);
      now = state.retryAt;
      const step = stepLink(state, TIME, now, 0.5);
      expect(step.effects).toEqual(['open']);
      state = step.state;
    }
    const expected = [0.75, 2.5, 3, 10, 12, 37.5, 22.5, 37.5];
    for (const [i, wait] of waits.entries()) expect(wait).toBeCloseTo(expected[i]!, 9);
  });

  it('omits a close code of 0, as of a socket that could not be created', () => {
    const failed = stepLink(beginLink(0).state, closed(0, 'no such host'), 0, 0.5);
    expect(words(failed.state, 0)).toBe(
      'Nothing answers at wss://game.example/ws. Is the server running? Retrying in 1 s.',
    );
  });

  it('reconnects after a failure, and after a refusal of a link that was live', () => {
    expect(words(play().state, 0)).toBe('Connecting to wss://game.example/ws…');
    const again = 'Reconnecting to wss://game.example/ws…';
    expect(words(play([0.1, closed(1006)], [9, TIME]).state, 9)).toBe(again);
    expect(words(play(...LIVE, [5, closed(4001)], [6, { kind: 'retry' }]).state, 6)).toBe(again);
  });

  it('reports that it is back until the first state', () => {
    const lost = play(...LIVE, [5, closed(1006)]);
    expect(words(lost.state, 5)).toBe(
      'The connection to wss://game.example/ws was lost (code 1006). Retrying in 1 s.',
    );
    const back = play(
      ...LIVE,
      [5, closed(1006)],
      [6, TIME],
      [6.1, { kind: 'opened' }],
      [6.2, { kind: 'welcome' }],
    );
    expect(words(back.state, 6.2)).toBe('Connected to wss://game.example/ws again.');
    const { state } = stepLink(back.state, { kind: 'state', interval: 1 }, 6.3, 0.5);
    expect(words(state, 6.3)).toBe('');
  });

  it('reconnects after a refusal only on request', () => {
    const auth = play([...OPENED], [0.3, closed(4001, 'Unauthorized')]);
    expect(auth.state).toMatchObject({ phase: 'refused', ended: { cause: 'auth' } });
    expect(dueAt(auth.state)).toBe(Infinity);
    expect(words(auth.state, 1)).toBe(
      'wss://game.example/ws refused the sign-in (code 4001, “Unauthorized”): the token is missing, invalid or expired. Sign in again.',
    );
    const origin = play([0.3, closed(4003, 'Origin not allowed')]);
    expect(words(origin.state, 1)).toBe(
      'wss://game.example/ws does not accept pages from here (code 4003, “Origin not allowed”): open the page from an allowed origin.',
    );
    expect(stepLink(auth.state, { kind: 'retry' }, 2, 0.5).effects).toEqual(['open']);
  });

  it('ends for good when closed', () => {
    const ended = play(...LIVE, [1, { kind: 'end' }]);
    expect(ended.effects).toEqual(['close']);
    for (const event of [closed(1006), TIME, { kind: 'opened' }, { kind: 'retry' }] as const)
      expect(stepLink(ended.state, event, 100, 0.5)).toMatchObject({
        state: { phase: 'ended' },
        effects: [],
      });
  });
});
