import fc from 'fast-check';
import {
  ATTITUDE_MODES,
  type Controls,
  type Settings,
  type ShipClass,
  type Vec3,
} from '../../../src/dynamics';
import { type MovingBody, type Setup } from '../provingGround';
import { lengthOf, unit } from '../vectors';

/** Worlds within the law's ranges, far beyond the game's. */

/** Uniform, ends included: fc.double favours numbers near 0 so much that hardly any engine could lift its ship. */
function between(min: number, max: number): fc.Arbitrary<number> {
  const most = 2 ** 30;
  return fc.integer({ min: 0, max: most }).map((part) => min + (max - min) * (part / most));
}

/** Log-uniform. */
function magnitude(min: number, max: number): fc.Arbitrary<number> {
  return between(Math.log(min), Math.log(max)).map(Math.exp);
}

function vector(most: number): fc.Arbitrary<Vec3> {
  return fc.tuple(between(-most, most), between(-most, most), between(-most, most));
}

const direction = vector(1)
  .filter((v) => lengthOf(v) > 0.01)
  .map(unit)
  .filter(([, y]) => Math.abs(y) < 0.99);

export const controls: fc.Arbitrary<Controls> = fc.record({
  thrustLevel: between(0, 1),
  translationInput: vector(1),
  rotationInput: fc.oneof(fc.constant([0, 0, 0] as const), vector(1)),
  attitudeHold: fc.boolean(),
  attitudeMode: fc.constantFrom(...ATTITUDE_MODES),
  targetAttitude: fc
    .tuple(between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1))
    .filter((q) => Math.hypot(...q) > 0.1),
});

export const settings: fc.Arbitrary<Partial<Settings>> = fc
  .record({
    crash: between(1, 200),
    bounceShare: between(0.01, 0.99),
    tipped: between(20, 89.9),
    settleShare: between(0.01, 0.99),
    contactSettleAngularVel: magnitude(1e-3, 1),
    contactSettleLinearVel: magnitude(0.05, 2),
    contactDampingRatio: between(0.05, 1),
    contactFrictionStatic: between(0, 2),
    kineticShare: between(0, 1),
    touchdownAttitude: fc.constantFrom('aligned', 'kept'),
    surfaceNormal: fc.constantFrom('radial', 'terrain'),
    contactLongestSubstep: between(0.001, 0.022),
  })
  .map(({ crash, bounceShare, tipped, settleShare, kineticShare, ...rest }) => ({
    ...rest,
    contactCrashSpeed: crash,
    contactBounceSpeed: crash * bounceShare,
    contactTippedAngleDeg: tipped,
    contactSettleTiltDeg: tipped * settleShare,
    contactFrictionKinetic: rest.contactFrictionStatic * kineticShare,
  }));

/** A ship of 10 kg to 10⁷ kg with a full tensor, positive definite like that of masses on its axes. */
export const shipClass: fc.Arbitrary<ShipClass> = fc
  .record({
    dryMass: magnitude(10, 1e7),
    fuelShare: fc.oneof(fc.constant(0), between(1e-3, 3)),
    groundContactOffset: between(0.3, 15),
    standsOnIt: fc.boolean(),
    legShare: between(0.1, 2),
    spread: fc.tuple(between(0.2, 1), between(0.2, 1), between(0.2, 1)),
    skew: fc.tuple(between(-0.1, 0.1), between(-0.1, 0.1), between(-0.1, 0.1)),
    thrustToMass: between(0, 40),
    isp: magnitude(50, 1e5),
    torqueToInertia: between(0, 5),
    attitudeNaturalFrequency: between(0.05, 5),
    dryInertiaRatio: fc.option(between(0.1, 1)),
    wheelSeconds: fc.option(between(0, 20)),
  })
  .map(({ dryMass, fuelShare, groundContactOffset: h, spread: [a, b, c], skew: [d, e, f], ...given }) => {
    const mass = dryMass * (1 + fuelShare);
    const inertia = mass * h * h * 0.2;
    const torque = inertia * given.torqueToInertia;
    return {
      name: 'any',
      dryMass,
      fuelCapacity: dryMass * fuelShare,
      inertiaTensor: [
        [inertia * a, inertia * d * a, inertia * e * a],
        [inertia * d * a, inertia * (a + b), inertia * f * a],
        [inertia * e * a, inertia * f * a, inertia * (a + c)],
      ],
      // At 0 its centre of mass is on the ground.
      groundContactOffset: given.standsOnIt ? h : 0,
      legRadius: h * given.legShare,
      mainEngineThrust: mass * given.thrustToMass,
      mainEngineIsp: given.isp,
      rcsThrust: [mass * 0.1, mass * 0.2, mass * 0.1],
      rcsTorque: [torque, torque * 0.5, torque],
      rcsLever: h,
      rcsIsp: given.isp,
      reactionWheelTorque: [torque * 0.1, 0, torque * 0.1],
      reactionWheelCapacity:
        given.wheelSeconds === null
          ? null
          : [torque * 0.1 * given.wheelSeconds, 0, torque * 0.1 * given.wheelSeconds],
      attitudeNaturalFrequency: given.attitudeNaturalFrequency,
      dryInertiaRatio: given.dryInertiaRatio,
    };
  });

/** From a rock of 1 km to a planet of two Earths' radii, turning up to once in 20 minutes. */
export const body: fc.Arbitrary<MovingBody> = fc
  .record({
    radius: magnitude(1e3, 1.3e7),
    gravity: magnitude(1e-4, 30),
    axis: direction,
    spin: between(0, 5e-3),
  })
  .map(({ radius, gravity, axis, spin }) => ({
    name: 'Any',
    mass: (gravity * radius * radius) / 6.6743e-11,
    radius,
    position: [1e11, -2e11, 3e9],
    velocity: [1e4, 2e4, -3e3],
    attitude: [0, 0, 0, 1],
    angularVelocity: [axis[0] * spin, axis[1] * spin, axis[2] * spin],
  }));

/** A ship near the ground, in any state, with any motion and controls. */
export const setup: fc.Arbitrary<Setup> = fc
  .record({
    body,
    shipClass,
    settings,
    place: direction,
    height: fc.oneof(between(-0.5, 3), between(0, 500)),
    velocity: vector(80),
    tilt: between(-180, 180),
    roll: between(0, 360),
    spin: vector(3),
    state: fc.constantFrom('', 'contact', 'landed', 'tipped'),
    impactSpeed: between(0, 60),
    fuelShare: fc.oneof(fc.constant(1), between(0, 0.001)),
    controls: fc.oneof(fc.constant({}), controls),
  })
  .map(({ fuelShare, ...given }) => ({ ...given, fuel: given.shipClass.fuelCapacity * fuelShare }));
