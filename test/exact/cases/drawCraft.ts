/** Draws the parts of a case besides its ship's state: classes, bodies, settings, ticks, inputs. */
import {
  ATTITUDE_MODES,
  type AttitudeMode,
  BODIES,
  type Body,
  type BodyMotion,
  type Controls,
  type Settings,
  SHIP_CLASSES,
  type ShipClass,
  type Vec3,
} from '../../../src/dynamics';
import type { Random } from '../../../src/scenarios';
import { between, chance, pick, triple, unitQuaternion, unitVector, whole } from './draw';
import type { CaseInput, CaseTerrain } from './exactCase';

/** A class of the game, or one with a full tensor; an engine, thrusters or wheels may be missing. */
export function drawShipClass(rng: Random): ShipClass {
  if (chance(rng, 0.3)) return pick(rng, SHIP_CLASSES);
  const dryMass = pick(rng, [300, 2000, 9000, 70000]) * between(rng, 0.7, 2);
  const fuelCapacity = chance(rng, 0.05) ? 0 : dryMass * between(rng, 0.05, 1);
  const mass = dryMass + fuelCapacity;
  const groundContactOffset = between(rng, 0.8, 9);
  const scale = mass * groundContactOffset * groundContactOffset * between(rng, 0.2, 0.6);
  const some = (most: number): Vec3 =>
    chance(rng, 0.15) ? [0, 0, 0] : [between(rng, 0, most), between(rng, 0, most), between(rng, 0, most)];
  // Equal moments, or up to eight to one and slightly skewed.
  const isOdd = chance(rng, 0.4);
  const moment = (): number => (isOdd ? pick(rng, [0.25, 0.5, 1, 2]) : between(rng, 0.7, 1.4));
  const [xy, xz, yz] = triple(rng, (isOdd ? 0.05 : 0.2) * scale);
  return {
    name: 'drawn',
    dryMass,
    fuelCapacity,
    inertiaTensor: [
      [scale * moment(), xy, xz],
      [xy, scale * moment(), yz],
      [xz, yz, scale * moment()],
    ],
    groundContactOffset,
    legRadius: groundContactOffset * between(rng, 0.4, 1.2),
    mainEngineThrust: chance(rng, 0.1) ? 0 : mass * between(rng, 0.5, 25),
    mainEngineIsp: between(rng, 200, 5000),
    rcsThrust: some(mass * 0.8),
    rcsTorque: some(scale * 0.6),
    rcsLever: between(rng, 0.5, 8),
    rcsIsp: between(rng, 150, 400),
    reactionWheelTorque: some(scale * 0.05),
    reactionWheelCapacity: chance(rng, 0.2) ? null : some(scale * 0.1),
    attitudeNaturalFrequency: pick(rng, [5, between(rng, 0.05, 3)]),
    dryInertiaRatio: chance(rng, 0.3) ? null : between(rng, 0.1, 1),
  };
}

/** A body of the game with any attitude, or a drawn one; spin about any axis, up to one turn in two minutes. */
export function drawBody(rng: Random): Body & BodyMotion {
  const spin = chance(rng, 0.1) ? 0 : pick(rng, [1e-6, 1e-4, 5e-4, 0.05]);
  const angularVelocity = chance(rng, 0.2) ? ([0, spin, 0] as const) : triple(rng, spin);
  const attitude = chance(rng, 0.2) ? ([0, 0, 0, 1] as const) : unitQuaternion(rng);
  const ours = pick(rng, BODIES);
  if (chance(rng, 0.5)) return { ...ours, attitude, angularVelocity: triple(rng, 3e-4) };
  const radius = pick(rng, [2e3, 4e4, 1.7e6, 7e6]) * between(rng, 0.5, 2);
  // By its gravity at the surface, m/s².
  const mass = (pick(rng, [0.005, 0.3, 1.6, 9]) * between(rng, 0.5, 2) * radius * radius) / 6.6743e-11;
  return {
    name: pick(rng, ['Luna', 'Phobos', 'Nemo']),
    mass,
    radius,
    position: triple(rng, 3e11),
    velocity: triple(rng, 3e4),
    attitude,
    angularVelocity: radius > 1e5 ? triple(rng, 3e-4) : angularVelocity,
  };
}

/** The defaults, or any within their ranges. */
export function drawSettings(rng: Random): Partial<Settings> {
  const touchdownAttitude = pick(rng, ['aligned', 'kept', 'kept'] as const);
  const surfaceNormal = pick(rng, ['radial', 'terrain'] as const);
  if (chance(rng, 0.4)) return { touchdownAttitude, surfaceNormal };
  const contactCrashSpeed = between(rng, 4, 90);
  const contactTippedAngleDeg = between(rng, 20, 89.9);
  const contactFrictionStatic = between(rng, 0, 2);
  return {
    touchdownAttitude,
    surfaceNormal,
    contactLongestSubstep: pick(rng, [0.01, 0.001, 0.022, between(rng, 0.001, 0.022)]),
    contactCrashSpeed,
    contactBounceSpeed: contactCrashSpeed * between(rng, 0.05, 0.95),
    contactSettleTiltDeg: contactTippedAngleDeg * between(rng, 0.05, 0.95),
    contactSettleAngularVel: pick(rng, [0.001, 0.01, 0.1, 1]),
    contactSettleLinearVel: between(rng, 0.02, 3),
    contactTippedAngleDeg,
    contactDampingRatio: between(rng, 0.02, 1),
    contactFrictionStatic,
    contactFrictionKinetic: contactFrictionStatic * (chance(rng, 0.1) ? 0 : rng()),
  };
}

export function drawTerrain(rng: Random, n: Vec3, radius: number): CaseTerrain {
  if (chance(rng, 0.45)) return { name: 'flat' };
  if (chance(rng, 0.35)) return { name: 'hills' };
  const [x, y, z] = triple(rng, 0.5);
  const length = Math.sqrt((n[0] + x) * (n[0] + x) + (n[1] + y) * (n[1] + y) + (n[2] + z) * (n[2] + z));
  const axis: Vec3 = [(n[0] + x) / length, (n[1] + y) / length, (n[2] + z) / length];
  // Slopes up to about 60°: the rise per metre is at most the amplitude over the radius.
  const steepness = pick(rng, [0.4, 0.4, 1.7]);
  return { base: between(rng, -50, 50), amplitude: radius * between(rng, -steepness, steepness), axis };
}

/** Tick rate 0.1 … 100 Hz and time scale 0.1 … 100, of at most 10 s of game time a tick. */
export function drawTempo(rng: Random): { readonly tickRate: number; readonly timeScale: number } {
  for (;;) {
    const tickRate = chance(rng, 0.3)
      ? between(rng, 0.1, 100)
      : pick(rng, [0.1, 0.5, 1, 2, 5, 10, 20, 30, 60, 100]);
    const timeScale = chance(rng, 0.2) ? between(rng, 0.1, 100) : pick(rng, [0.1, 0.5, 1, 1, 1, 3, 10, 100]);
    if (timeScale / tickRate <= 10) return { tickRate, timeScale };
  }
}

/** The pilot's inputs, in order of time; also out of range, as a client may send them. */
export function drawInputs(rng: Random, ticks: number, substeps: number, hover: number): CaseInput[] {
  const inputs: CaseInput[] = [];
  for (let count = whole(rng, 0, 8); count > 0; count--) {
    const controls = drawControls(rng, hover);
    inputs.push({ tick: whole(rng, 0, ticks - 1), substep: whole(rng, 0, substeps - 1), controls });
  }
  return inputs.sort((a, b) => a.tick - b.tick || a.substep - b.substep);
}

/** @param hover the thrust level that balances the weight */
function drawControls(rng: Random, hover: number): Controls {
  const stick = (calm: number): Vec3 => {
    if (chance(rng, calm)) return [0, 0, 0];
    return chance(rng, 0.5)
      ? triple(rng, 1.2)
      : pick(rng, [
          [1, 0, 0],
          [0, -1, 0],
          [0, 0, 0.5],
        ] as const);
  };
  const [x, y, z, w] = unitQuaternion(rng);
  const length = chance(rng, 0.5) ? 1 : between(rng, 0.5, 2);
  return {
    thrustLevel: pick(rng, [0, 0, 0, rng(), 1.5, -1, hover * between(rng, 0.5, 1.5)]),
    translationInput: stick(0.7),
    rotationInput: stick(0.7),
    attitudeHold: chance(rng, 0.5),
    attitudeMode: pick<AttitudeMode>(rng, [...ATTITUDE_MODES, 'unknown']),
    targetAttitude: [x * length, y * length, z * length, w * length],
  };
}

/** Small moving bodies near each other: a ship between them changes its reference body. */
export function drawNeighbours(rng: Random, first: Body & BodyMotion): (Body & BodyMotion)[] {
  const neighbours: (Body & BodyMotion)[] = [];
  for (let i = whole(rng, 1, 2); i > 0; i--) {
    const [x, y, z] = unitVector(rng);
    const apart = first.radius * between(rng, 4, 8);
    const [px, py, pz] = first.position;
    const [vx, vy, vz] = triple(rng, 100);
    neighbours.push({
      ...drawBody(rng),
      name: `neighbour ${i}`,
      radius: first.radius * between(rng, 0.3, 1),
      mass: first.mass * between(rng, 0.3, 3),
      position: [px + x * apart, py + y * apart, pz + z * apart],
      velocity: [first.velocity[0] + vx, first.velocity[1] + vy, first.velocity[2] + vz],
    });
  }
  return neighbours;
}
