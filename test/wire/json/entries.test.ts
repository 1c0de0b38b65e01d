import { expect, it } from 'vitest';
import { BODIES } from '../../../src/dynamics';
import { decodeFrameJson } from '../../../src/wire';

const { mass, radius } = BODIES[0]!;
const BODY = { mass, radius, position: [0, 0, 0], velocity: [0, 0, 0], axis: [0, 1, 0], period: 100 };

it('refuses an entry whose own name differs from its key', () => {
  const decoded = decodeFrameJson({
    tick: 7,
    ships: [],
    bodies: { One: { ...BODY, name: 'One' }, Two: { ...BODY, name: 'Three' }, Four: BODY },
  });
  if (!decoded.ok) throw new Error(decoded.reason);
  expect(decoded.value.bodies?.map(({ name }) => name)).toEqual(['One', 'Four']);
  expect(decoded.value.refusals).toEqual(['bodies["Two"].name: expected "Two", got "Three"']);
});
