/** Two states of one tick: what counts as equal, and how far apart they are. */
import { describe, expect, it } from 'vitest';
import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  BODY_ATTITUDE,
  BODY_POSITION,
  BODY_STRIDE,
  CRASHED,
  FUEL,
  GROUND_CONTACT_OFFSET,
  POSITION,
  type Quat,
  REFERENCE_BODY,
  SHIP_CLASS,
  SHIP_STRIDE,
  SURFACE_STATE,
  type Vec3,
  VELOCITY,
  WHEEL_MOMENTUM,
} from '../../../../src/dynamics';
import {
  describeDifference,
  EXACT,
  firstDifference,
  type Place,
  writeError,
  writeInexact,
} from '../../../../src/prediction/snapshots/reconcile/compare';
import { rotate, turnAbout, unit } from '../../../dynamics/vectors';

const AXIS = unit([1, -2, 2]);

/** A ship at (3, −4, 12) km on the second body of two, after the `changes` to columns. */
function stateWith(
  changes: Readonly<Record<number, readonly number[]>> = {},
  body: Quat = [0, 0, 0, 1],
): Place {
  const rows = new Float64Array(2 * SHIP_STRIDE);
  const at = SHIP_STRIDE;
  rows.set([3000, -4000, 12_000], at + POSITION);
  rows.set([10, 20, -30], at + VELOCITY);
  rows.set([0, 0, 0, 1], at + ATTITUDE);
  rows[at + REFERENCE_BODY] = 1;
  for (const [column, values] of Object.entries(changes)) rows.set(values, at + Number(column));
  const bodies = new Float64Array(2 * BODY_STRIDE);
  bodies.set(body, BODY_STRIDE + BODY_ATTITUDE);
  return { rows, at, bodies };
}

/** `from` and a vector of this length, along (2, −3, 6), whose length is 7. */
const vectorOf = (length: number, from: readonly number[] = [0, 0, 0]) =>
  [2, -3, 6].map((part, k) => from[k]! + (part * length) / 7);

const higher = (column: number, by: number) => ({ [column]: [by] });

describe('the first difference', () => {
  it.each([
    ['shipClass', higher(SHIP_CLASS, 1)],
    ['crashed', higher(CRASHED, 1)],
    ['surfaceContactState', higher(SURFACE_STATE, 1)],
    ['groundContactOffset', higher(GROUND_CONTACT_OFFSET, 1e-9)],
    ['position', { [POSITION]: vectorOf(1.01e-6, [3000, -4000, 12_000]) }],
    ['velocity', { [VELOCITY]: vectorOf(1.01e-6, [10, 20, -30]) }],
    ['angularVelocity', { [ANGULAR_VELOCITY]: vectorOf(1.01e-6) }],
    ['fuel', higher(FUEL, 1.01e-6)],
    ['wheelMomentum', higher(WHEEL_MOMENTUM, 1.01e-4)],
    ['wheelMomentum', higher(WHEEL_MOMENTUM + 2, 1.01e-4)],
    ['attitude', { [ATTITUDE]: [1.01e-7, 0, 0, 1] }],
    ['attitude', { [ATTITUDE]: [0, 0, -1.01e-7, 1] }],
    ['none', { [POSITION]: vectorOf(0.99e-6, [3000, -4000, 12_000]) }],
    ['none', { [VELOCITY]: vectorOf(0.99e-6, [10, 20, -30]) }],
    ['none', { [ANGULAR_VELOCITY]: vectorOf(0.99e-6) }],
    ['none', higher(FUEL, 0.99e-6)],
    ['none', higher(WHEEL_MOMENTUM + 1, 0.99e-4)],
    ['none', { [ATTITUDE]: [0, 0.99e-7, 0, 1] }],
    ['none', { [ATTITUDE]: [0, 0, 0, -1] }],
  ] as const)('is %s, either way round: %o', (field, changes) => {
    expect(firstDifference(stateWith(changes), stateWith(), EXACT)).toBe(field);
    expect(firstDifference(stateWith(), stateWith(changes), EXACT)).toBe(field);
  });

  it('is the reference body before anything of the motion', () => {
    const other = { [REFERENCE_BODY]: [0], [POSITION]: [0, 0, 0] };
    expect(firstDifference(stateWith(other), stateWith(), EXACT)).toBe('referenceBody');
  });

  it('is the field that is NaN', () => {
    expect(firstDifference(stateWith({ [FUEL]: [NaN] }), stateWith(), EXACT)).toBe('fuel');
    expect(firstDifference(stateWith({ [WHEEL_MOMENTUM]: [NaN] }), stateWith(), EXACT)).toBe('wheelMomentum');
    expect(firstDifference(stateWith({ [ATTITUDE]: [NaN] }), stateWith(), EXACT)).toBe('attitude');
  });

  it('is seen in the axes of each body, which may have turned', () => {
    const turn = turnAbout(AXIS, 1.2);
    const turned = stateWith({}, turn);
    expect(firstDifference(turned, stateWith(), EXACT)).toBe('position');
    const { rows, at } = stateWith();
    for (const column of [POSITION, VELOCITY, ANGULAR_VELOCITY]) {
      const level = [...rows.subarray(at + column, at + column + 3)] as unknown as Vec3;
      turned.rows.set(rotate(turn, level), at + column);
    }
    turned.rows.set(turn, at + ATTITUDE);
    expect(firstDifference(turned, stateWith(), EXACT)).toBe('none');
  });
});

describe('the tolerance of ICRF alone', () => {
  const toleranceAt = (...coordinates: number[]) => {
    const state = stateWith({ [POSITION]: [1, 2, 3] });
    state.bodies.set(
      coordinates.map((x, k) => x - (k + 1)),
      BODY_STRIDE + BODY_POSITION,
    );
    const out = Float64Array.of(9, 9, 9);
    writeInexact(out, state);
    return [...out];
  };

  it('is 8 ulp of the largest coordinate, and ten times that per second', () => {
    // 1 au is between 2³⁷ and 2³⁸ m: doubles there are 2⁻¹⁵ m apart.
    const place = 8 * 2 ** -15;
    for (const at of [
      [1.5e11, 0, 0],
      [0, -1.5e11, 0],
      [-3, 5, 1.5e11],
    ])
      expect(toleranceAt(...at)).toEqual([place, 10 * place, 1e-6]);
    expect(toleranceAt(2 ** 37, 0, 0)[0]).toBe(place);
    expect(toleranceAt(2 ** 37 - 1, 0, 0)[0]).toBe(place / 2);
  });

  it('is never below that of the relative state', () => {
    for (const x of [2 ** 28, 0]) expect(toleranceAt(x, 2, 3)).toEqual([1e-6, 10 * 1e-6, 1e-6]);
  });
});

describe('the error of a prediction', () => {
  const errorOf = (server: Place, predicted: Place | null) => {
    const out = { errorPosition: 9, errorAngle: 9 };
    writeError(out, server, predicted);
    return out;
  };

  it('is the distance, and the angle between the attitudes', () => {
    const server = stateWith({
      [POSITION]: vectorOf(14, [3000, -4000, 12_000]),
      [ATTITUDE]: turnAbout(AXIS, 0.3),
    });
    const { errorPosition, errorAngle } = errorOf(server, stateWith());
    expect(errorPosition).toBeCloseTo(14, 9);
    expect(errorAngle).toBeCloseTo(0.3, 12);
  });

  it('is unknown without a prediction, and where the bodies differ', () => {
    const unknown = { errorPosition: NaN, errorAngle: NaN };
    expect(errorOf(stateWith(), null)).toEqual(unknown);
    expect(errorOf(stateWith(), stateWith({ [REFERENCE_BODY]: [0] }))).toEqual(unknown);
  });
});

it.each([
  ['position', { [POSITION]: [1, 2, 3] }, '[1, 2, 3], predicted [3000, -4000, 12000]'],
  ['velocity', { [VELOCITY]: [1, 2, 3] }, '[1, 2, 3], predicted [10, 20, -30]'],
  ['attitude', { [ATTITUDE]: [1, 0, 0, 0] }, '[1, 0, 0, 0], predicted [0, 0, 0, 1]'],
  ['angularVelocity', { [ANGULAR_VELOCITY]: [1, 2, 3] }, '[1, 2, 3], predicted [0, 0, 0]'],
  ['surfaceContactState', { [SURFACE_STATE]: [2] }, "'landed', predicted ''"],
  ['fuel', { [FUEL]: [5] }, '5, predicted 0'],
  ['wheelMomentum', { [WHEEL_MOMENTUM]: [1, 2, 3] }, '[1, 2, 3], predicted [0, 0, 0]'],
  ['groundContactOffset', { [GROUND_CONTACT_OFFSET]: [4.5] }, '4.5, predicted 0'],
  ['crashed', { [CRASHED]: [1] }, '1, predicted 0'],
  ['referenceBody', { [REFERENCE_BODY]: [0] }, '0, predicted 1'],
  ['shipClass', { [SHIP_CLASS]: [2] }, '2, predicted 0'],
] as const)('the difference in %s is described with both values', (field, changes, text) => {
  expect(describeDifference(field, stateWith(changes), stateWith())).toBe(`${field}: server ${text}`);
});
