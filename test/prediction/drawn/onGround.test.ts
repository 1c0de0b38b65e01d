import { expect, it } from 'vitest';
import { GROUND_CONTACT_OFFSET, POSITION } from '../../../src/dynamics';
import { fillView } from '../../../src/prediction/drawn/worldView';
import { beginReading } from '../../../src/prediction/ground/learnedGround';
import { sessionAt, shipAt } from '../decisions/sessionAt';

it('ground learned from one ship does not move the next one', () => {
  const { sim, viewBuilder } = sessionAt(100);
  const learning = shipAt(sim, 'own', 'landed');
  const { name, radius } = sim.world.bodies[0]!;
  for (const { at } of [learning, shipAt(sim, 'other', 'landed', 100)])
    for (const rows of [sim.fleet.front, sim.fleet.previous]) {
      const position = rows.subarray(at + POSITION, at + POSITION + 3);
      const onGround = (radius + rows[at + GROUND_CONTACT_OFFSET]!) / Math.hypot(...position);
      position.set(position.map((x) => x * onGround));
    }
  const nextDrawn = () => {
    fillView(viewBuilder, sim);
    const { meshPosition, legCompression, feetHeight } = viewBuilder.view.ships[1]!;
    return [...meshPosition, ...legCompression, feetHeight];
  };
  const before = nextDrawn();
  // 100 m beside it: the next ship's, which was drawn last.
  const direction = viewBuilder.context.normal.slice();
  beginReading(learning.ground);
  learning.ground.places.push({
    ...{ bodyName: name, bodyRadius: radius, direction },
    ...{ slope: new Float64Array(3), offset: 2, states: 1, seenAt: 0, weight: 1 },
  });
  expect(nextDrawn()).toEqual(before);
  expect(viewBuilder.view.ships[0]!.groundOffset).toBeCloseTo(2, 9);
});
