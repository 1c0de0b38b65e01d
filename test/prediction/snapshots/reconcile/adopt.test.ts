/** A server's state as a row of the simulation: what is sent, what is completed, and what is refused. */
import { describe, expect, it } from 'vitest';
import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  ATTITUDE_HOLD,
  ATTITUDE_MODE,
  BODY_POSITION,
  BODY_STRIDE,
  BODY_VELOCITY,
  CONTACT,
  type Controls,
  CRASHED,
  FLYING,
  FUEL,
  GROUND_CONTACT_OFFSET,
  IMPACT_SPEED,
  LANDED,
  modeNumber,
  POSITION,
  REFERENCE_BODY,
  ROTATION_INPUT,
  SHIP_CLASS,
  SHIP_STRIDE,
  SURFACE_STATE,
  TARGET_ATTITUDE,
  THRUST_LEVEL,
  TIPPED,
  TRANSLATION_INPUT,
  VELOCITY,
  WHEEL_MOMENTUM,
  type World,
} from '../../../../src/dynamics';
import { holdsCommand, sameCommand, sameControls } from '../../../../src/prediction/inputs/command';
import { adopt, drawableState, isExact } from '../../../../src/prediction/snapshots/reconcile/adopt';
import { shipFault } from '../../../../src/prediction/snapshots/shipFault';
import type { ShipState } from '../../../../src/wire';
import { STILL } from '../../faults/restingShip';

const WORLD = {
  bodies: [
    { name: 'Large', radius: 100 },
    { name: 'Small', radius: 10 },
  ],
  shipClasses: [
    { name: 'lander', groundContactOffset: 2 },
    { name: 'hauler', groundContactOffset: 5 },
  ],
} as unknown as World;
const BODIES = new Float64Array(2 * BODY_STRIDE);
BODIES.set([10, 20, 30], BODY_POSITION);
BODIES.set([1, 2, 3], BODY_VELOCITY);
BODIES.set([1000, -200, 300], BODY_STRIDE + BODY_POSITION);
BODIES.set([-4, 5, -6], BODY_STRIDE + BODY_VELOCITY);

const STATE: ShipState = {
  ...STILL,
  shipClass: 'hauler',
  position: [900, -250, 370],
  velocity: [7, -8, 9],
  attitude: [0.1, 0.7, -0.5, 0.5],
  angularVelocity: [0.01, -0.02, 0.03],
  rotationInput: [0.1, -0.2, 0.3],
  translationInput: [-0.4, 0.5, -0.6],
  thrustLevel: 0.7,
  attitudeHold: true,
  attitudeMode: 'prograde',
  targetAttitude: [0.5, 0.5, -0.5, 0.5],
  fuel: 123,
  wheelMomentum: [11, 12, -13],
  groundContactOffset: 4.5,
  landedBodyName: '',
  surfaceContactState: 'contact',
  contactImpactSpeed: 1.5,
  referenceBody: 'Small',
  relativePosition: [-101, -51, 71],
  relativeVelocity: [12, -14, 16],
};

function rowOf(changes: Partial<ShipState> = {}) {
  const row = new Float64Array(SHIP_STRIDE).fill(-99);
  const refused = adopt(row, { ...STATE, ...changes }, BODIES, WORLD);
  return { refused, at: (column: number, count = 1) => [...row.subarray(column, column + count)] };
}

describe('a state', () => {
  it('is written as sent', () => {
    const { refused, at } = rowOf();
    expect(refused).toBeNull();
    expect(at(POSITION, 3)).toEqual([-101, -51, 71]);
    expect(at(VELOCITY, 3)).toEqual([12, -14, 16]);
    expect(at(ATTITUDE, 4)).toEqual(STATE.attitude);
    expect(at(ANGULAR_VELOCITY, 3)).toEqual(STATE.angularVelocity);
    expect(at(WHEEL_MOMENTUM, 3)).toEqual(STATE.wheelMomentum);
    expect(at(ROTATION_INPUT, 3)).toEqual(STATE.rotationInput);
    expect(at(TRANSLATION_INPUT, 3)).toEqual(STATE.translationInput);
    expect(at(TARGET_ATTITUDE, 4)).toEqual(STATE.targetAttitude);
    expect([FUEL, GROUND_CONTACT_OFFSET, IMPACT_SPEED, THRUST_LEVEL].flatMap((k) => at(k))).toEqual([
      ...[123, 4.5, 1.5, 0.7],
    ]);
    expect([SURFACE_STATE, REFERENCE_BODY, CRASHED, SHIP_CLASS].flatMap((k) => at(k))).toEqual([
      ...[CONTACT, 1, 0, 1],
    ]);
    expect([...at(ATTITUDE_HOLD), ...at(ATTITUDE_MODE)]).toEqual([1, modeNumber('prograde')]);
  });

  it('without a relative state is computed from ICRF and the body', () => {
    const { at } = rowOf({ relativePosition: null, relativeVelocity: null });
    expect([at(POSITION, 3), at(VELOCITY, 3)]).toEqual([
      [-100, -50, 70],
      [11, -13, 15],
    ]);
    expect([null, [1, 2, 3] as const].map((v) => isExact({ ...STATE, relativePosition: v }))).toEqual([
      false,
      true,
    ]);
    expect(isExact({ ...STATE, relativeVelocity: null })).toBe(false);
  });

  it('without momentum and impact speed keeps the ship’s own, and has its class’s offset', () => {
    const { at } = rowOf({ wheelMomentum: null, contactImpactSpeed: null, groundContactOffset: null });
    expect([...at(WHEEL_MOMENTUM, 3), ...at(IMPACT_SPEED)]).toEqual([NaN, NaN, NaN, NaN]);
    expect(at(GROUND_CONTACT_OFFSET)).toEqual([5]);
    expect(rowOf({ surfaceContactState: '', contactImpactSpeed: null }).at(IMPACT_SPEED)).toEqual([0]);
  });

  it.each([
    ['', '', false, FLYING],
    ['', 'Small', false, LANDED],
    ['tipped', 'Small', false, TIPPED],
    ['landed', '', true, FLYING],
  ] as const)(
    '"%s" with a body "%s" landed on, crashed %s, is %i',
    (surfaceContactState, landedBodyName, crashed, state) => {
      const { at } = rowOf({ surfaceContactState, landedBodyName, crashed });
      expect([...at(SURFACE_STATE), ...at(CRASHED)]).toEqual([state, crashed ? 1 : 0]);
    },
  );

  it('is relative to the body named, to the one landed on, or to the nearest in its radii', () => {
    const bodyOf = (changes: Partial<ShipState>) =>
      rowOf({ referenceBody: '', ...changes }).at(REFERENCE_BODY)[0];
    expect(bodyOf({ referenceBody: 'Large', landedBodyName: 'Small' })).toBe(0);
    expect(bodyOf({ landedBodyName: 'Small', position: [10, 20, 130] })).toBe(1);
    // 10 and 11 radii of the large one away, and 10.5 of the small one.
    const between = (z: number): Partial<ShipState> => ({ position: [1000, -200, 300 + z] });
    const radii = Math.sqrt(990 ** 2 + 220 ** 2 + 270 ** 2) / 100;
    expect([10 * radii - 4, 10 * radii + 9].map((z) => bodyOf(between(z)))).toEqual([1, 0]);
  });

  it.each([
    ['referenceBody: no body named Mars', { referenceBody: 'Mars' }],
    ['shipClass: no class named kite', { shipClass: 'kite' }],
    ['surfaceContactState: no state named afloat', { surfaceContactState: 'afloat' as 'landed' }],
    ['position: expected ≥ 1 m', { relativePosition: [0.5, -0.5, 0.7] as const }],
    ['position: expected ≥ 1 m', { relativePosition: null, position: [1000.5, -199.5, 300.7] as const }],
  ])('is refused: %s', (reason, changes) => {
    const { refused, at } = rowOf(changes);
    expect(refused).toContain(reason);
    expect(at(0, SHIP_STRIDE).every((x) => x === -99)).toBe(true);
  });

  it('a metre from the centre is not refused', () => {
    expect(rowOf({ relativePosition: [0.6, -0.5, 0.7] }).refused).toBeNull();
    expect(rowOf({ relativePosition: null, position: [1000.6, -199.5, 300.7] }).refused).toBeNull();
  });

  it('of an unknown class or surface state is drawn as the first class, in flight', () => {
    expect(drawableState(STATE, WORLD)).toEqual(STATE);
    const unknown = { ...STATE, shipClass: 'kite', surfaceContactState: 'afloat' as 'landed' };
    expect(drawableState(unknown, WORLD)).toEqual({ ...STATE, shipClass: 'lander', surfaceContactState: '' });
  });
});

const lists = (count: number) => [[], Array(count - 1).fill(0), Array(count + 1).fill(0), 'text', undefined];
const wrong = (count: number) => [
  ...lists(count),
  ...Array.from({ length: count }, (_, k) => Array.from({ length: count }, (_one, i) => (i === k ? NaN : 0))),
];

describe('a malformed state is refused by its field', () => {
  it.each([
    ...['position', 'velocity', 'angularVelocity', 'rotationInput', 'translationInput'].map((name) => [
      name,
      3,
    ]),
    ...['attitude', 'targetAttitude'].map((name) => [name, 4]),
    ...['relativePosition', 'relativeVelocity'].map((name) => [name, 3]),
  ] as [string, number][])('%s: a list of %i finite numbers', (name, count) => {
    for (const given of wrong(count))
      expect(shipFault({ ...STATE, [name]: given })).toMatch(
        new RegExp(`^${name}: expected a list of ${String(count)} finite numbers, got `),
      );
    const isOptional = name.startsWith('relative');
    expect(shipFault({ ...STATE, [name]: null }) === null).toBe(isOptional);
  });

  it.each(['thrustLevel', 'fuel'])('%s: a finite number', (name) => {
    for (const given of [NaN, Infinity, '1', null])
      expect(shipFault({ ...STATE, [name]: given })).toMatch(
        new RegExp(`^${name}: expected a finite number, got `),
      );
  });

  it('a complete one is accepted', () => {
    expect(shipFault(STATE)).toBeNull();
    for (const given of [null, undefined, 7]) expect(shipFault(given)).toBe('expected an object');
    for (const shipId of ['', 7]) expect(shipFault({ ...STATE, shipId })).toBe('shipId: expected a string');
  });
});

describe('two commands', () => {
  const row = (changes: Partial<ShipState>) => {
    const rows = new Float64Array(2 * SHIP_STRIDE);
    adopt(rows.subarray(SHIP_STRIDE), { ...STATE, ...changes }, BODIES, WORLD);
    return rows;
  };
  const near = (by: number): Partial<ShipState>[] => [
    { thrustLevel: 0.7 - by },
    { rotationInput: [0.1, -0.2 + by, 0.3] },
    { translationInput: [-0.4, 0.5, -0.6 - by] },
    { targetAttitude: [0.5, 0.5, -0.5, 0.5 + by] },
    { targetAttitude: [0.5 - by, 0.5, -0.5, 0.5] },
  ];
  const compared = (changes: Partial<ShipState>) => {
    // Both have a known attitude mode.
    const other = { ...STATE, ...changes };
    return [
      sameControls(STATE as Controls, other),
      holdsCommand(row({}), SHIP_STRIDE, other as Controls),
      sameCommand(row({}), SHIP_STRIDE, row(changes), SHIP_STRIDE),
    ];
  };

  it.each(near(0.9e-6))('are the same within single precision: %o', (changes) => {
    expect(compared(changes)).toEqual([true, true, true]);
  });

  it.each([...near(1.1e-6), { attitudeHold: false }, { attitudeMode: 'retrograde' as const }])(
    'differ beyond it: %o',
    (changes) => {
      expect(compared(changes)).toEqual([false, false, false]);
    },
  );
});
