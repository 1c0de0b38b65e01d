import { describe, expect, it } from 'vitest';
import { placeOf } from '../../../src/playground/recording/replayDeck';
import { makeView } from '../../readout/views';

describe('the position in a replay', () => {
  it('is a tick and a substep; the end of a tick is substep 0 of the next', () => {
    const at = (sinceTick: number) => placeOf({ ...makeView(), tick: 3, tickRate: 1, sinceTick });
    expect([0, 0.01, 0.994, 0.996].map(at)).toEqual([
      'tick 3, substep 0',
      'tick 3, substep 1',
      'tick 3, substep 99',
      'tick 4, substep 0',
    ]);
  });
});
