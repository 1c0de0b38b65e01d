import { describe, expect, it } from 'vitest';
import { createRunHash } from '../../../src/playground/game/mission/runHash';
import type { PartialFrame } from '../../../src/wire';

function frameAt(tick: number): PartialFrame {
  const own = {
    shipId: 'own',
    relativePosition: [tick, 0, 0],
    relativeVelocity: [0, 0, 0],
    attitude: [0, 0, 0, 1],
    angularVelocity: [0, 0, 0],
    fuel: 1,
  };
  return { kind: 'frame', tick, ships: [own] } as unknown as PartialFrame;
}

describe('the hash of a run', () => {
  it('is that of the last state within the scenario, and then stays', () => {
    const hash = createRunHash();
    hash.begin(8);
    hash.take(frameAt(7));
    expect([hash.text().split(':')[0], hash.ended()]).toEqual(['7', false]);
    hash.take(frameAt(8));
    expect([hash.text().split(':')[0], hash.ended()]).toEqual(['8', true]);
    hash.take(frameAt(9));
    expect(hash.text().split(':')[0]).toBe('8');
  });

  it('ends where the server skips the last tick, so that a hidden page does not decode every state for ever', () => {
    const hash = createRunHash();
    hash.begin(8);
    hash.take(frameAt(7));
    hash.take(frameAt(12));
    expect([hash.text().split(':')[0], hash.ended()]).toEqual(['7', true]);
  });

  it('needs no state if there is no scenario to hash', () => {
    const hash = createRunHash();
    hash.begin(-1);
    expect([hash.text(), hash.ended()]).toEqual(['', true]);
  });
});
