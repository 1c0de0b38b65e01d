/** The law itself from a hand-built view, as reference for the readouts' runs ahead. */
import {
  BODIES,
  BODY_STRIDE,
  CRASHED,
  type Controls,
  EVENT_NAMES,
  FUEL,
  flatTerrain,
  loadBody,
  SHIP_STRIDE,
  spawnShip,
  stepWorld,
  type World,
  writeBodyMotion,
  writeControls,
  TERRAIN_NORMALS,
} from '../../src/dynamics';
import { makeView, type Pose } from './views';

export interface Run {
  /** Steps one substep of 0.01 s; the name of the event it reported, or ''. */
  readonly step: () => string;
  readonly command: (controls: Controls) => void;
  readonly seconds: () => number;
  readonly fuel: () => number;
  readonly cosTilt: () => number;
}

/** Starts the law at the pose, with its body only and level ground. */
export function runLaw(pose: Pose): Run {
  const { own, settings, bodies } = makeView(pose);
  const motion = bodies[own.body]!;
  const loaded = loadBody(BODIES[own.body]!);
  if (!loaded.ok) throw new Error(loaded.reason);
  const world: World = {
    settings,
    shipClasses: [own.shipClass],
    bodies: [loaded.value],
    terrainHeight: flatTerrain,
    terrainNormals: TERRAIN_NORMALS,
  };
  const ships = new Float64Array(SHIP_STRIDE);
  const rows = new Float64Array(BODY_STRIDE);
  const events = new Uint8Array(1);
  const record = {
    shipClass: own.shipClass.name,
    referenceBody: motion.name,
    relativePosition: [...own.position] as [number, number, number],
    relativeVelocity: [...own.velocity] as [number, number, number],
    attitude: [...own.attitude] as [number, number, number, number],
    angularVelocity: [...own.angularVelocity] as [number, number, number],
    fuel: own.fuel,
    surfaceContactState: own.surfaceContactState,
    contactImpactSpeed: own.impactSpeed,
    crashed: false,
  };
  const reason = writeBodyMotion(rows, 0, motion) ?? spawnShip(ships, 0, record, world);
  if (reason !== null) throw new Error(reason);
  let steps = 0;
  return {
    step: () => {
      stepWorld(ships, rows, events, world, 0.01);
      steps++;
      if (ships[CRASHED] === 1) throw new Error('crashed');
      return EVENT_NAMES[events[0]!]!;
    },
    command: (controls) => writeControls(ships, 0, controls),
    seconds: () => steps * 0.01,
    fuel: () => ships[FUEL]!,
    cosTilt: () => {
      const [rx, ry, rz, , , , x, y, z, w] = ships as unknown as number[];
      const up = [2 * (x! * z! + w! * y!), 2 * (y! * z! - w! * x!), 1 - 2 * (x! * x! + y! * y!)];
      return (up[0]! * rx! + up[1]! * ry! + up[2]! * rz!) / Math.hypot(rx!, ry!, rz!);
    },
  };
}

/** s until ship.tipped. */
export function timeToTipped(pose: Pose): number {
  const run = runLaw(pose);
  while (run.seconds() < 60) if (run.step() === 'ship.tipped') return run.seconds();
  return Infinity;
}
