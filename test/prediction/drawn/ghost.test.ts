import { describe, expect, it } from 'vitest';
import { POSITION, REFERENCE_BODY } from '../../../src/dynamics';
import type { ShipView, WorldView } from '../../../src/prediction';
import { groundGhost } from '../../../src/prediction/drawn/ghost';
import { rotate, rotateBack } from '../../../src/prediction/drawn/rotation';
import { createShipView } from '../../../src/prediction/drawn/shipView';
import { sessionAt, shipAt } from '../decisions/sessionAt';
import { createRig, scenarioNamed } from '../rig';

/** The ship's drawn position in its body's axes, m. */
function stoodInBody(view: WorldView, ship: ShipView): Float64Array {
  const attitude = Float64Array.from(view.bodies[ship.body]!.attitude);
  const place = new Float64Array(3);
  rotateBack(place, attitude, ship.meshPosition);
  return place;
}

function apart(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return Math.hypot(a[0]! - b[0]!, a[1]! - b[1]!, a[2]! - b[2]!);
}

describe('the ghost of the server’s state', () => {
  for (const { name, seconds, state } of [
    { name: 'topple', seconds: 11, state: 'tipped' },
    { name: 'settle-earth', seconds: 5.5, state: 'landed' },
    { name: 'up-a-slope', seconds: 25, state: 'landed' },
  ] as const)
    it(`${name}: coincides with the drawn ship when nothing is left to correct`, () => {
      const rig = createRig({ scenario: name });
      rig.fly(seconds);
      const view = rig.view();
      const own = view.own!;
      expect(own.surfaceContactState).toBe(state);
      expect(apart(own.ghostPosition, stoodInBody(view, own))).toBeLessThan(2e-3);
      const alongGhost = Float64Array.of(0, 0, 1);
      rotate(alongGhost, own.ghostAttitude, alongGhost);
      rotate(alongGhost, Float64Array.from(view.bodies[own.body]!.attitude), alongGhost);
      const alongShip = Float64Array.of(0, 0, 1);
      rotate(alongShip, own.meshAttitude, alongShip);
      expect(apart(alongGhost, alongShip)).toBeLessThan(2e-3);
    });

  it('is lowered for a tipped ship, and is unchanged in flight', () => {
    const rig = createRig({ scenario: 'topple' });
    rig.fly(11);
    const { own } = rig.view();
    const h = own!.shipClass.groundContactOffset;
    const sunk = Math.hypot(...own!.serverPosition) - Math.hypot(...own!.ghostPosition);
    expect(sunk).toBeGreaterThan(0.3 * h);

    const far = createRig({ scenario: scenarioNamed('pointing') });
    far.fly(3);
    const flying = far.view().own!;
    expect(flying.serverKnown).toBe(true);
    expect(Math.hypot(...flying.ghostPosition)).toBeCloseTo(Math.hypot(...flying.serverPosition), 6);
  });
});

it('the ghost of a tipped ship is put on the ground of the body that its state names', () => {
  const { sim, viewBuilder } = sessionAt(100);
  const track = shipAt(sim, 'own', 'tipped');
  const [moon] = sim.world.bodies;
  const hill = (body: string) => (body === 'hilly' ? 5 : 0);
  const world = { ...sim.world, bodies: [moon!, { ...moon!, name: 'hilly' }], terrainHeight: hill };
  const context = {
    ...viewBuilder.context,
    world,
    ground: { ...viewBuilder.context.ground, terrainHeight: hill },
  };
  const out = createShipView(track, world);
  const height = (body: number) => {
    track.serverRow[REFERENCE_BODY] = body;
    out.ghostPosition.set(track.serverRow.subarray(POSITION, POSITION + 3));
    groundGhost(out, track, context, true);
    return Math.hypot(...out.ghostPosition);
  };
  expect(height(1) - height(0)).toBeCloseTo(5, 3);
});
