import { describe, expect, it } from 'vitest';
import { rotateBack } from '../../../src/prediction/drawn/rotation';
import type { WorldView } from '../../../src/prediction';
import { createRig, scenarioNamed } from '../rig';

/** Position of the player's ship in its body's axes, m. */
function inBody(view: WorldView): Float64Array {
  const place = new Float64Array(3);
  const own = view.own!;
  rotateBack(place, Float64Array.from(view.bodies[own.body]!.attitude), own.meshPosition);
  return place;
}

describe('a ship too fast to predict', () => {
  it.each([
    ['tipped', 'topple-mars'],
    ['landed', 'settle-earth'],
  ])('stays on its ground when %s', (state, name) => {
    const rig = createRig({ scenario: scenarioNamed(name), tickRate: 0.5 });
    rig.fly(state === 'tipped' ? 24 : 8);
    rig.authority.setTimeScale(100);
    rig.fly(6);
    let place: Float64Array | null = null;
    let seen = 0;
    rig.fly(6, (view) => {
      const own = view.own!;
      expect(own.surfaceContactState).toBe(state);
      if (state === 'tipped') expect(own.provenance).toBe('off');
      const now = inBody(view);
      place ??= now;
      seen += 1;
      expect(Math.hypot(...now.map((x, k) => x - place![k]!))).toBeLessThan(0.05);
    });
    expect(seen).toBeGreaterThan(300);
  });
});
