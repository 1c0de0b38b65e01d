/** Runs a landing in the C reference of the law and reads its result. */
import { spawnSync } from 'node:child_process';
import {
  BODY_ANGULAR_VELOCITY,
  BODY_ATTITUDE,
  BODY_POSITION,
  BODY_STRIDE,
  BODY_VELOCITY,
  type Controls,
  type LoadedSettings,
  type LoadedShipClass,
  modeNumber,
  SHIP_STRIDE,
  type Timing,
  type World,
} from '../../../src/dynamics';
import type { CaseInput, CaseTerrain } from '../../exact/cases/exactCase';

/** One ship, the first of `ships`. */
export interface Landing {
  readonly ticks: number;
  readonly timing: Timing;
  readonly world: World;
  /** Flat or a bowl: the C reference has no hills. */
  readonly terrain: CaseTerrain;
  readonly ships: Float64Array;
  readonly bodies: Float64Array;
  readonly inputs: readonly CaseInput[];
}

/** Runs the reference (see main.c) with landings on its standard input; returns the lines it prints. @throws with its error output. */
export function runReference(
  program: string,
  words: readonly string[],
  landings: readonly Landing[],
): string[] {
  const doubles = Float64Array.from(landings.flatMap(doublesOf));
  const input = Buffer.from(doubles.buffer);
  const { status, stdout, stderr, error } = spawnSync(program, words, { input, maxBuffer: 1 << 26 });
  if (status !== 0) throw new Error(`${program} ${words.join(' ')}: ${error?.message ?? stderr.toString()}`);
  return stdout.toString().trimEnd().split('\n');
}

/** In the order in which main.c reads them. */
function doublesOf({ ticks, timing, world, terrain, ships, bodies, inputs }: Landing): number[] {
  const count = world.bodies.length;
  const bowl = 'name' in terrain ? { base: 0, amplitude: 0, axis: [0, 0, 1] as const } : terrain;
  return [
    ...[ticks, timing.substeps, timing.dt, timing.tickSeconds, count, inputs.length],
    ...[bowl.base, bowl.amplitude, ...bowl.axis],
    ...settingsDoubles(world.settings),
    ...classDoubles(world.shipClasses[0]!),
    ...world.bodies.flatMap(({ radius, gravityParameter }, i) => [
      radius,
      gravityParameter,
      ...motionDoubles(bodies.subarray(i * BODY_STRIDE, (i + 1) * BODY_STRIDE)),
    ]),
    ...ships.subarray(0, SHIP_STRIDE),
    ...inputs.flatMap(({ tick, substep, controls }) => [tick, substep, ...controlDoubles(controls)]),
  ];
}

function settingsDoubles(s: LoadedSettings): number[] {
  return [
    ...[s.contactCrashSpeed, s.contactBounceSpeed, s.contactSettleAngularVel, s.contactSettleLinearVel],
    ...[s.contactDampingRatio, s.contactFrictionStatic, s.contactFrictionKinetic],
    ...[s.cosSettleTilt, s.cosTippedAngle, s.touchdownAttitude === 'aligned' ? 1 : 0],
    s.surfaceNormal === 'terrain' ? 1 : 0,
  ];
}

function classDoubles(c: LoadedShipClass): number[] {
  return [
    ...[c.dryMass, c.legRadius, c.inertiaAtDry, c.inertiaPerFuel, c.supportInertia, c.scrubInertia],
    ...[c.attitudeStiffness, c.attitudeDamping],
    ...[c.mainEngineThrust, c.mainEngineFlow, c.rcsFlow, c.forcePerTorque],
    ...[...c.rcsThrust, ...c.rcsTorque, ...c.reactionWheelTorque, ...c.wheelCapacity],
    ...[...c.inertia, ...c.inverseInertia],
  ];
}

function motionDoubles(row: Float64Array): number[] {
  return [
    ...row.subarray(BODY_POSITION, BODY_POSITION + 3),
    ...row.subarray(BODY_VELOCITY, BODY_VELOCITY + 3),
    ...row.subarray(BODY_ANGULAR_VELOCITY, BODY_ANGULAR_VELOCITY + 3),
    ...row.subarray(BODY_ATTITUDE, BODY_ATTITUDE + 4),
  ];
}

function controlDoubles(controls: Controls): number[] {
  return [
    ...[controls.thrustLevel, ...controls.translationInput, ...controls.rotationInput],
    ...[controls.attitudeHold ? 1 : 0, modeNumber(controls.attitudeMode)],
    ...controls.targetAttitude,
  ];
}
