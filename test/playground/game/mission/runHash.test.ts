import { describe, expect, it } from 'vitest';
import { hashRows } from '../../../../src/dynamics';
import { createRunHash } from '../../../../src/playground/game/mission/runHash';
import type { PartialFrame } from '../../../../src/wire';

const shipAt = (shipId: string, x: number) => ({
  shipId,
  relativePosition: [x, 2, 3],
  relativeVelocity: [4, 5, 6],
  attitude: [0, 0, 0.6, 0.8],
  angularVelocity: [7, 8, 9],
  fuel: 10,
});

function frameAt(tick: number, ships: readonly object[] = [shipAt('own', tick)]): PartialFrame {
  return { kind: 'frame', tick, ships } as unknown as PartialFrame;
}

const hashAt = (tick: number) =>
  `${tick}:${hashRows(Float64Array.of(tick, 2, 3, 4, 5, 6, 0, 0, 0.6, 0.8, 7, 8, 9, 10))}`;

describe('the hash of a run', () => {
  it('is that of the last state within the scenario, and then stays', () => {
    const hash = createRunHash(8);
    expect([hash.text(), hash.ended()]).toEqual(['', false]);
    // Frames may overtake one another.
    for (const tick of [0, 7, 5]) hash.take(frameAt(tick));
    expect([hash.text(), hash.ended()]).toEqual([hashAt(7), false]);
    hash.take(frameAt(8));
    expect([hash.text(), hash.ended()]).toEqual([hashAt(8), true]);
    hash.take(frameAt(9));
    expect(hash.text()).toBe(hashAt(8));
  });

  it('is the player’s ship’s, from states that are exact', () => {
    const hash = createRunHash(8);
    hash.take(frameAt(0));
    hash.take(frameAt(1, [shipAt('other', 1)]));
    hash.take(frameAt(2, [{ ...shipAt('own', 2), relativePosition: null }]));
    hash.take(frameAt(3, [{ ...shipAt('own', 3), relativeVelocity: null }]));
    expect(hash.text()).toBe(hashAt(0));
    hash.take(frameAt(4, [shipAt('other', 1), shipAt('own', 4)]));
    expect(hash.text()).toBe(hashAt(4));
  });

  it('ends where the server skips the last tick, so that a hidden page does not decode every state for ever', () => {
    const hash = createRunHash(8);
    hash.take(frameAt(7));
    hash.take(frameAt(12));
    expect([hash.text(), hash.ended()]).toEqual([hashAt(7), true]);
    // Whatever comes late.
    hash.take(frameAt(6));
    expect(hash.ended()).toBe(true);
  });

  it('needs no state if there is no scenario to hash', () => {
    const hash = createRunHash();
    expect(hash.ended()).toBe(true);
    hash.take(frameAt(0));
    expect([hash.text(), hash.ended()]).toEqual(['', true]);
  });
});
