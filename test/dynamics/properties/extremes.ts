import fc from 'fast-check';
import {
  ATTITUDE_MODES,
  type Body,
  type BodyMotion,
  type Controls,
  type Mat3,
  type Quat,
  type Settings,
  type ShipClass,
  type ShipRecord,
  type Vec3,
} from '../../../src/dynamics';

/** Worlds up to, and slightly beyond, the limits: most are accepted, some refused. */

/** Log-uniform, often the ends themselves; sometimes ten times beyond them, or absurd. */
function reaching(least: number, most: number): fc.Arbitrary<number> {
  const [low, high] = [Math.log10(least), Math.log10(most)];
  const inside = fc.double({ min: low, max: high, noNaN: true }).map((power) => 10 ** power);
  return fc.oneof(
    { weight: 28, arbitrary: inside },
    { weight: 6, arbitrary: fc.constantFrom(least, most) },
    { weight: 1, arbitrary: fc.constantFrom(least / 10, most * 10, 1e-200, 1e200) },
  );
}

/** Like `reaching`, and 0. */
function fromNothing(most: number): fc.Arbitrary<number> {
  const inside = { weight: 5, arbitrary: reaching(most * 1e-25, most) };
  return fc.oneof(inside, { weight: 1, arbitrary: fc.constant(0) });
}

function eitherWay(most: number): fc.Arbitrary<number> {
  return fc.tuple(fromNothing(most), fc.constantFrom(1, -1)).map(([size, sign]) => size * sign);
}

function vector(part: fc.Arbitrary<number>): fc.Arbitrary<Vec3> {
  return fc.tuple(part, part, part);
}

const share = fc.double({ min: 0, max: 1, noNaN: true });
const signed = fc.double({ min: -1, max: 1, noNaN: true });

export const attitude: fc.Arbitrary<Quat> = fc
  .tuple(signed, signed, signed, signed)
  .filter((q) => Math.hypot(...q) > 1e-6)
  .map((q) => {
    const length = Math.hypot(...q);
    return [q[0] / length, q[1] / length, q[2] / length, q[3] / length];
  });

export const settings: fc.Arbitrary<Partial<Settings>> = fc
  .record({
    contactCrashSpeed: reaching(1e-9, 1e9),
    bounceShare: share,
    contactSettleTiltDeg: fc.double({ min: 1e-9, max: 45, noNaN: true }),
    contactSettleAngularVel: reaching(1e-15, 1e6),
    contactSettleLinearVel: reaching(1e-15, 1e9),
    contactTippedAngleDeg: fc.double({ min: 46, max: 89.999999, noNaN: true }),
    contactDampingRatio: reaching(1e-300, 1),
    contactFrictionStatic: fc.constantFrom(0, 1e-300, 0.8, 2),
    kineticShare: share,
    touchdownAttitude: fc.constantFrom('aligned', 'kept'),
    surfaceNormal: fc.constantFrom('radial', 'terrain'),
    contactLongestSubstep: fc.constantFrom(0.001, 0.022),
  })
  .map(({ bounceShare, kineticShare, ...given }) => ({
    ...given,
    contactBounceSpeed: given.contactCrashSpeed * bounceShare,
    contactFrictionKinetic: given.contactFrictionStatic * kineticShare,
  }));

/** Also rods and discs: moments of any size, some up to a million times smaller, maximally skewed. */
const inertiaTensor: fc.Arbitrary<Mat3> = fc
  .record({
    size: reaching(1e-9, 1e27),
    slender: fc.constantFrom(0, 1, 2, 3),
    ratio: fc.constantFrom(1, 0.3, 1e-3, 1e-6),
    skew: vector(signed),
  })
  .map(({ size, slender, ratio, skew: [d, e, f] }) => {
    const [a, b, c] = [0, 1, 2].map((axis) => (axis === slender ? size * ratio : size)) as [
      number,
      number,
      number,
    ];
    const [ab, ac, bc] = [Math.sqrt(a * b) * d, Math.sqrt(a * c) * e, Math.sqrt(b * c) * f].map(
      (element) => 0.57 * element,
    ) as [number, number, number];
    return [
      [a, ab, ac],
      [ab, b, bc],
      [ac, bc, c],
    ];
  });

export const shipClass: fc.Arbitrary<ShipClass> = fc.record({
  name: fc.constant('any'),
  dryMass: reaching(1e-3, 1e15),
  fuelCapacity: fc.oneof(fc.constant(0), reaching(1e-6, 1e15)),
  inertiaTensor,
  groundContactOffset: fromNothing(1e6),
  legRadius: reaching(1e-3, 1e6),
  mainEngineThrust: fromNothing(1e15),
  mainEngineIsp: reaching(1e-3, 1e8),
  rcsThrust: vector(fromNothing(1e15)),
  rcsTorque: vector(fromNothing(1e15)),
  rcsLever: reaching(1e-3, 1e6),
  rcsIsp: reaching(1e-3, 1e8),
  reactionWheelTorque: vector(fromNothing(1e15)),
  reactionWheelCapacity: fc.option(vector(fromNothing(1e15))),
  attitudeNaturalFrequency: reaching(1e-30, 5),
  dryInertiaRatio: fc.option(reaching(1e-6, 1)),
});

export const body: fc.Arbitrary<Body & BodyMotion> = fc.record({
  name: fc.constant('Any'),
  mass: reaching(1e-30, 1e40),
  radius: reaching(1e-3, 1e18),
  position: vector(eitherWay(1e18)),
  velocity: vector(eitherWay(1e9)),
  attitude,
  angularVelocity: vector(eitherWay(1e6)),
});

/** As likely at the ground of its body as anywhere else. */
export function shipOver({ radius }: Body, h: number): fc.Arbitrary<ShipRecord> {
  const atGround = fc
    .record({ up: vector(signed).filter((v) => Math.hypot(...v) > 1e-3), above: eitherWay(radius) })
    .map(({ up, above }) => {
      const perLength = (radius + h + above) / Math.hypot(...up);
      return [up[0] * perLength, up[1] * perLength, up[2] * perLength] as const;
    });
  return fc.record({
    shipClass: fc.constant('any'),
    referenceBody: fc.constant('Any'),
    relativePosition: fc.oneof(atGround, vector(eitherWay(1e18))),
    relativeVelocity: vector(eitherWay(1e9)),
    attitude,
    angularVelocity: vector(eitherWay(1e6)),
    fuel: fromNothing(1e15),
    wheelMomentum: vector(eitherWay(1e25)),
    groundContactOffset: fromNothing(1e6),
    surfaceContactState: fc.constantFrom('', 'contact', 'landed', 'tipped'),
    contactImpactSpeed: fromNothing(1e9),
    crashed: fc.constant(false),
  });
}

export const controls: fc.Arbitrary<Controls> = fc.record({
  thrustLevel: share,
  translationInput: vector(signed),
  rotationInput: fc.oneof(fc.constant([0, 0, 0] as const), vector(signed)),
  attitudeHold: fc.boolean(),
  attitudeMode: fc.constantFrom(...ATTITUDE_MODES),
  targetAttitude: attitude,
});
