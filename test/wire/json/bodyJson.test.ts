import fc from 'fast-check';
import { expect, it } from 'vitest';
import type { Quat, Vec3 } from '../../../src/dynamics';
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

/** q v q*, of a unit quaternion [x, y, z, w]. */
function turned([x, y, z, w]: Quat, v: Vec3): Vec3 {
  const t = cross([x, y, z], v).map((part) => 2 * part) as unknown as Vec3;
  const u = cross([x, y, z], t);
  return [v[0] + w * t[0] + u[0], v[1] + w * t[1] + u[1], v[2] + w * t[2] + u[2]];
}

const cross = ([a, b, c]: Vec3, [d, e, f]: Vec3): Vec3 => [b * f - c * e, c * d - a * f, a * e - b * d];
const dot = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

it('turns a body about any axis, from the shortest rotation of its pole to it at game time 0', () => {
  const part = fc.double({ min: -1, max: 1, noNaN: true });
  const axes = fc.tuple(part, part, part).filter((axis) => Math.hypot(...axis) > 0.1);
  // A sent axis is a unit vector within a thousandth.
  const stretched = fc.double({ min: 0.9991, max: 1.0009, noNaN: true });
  const periods = fc.oneof(
    fc.double({ min: 0.1, max: 1e7, noNaN: true }),
    fc.double({ min: -1e7, max: -0.1, noNaN: true }),
  );
  const turns = fc.double({ min: -3, max: 3, noNaN: true });
  fc.assert(
    fc.property(axes, stretched, periods, turns, (direction, stretch, period, turn) => {
      const length = Math.hypot(...direction);
      const axis = direction.map((k) => k / length) as unknown as Vec3;
      const sent = axis.map((k) => k * stretch);
      const at = (gameTime: number) =>
        accepted({
          tick: 0,
          game_time: gameTime,
          ships: [],
          bodies: [{ ...MOON, name: 'Odd', axis: sent, period }],
        }).bodies![0]!;
      const first = at(0).attitude;
      const then = at(turn * period);
      expect(dot([first[0], first[1], first[2]], axis)).toBeCloseTo(0, 9);
      expect(first[1]).toBeCloseTo(0, 9);
      expect(first[3]).toBeGreaterThanOrEqual(0);
      expect(Math.hypot(...then.attitude)).toBeCloseTo(1, 12);
      for (const [k, value] of turned(then.attitude, [0, 1, 0]).entries())
        expect(value).toBeCloseTo(axis[k]!, 9);
      // Rodrigues: what stood across the axis at time 0 stands turned by the angle.
      const before = turned(first, [1, 0, 0]);
      const angle = 2 * Math.PI * turn;
      const beside = cross(axis, before);
      for (const [k, value] of turned(then.attitude, [1, 0, 0]).entries())
        expect(value).toBeCloseTo(before[k]! * Math.cos(angle) + beside[k]! * Math.sin(angle), 5);
      for (const [k, value] of then.angularVelocity.entries())
        expect(value / ((2 * Math.PI) / period)).toBeCloseTo(axis[k]!, 9);
    }),
    {
      numRuns: 60,
      // The pole's opposite, and beside it.
      examples: [0, 1e-200, 1e-12, 1e-6, 1e-3].map((x) => [[x, -1, 0], 1, 10, 0.3]),
    },
  );
});

it.each([
  [[0, 0, 1.002], 10, 'axis: expected a unit vector, got one of length 1.002'],
  [[0, 0, 0.998], 10, 'axis: expected a unit vector, got one of length 0.998'],
  [[0, 0, 1], 0.09, 'period: expected at least 0.1 s, got 0.09'],
  [[0, 0, 1], -0.09, 'period: expected at least 0.1 s, got -0.09'],
])('refuses axis %j with period %d', (axis, period, reason) => {
  const decoded = accepted({ tick: 0, ships: [], bodies: [{ ...MOON, name: 'Odd', axis, period }] });
  expect(decoded.refusals).toEqual([`bodies[0].${reason}`]);
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
  ['2026-11-28T18:00:00.5-02:30', 1795897800.5],
  [12.5, 12.5],
  ['-7', -7],
])('reads the game time %j', (sent, seconds) => {
  expect(accepted({ tick: 0, ships: [], game_time: sent }).gameTime).toBe(seconds);
});

it('reads game times of any year as the calendar has them', () => {
  for (const year of [1, 399, 400, 401, 1599, 1600, 1900, 2000, 2399, 2400, 9999])
    for (const day of ['01-01', '02-28', '03-01', '12-31']) {
      const sent = `${String(year).padStart(4, '0')}-${day}T00:00:00Z`;
      expect(accepted({ tick: 0, ships: [], game_time: sent }).gameTime, sent).toBe(Date.parse(sent) / 1000);
    }
});
