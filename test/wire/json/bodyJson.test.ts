import { expect, it } from 'vitest';
import { decodeFrameJson, type DecodedFrame } from '../../../src/wire';

const MOON = { mass: 7.342e22, radius: 1737400, position: [1, 2, 3], velocity: [0, 0, 0] };

function accepted(value: unknown): DecodedFrame {
  const decoded = decodeFrameJson(value);
  if (!decoded.ok) throw new Error(decoded.reason);
  return decoded.value;
}

it('derives a body’s attitude and spin from axis and period', () => {
  const period = 86164.1;
  const body = { ...MOON, spin_axis: [0, 0, 1], rotation_period: period };
  const at = (gameTime: number) =>
    accepted({ tick: 0, game_time: gameTime, ships: [], bodies: { Earth: body } }).bodies![0]!;
  const rate = (2 * Math.PI) / period;
  expect(at(0).angularVelocity).toEqual([0, 0, rate]);
  for (const seconds of [0, 100, period / 3, 1e9]) {
    const [x, y, z, w] = at(seconds).attitude;
    // Directions of the body's pole (0, 1, 0) and X axis: R e_y and R e_x of a quaternion.
    const pole = [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)];
    const east = [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)];
    const angle = rate * seconds;
    for (const [k, value] of [0, 0, 1].entries()) expect(pole[k]).toBeCloseTo(value, 12);
    for (const [k, value] of [Math.cos(angle), Math.sin(angle), 0].entries())
      expect(east[k]).toBeCloseTo(value, 6);
  }
  const backward = { ...body, spinAxis: undefined, spin_axis: { x: 0, y: -1, z: 0 }, rotation_period: -10 };
  expect(
    accepted({ tick: 0, ships: [], bodies: { Odd: backward } }).bodies![0]!.angularVelocity[1],
  ).toBeCloseTo((2 * Math.PI) / 10, 12);
});

it('completes a known body, and refuses an unknown one without orientation', () => {
  const decoded = accepted({
    tick: 0,
    ships: [],
    bodies: [
      { name: 'Earth', position: [0, 0, 0], velocity: [0, 0, 0] },
      { ...MOON, name: 'Nowhere' },
      { ...MOON, name: 'Tilted', axis: [0, 0, 2], period: 100 },
    ],
  });
  expect(decoded.bodies).toHaveLength(1);
  expect(decoded.bodies![0]).toMatchObject({ name: 'Earth', mass: 5.9722e24 });
  expect(Math.hypot(...decoded.bodies![0]!.angularVelocity)).toBeCloseTo(7.2921e-5, 9);
  expect(decoded.refusals).toEqual([
    'bodies[1].attitude: missing, and so are spin_axis and rotation_period',
    'bodies[2].axis: expected a unit vector, got one of length 2',
  ]);
});

it.each([
  ['2026-11-28T20:30:00Z', 1795897800],
  ['2000-02-29T00:00:00', 951782400],
  ['1969-12-31T23:59:59.25Z', -0.75],
  ['2026-11-28T22:30:00.5+02:00', 1795897800.5],
  [12.5, 12.5],
  ['-7', -7],
])('reads the game time %j', (sent, seconds) => {
  expect(accepted({ tick: 0, ships: [], game_time: sent }).gameTime).toBe(seconds);
});
