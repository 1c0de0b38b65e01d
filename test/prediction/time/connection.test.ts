import { describe, expect, it } from 'vitest';
import { createCadence, noteSend } from '../../../src/prediction/time/cadence';
import { connectionOf, staleAfter } from '../../../src/prediction/time/connection';

/** A server of 1 Hz that sends each tick. */
const cadence = createCadence();
for (let k = 0; k < 4; k++) noteSend(cadence, 1);

const never = Number.POSITIVE_INFINITY;
const after = (frame: number, pong: number, paused = false) =>
  connectionOf({ frame, pong }, cadence, { tickRate: 1, paused });

describe('the connection', () => {
  it.each([
    ['waiting', never, never],
    ['live', 2, never],
    ['silent', 2.01, never],
    ['silent', 1000, never],
    ['serverPaused', 2.01, 1],
    ['stalled', 2.01, 1.01],
    ['stalled', 1000, 10],
    ['gone', 1000, 10.01],
    ['stalled', 10, 1000],
    ['gone', 10.01, 1000],
  ] as const)('is %s %f s after a frame and %f s after a pong', (expected, frame, pong) => {
    expect(after(frame, pong)).toBe(expected);
  });

  it('is serverPaused after a frame of a paused server, until pings go unanswered', () => {
    expect(after(1, never, true)).toBe('serverPaused');
    expect(after(1000, never, true)).toBe('serverPaused');
    expect(after(1000, 5, true)).toBe('stalled');
    expect(after(1000, 11, true)).toBe('gone');
  });

  it('of a slow server is gone only after five missed sends', () => {
    expect(connectionOf({ frame: 51, pong: 50 }, cadence, { tickRate: 0.1, paused: false })).toBe('stalled');
    expect(connectionOf({ frame: 51, pong: 50.1 }, cadence, { tickRate: 0.1, paused: false })).toBe('gone');
  });

  it('is stale after two missed sends and at least 0.3 s, or after 1.5 s while the interval is unknown', () => {
    expect(staleAfter(cadence, 1)).toBe(2);
    expect(staleAfter(cadence, 20)).toBe(0.3);
    expect(staleAfter(createCadence(), 20)).toBe(1.5);
    expect(staleAfter(createCadence(), 0.5)).toBe(4);
  });
});
