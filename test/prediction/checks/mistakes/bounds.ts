/** Values on either side of the bound from which they are reported: the bound, the code, one within it, one beyond, what is done with it. */
import { NEUTRAL_CONTROLS, SHIP_CLASSES, type Vec3 } from '../../../../src/dynamics';
import { flown, LUNA, made, received, type Warning, withBody, withShip } from './given';

export type Bound = readonly [
  what: string,
  code: string,
  within: number,
  beyond: number,
  run: (value: number) => Warning[],
];

const FLYING = { landedBodyName: '', surfaceContactState: '' };
const turned = (angle: number) => [Math.sin(angle / 2), 0, 0, Math.cos(angle / 2)];
const long = (length: number) => turned(0.3).map((x) => x * length);

/** A flying ship at a place and velocity relative to a body that itself moves along +X of ICRF, m/s, and may stand off its origin, m. */
const beside = (place: Vec3, { velocity = 0, own = [0, 0, 0] as Vec3, at = [0, 0, 0] as Vec3 } = {}) =>
  received({
    ...withShip({ ...FLYING, position: place, velocity: own }),
    bodies: [{ ...LUNA, position: at, velocity: [velocity, 0, 0] }],
  });
const R = LUNA.radius;
const onGround = (height: number, changes: object = {}) =>
  received({
    ...withShip({ position: [R + height, 0, 0], velocity: [0, 0, 0], ...changes }),
    bodies: [{ ...LUNA, position: [0, 0, 0], velocity: [0, 0, 0] }],
  });
/** On the ground at +Y, tilted by `angle` about X after a turn by `yaw` about its own axis, rad, its attitude as [w, x, y, z]. */
export const reordered = (angle: number, { surfaceContactState = 'landed', yaw = 0 } = {}) => {
  const [s, c] = [Math.sin(Math.PI / 4 + angle / 2), Math.cos(Math.PI / 4 + angle / 2)];
  const [sinYaw, cosYaw] = [Math.sin(yaw / 2), Math.cos(yaw / 2)];
  const attitude = [c * cosYaw, -s * cosYaw, s * sinYaw, c * sinYaw];
  return onGround(0, { position: [0, R + 4.56, 0], attitude, surfaceContactState });
};
const relative = (x: number, apart = 0) =>
  received({
    ...withShip({
      position: [x + apart, 0, 0],
      ...{ referenceBody: 'Luna', relativePosition: [x, 0, 0], relativeVelocity: [0, 0, 0] },
    }),
    bodies: [{ ...LUNA, position: [0, 0, 0], velocity: [0, 0, 0] }],
  });
const density = (kgPerM3: number) => received(withBody({ mass: kgPerM3 * (4 / 3) * Math.PI * R ** 3 }));
const steered = (changes: object) => flown({ ...NEUTRAL_CONTROLS, ...changes });
const set = (settings: object) => made({ defaults: { settings } });
const degrees = (angle: number) => (angle * Math.PI) / 180;

const OF_SHIPS: readonly Bound[] = [
  [
    'a longer attitude',
    'attitude-not-unit',
    1.0009,
    1.0011,
    (x) => received(withShip({ attitude: long(x) })),
  ],
  ['a shorter one', 'attitude-not-unit', 0.9991, 0.9989, (x) => received(withShip({ attitude: long(x) }))],
  ['spin', 'spin-in-degrees', 12.6, 12.61, (x) => received(withShip({ angularVelocity: [0, x, 0] }))],
  ['thrust', 'state-out-of-range', 1.0009, 1.0011, (x) => received(withShip({ thrustLevel: x }))],
  ['thrust below 0', 'state-out-of-range', 0, -1e-6, (x) => received(withShip({ thrustLevel: x }))],
  ['a turn', 'state-out-of-range', -1, -1.0011, (x) => received(withShip({ rotationInput: [0, x, 0] }))],
  ['a push', 'state-out-of-range', -1, -1.0011, (x) => received(withShip({ translationInput: [x, 0, 0] }))],
  ['fuel', 'state-out-of-range', 0, -1e-6, (x) => received(withShip({ fuel: x }))],
  ['1/1000 of a height below', 'position-in-kilometres', 0.69e-3, 0.71e-3, (x) => beside([R * x, 0, 0])],
  ['1/1000 of a height above', 'position-in-kilometres', 1.31e-3, 1.29e-3, (x) => beside([R * x, 0, 0])],
  [
    '1/1000 of an ICRF height',
    'position-in-kilometres',
    2.01,
    1.99,
    (x) => beside([0.05 * R, (R * x) / 1000, 0], { at: [50 * R, 0, 0] }),
  ],
  [
    'the distance of a body in ICRF',
    'position-in-kilometres',
    9.9,
    10.1,
    (x) => beside([(x * R) / 1000, (1.5 * R) / 1000, 0], { at: [x * R, 0, 0] }),
  ],
  ['a depth', 'ship-inside-body', 0.501, 0.499, (x) => beside([0, x * R, 0])],
  ['a mountain', 'landed-off-ground', 29_999, 30_001, (x) => onGround(x)],
  ['a depression', 'landed-off-ground', -29_999, -30_001, (x) => onGround(x)],
  ['half the radius, where it is inside', 'landed-off-ground', 0.499, 0.501, (x) => onGround((x - 1) * R)],
  [
    'the speed of 1/1000 of a velocity',
    'velocity-in-kilometres',
    10_005,
    10_015,
    (x) => beside([0, R + 10, 0], { velocity: x, own: [10, 0, 0] }),
  ],
  [
    'that of the velocity meant',
    'velocity-in-kilometres',
    22.1,
    21.9,
    (x) => beside([0, R + 10, 0], { velocity: 12_000, own: [x, 0, 0] }),
  ],
  [
    'the height at which it is judged',
    'velocity-in-kilometres',
    2.01,
    1.99,
    (x) => beside([0, x * R, 0], { velocity: 12_000, own: [12, 0, 0] }),
  ],
  ['a slow body', 'velocity-frame', 9_990, 10_010, (x) => beside([0, R + 10, 0], { velocity: x })],
  [
    'a share of its velocity',
    'velocity-frame',
    6_010,
    5_990,
    (x) => beside([0, R + 10, 0], { velocity: 20_000, own: [0, x, 0] }),
  ],
  [
    'the height at which that is judged',
    'velocity-frame',
    2.01,
    1.99,
    (x) => beside([0, x * R, 0], { velocity: 20_000 }),
  ],
  ['a tilt in another order', 'quaternion-order', degrees(12), degrees(11), (x) => reordered(x)],
  [
    'an attitude that stands as it is',
    'quaternion-order',
    degrees(-31),
    degrees(-29),
    (x) => reordered(0, { yaw: x }),
  ],
  ['metres from the centre', 'position-in-kilometres', 0.0101 * R, 0.0099 * R, relative],
  ['two places', 'relative-position', 99_999, 100_001, (x) => relative(R + 5, x)],
];

const OF_BODIES: readonly Bound[] = [
  ['a light body', 'body-density', 50.1, 49.9, density],
  ['a heavy one', 'body-density', 49_990, 50_010, density],
  [
    'its spin',
    'body-spin-in-degrees',
    0.05,
    0.0501,
    (x) => received(withBody({ angularVelocity: [0, x, 0] })),
  ],
  ['its attitude', 'attitude-not-unit', 1.0009, 1.0011, (x) => received(withBody({ attitude: long(x) }))],
];

const OF_CONTROLS: readonly Bound[] = [
  ['thrust', 'controls-clamped', 1, 1.00001, (x) => steered({ thrustLevel: x })],
  ['thrust below 0', 'controls-clamped', 0, -1e-6, (x) => steered({ thrustLevel: x })],
  ['a turn', 'controls-clamped', -1, -1.00001, (x) => steered({ rotationInput: [0, x, 0] })],
  ['a push', 'controls-clamped', 1, 1.00001, (x) => steered({ translationInput: [0, 0, x] })],
  ['a target', 'attitude-not-unit', 1.009, 1.011, (x) => steered({ targetAttitude: long(x) })],
  ['a shorter one', 'attitude-not-unit', 0.991, 0.989, (x) => steered({ targetAttitude: long(x) })],
];

const OF_SETTINGS: readonly Bound[] = [
  [
    'tipped angle',
    'setting-in-radians',
    3.2,
    3.19,
    (x) => set({ contactTippedAngleDeg: x, contactSettleTiltDeg: 1 }),
  ],
  ['settling tilt', 'setting-in-radians', 0.35, 0.34, (x) => set({ contactSettleTiltDeg: x })],
  [
    'crash speed',
    'setting-in-kilometres',
    0.1,
    0.09,
    (x) => set({ contactCrashSpeed: x, contactBounceSpeed: 0.05 }),
  ],
];

/** A class whose engine moves its 10 t by `acceleration` m/s². */
const accelerated = (acceleration: number) =>
  made({
    defaults: {
      shipClasses: [
        {
          ...SHIP_CLASSES[2]!,
          ...{ dryMass: 8000, fuelCapacity: 2000, mainEngineThrust: 1e4 * acceleration },
        },
      ],
    },
  });
const OF_CLASSES: readonly Bound[] = [
  ['weak thrust', 'class-units', 0.05, 0.0499, accelerated],
  ['strong thrust', 'class-units', 2000, 2000.1, accelerated],
  ['a class without an engine', 'class-units', 0, 0.001, accelerated],
];

export const BOUNDS = [...OF_SHIPS, ...OF_BODIES, ...OF_CONTROLS, ...OF_SETTINGS, ...OF_CLASSES];

const attitudes = [0, 1].flatMap((x) =>
  [0, 1].flatMap((y) => [0, 1].flatMap((z) => [0, 1].map((w) => [x, y, z, w] as const))),
);
const inOrder = (found: readonly Warning[]) => !found.some(({ code }) => code === 'quaternion-order');
const asText = (them: readonly (readonly number[])[]) => them.map((one) => one.join(''));

/** Which of all attitudes and targets of zeros and ones are taken for another order of the components. */
export const takenForAnotherOrder = () => ({
  attitude: asText(attitudes.filter((attitude) => !inOrder(received(withShip({ ...FLYING, attitude }))))),
  target: asText(attitudes.filter((targetAttitude) => !inOrder(steered({ targetAttitude })))),
});
