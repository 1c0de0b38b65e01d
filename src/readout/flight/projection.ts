import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  BODY_STRIDE,
  type Body,
  type BodyMotion,
  type Controls,
  CRASHED,
  FUEL,
  GROUND_CONTACT_OFFSET,
  HEIGHT,
  IMPACT_SPEED,
  loadBody,
  type LoadedSettings,
  POSITION,
  REFERENCE_BODY,
  SHIP_CLASS,
  SHIP_STRIDE,
  stepWorld,
  SURFACE_STATE,
  SURFACE_STATES,
  terrainInPlace,
  VELOCITY,
  WHEEL_MOMENTUM,
  type World,
  writeBodyMotion,
  writeControls,
  TERRAIN_NORMALS,
} from '../../dynamics';
import type { ShipView } from '../../prediction';
import { toBodyAxes } from '../axes';

/**
 * Simulates a ship ahead by the law on a scratch row, a bounded number of substeps per call. The ground is taken to
 * be the plane under its feet, since a readout has no terrain heights.
 */
export interface Projection {
  readonly ships: Float64Array;
  readonly bodies: Float64Array;
  readonly events: Uint8Array;
  world: World | null;
  running: boolean;
  /** Game s simulated ahead so far. */
  elapsed: number;
  /** Height of the terrain above the body's radius, m. */
  ground: number;
  /** Its rise, metres per unit of direction, body axes: the plane under the ship's feet. */
  readonly rise: Float64Array;
}

/** Game s per substep: the law's longest. */
const STEP_SECONDS = 0.01;

export function createProjection(): Projection {
  return {
    ships: new Float64Array(SHIP_STRIDE),
    bodies: new Float64Array(BODY_STRIDE),
    events: new Uint8Array(1),
    world: null,
    running: false,
    elapsed: NaN,
    ground: NaN,
    rise: new Float64Array(3),
  };
}

/** Starts from the ship's present predicted state, with `controls` held. Does not start from values that a world refuses. */
export function startProjection(
  out: Projection,
  ship: ShipView,
  body: Body & BodyMotion,
  settings: LoadedSettings,
  controls: Controls,
): void {
  out.world = worldFor(out, ship, body, settings);
  out.running = out.world !== null && writeBodyMotion(out.bodies, 0, body) === null;
  out.elapsed = 0;
  out.ground = ship.groundRadius - body.radius;
  writeRise(out.rise, ship, body);
  out.ships.set(ship.position, POSITION);
  out.ships.set(ship.velocity, VELOCITY);
  out.ships.set(ship.attitude, ATTITUDE);
  out.ships.set(ship.angularVelocity, ANGULAR_VELOCITY);
  out.ships.set(ship.wheelMomentum, WHEEL_MOMENTUM);
  out.ships[FUEL] = ship.fuel;
  out.ships[GROUND_CONTACT_OFFSET] = ship.groundContactOffset;
  out.ships[IMPACT_SPEED] = ship.impactSpeed;
  out.ships[SURFACE_STATE] = SURFACE_STATES.indexOf(ship.surfaceContactState);
  out.ships[REFERENCE_BODY] = 0;
  out.ships[CRASHED] = ship.crashed ? 1 : 0;
  out.ships[SHIP_CLASS] = 0;
  writeControls(out.ships, 0, controls);
}

/** The plane square to s through the ground below: n − s / (n · s) is its rise, level at the ship. */
function writeRise(rise: Float64Array, ship: ShipView, body: BodyMotion): void {
  const r = ship.position;
  const distance = Math.sqrt(r[0]! * r[0]! + r[1]! * r[1]! + r[2]! * r[2]!);
  const s = ship.groundNormal;
  const cos = (r[0]! * s[0]! + r[1]! * s[1]! + r[2]! * s[2]!) / distance;
  for (let k = 0; k < 3; k++) rise[k] = (r[k]! / distance - s[k]! / cos) * ship.groundRadius;
  for (let k = 0; k < 4; k++) attitude[k] = body.attitude[k]!;
  toBodyAxes(rise, attitude, rise);
}

const attitude = new Float64Array(4);

/** One substep; the event it reported (EVENT_…). */
export function stepProjection(out: Projection): number {
  if (out.world === null) return 0;
  stepWorld(out.ships, out.bodies, out.events, out.world, STEP_SECONDS);
  out.elapsed += STEP_SECONDS;
  return out.events[0]!;
}

/** n · up at the run's present state. */
export function projectedCosTilt({ ships }: Projection): number {
  const rx = ships[POSITION]!;
  const ry = ships[POSITION + 1]!;
  const rz = ships[POSITION + 2]!;
  const x = ships[ATTITUDE]!;
  const y = ships[ATTITUDE + 1]!;
  const z = ships[ATTITUDE + 2]!;
  const w = ships[ATTITUDE + 3]!;
  const along = 2 * (x * z + w * y) * rx + 2 * (y * z - w * x) * ry + (1 - 2 * (x * x + y * y)) * rz;
  return along / Math.sqrt(rx * rx + ry * ry + rz * rz);
}

/** The world of one ship and one body, kept while both stay the same. */
function worldFor(out: Projection, ship: ShipView, body: Body, settings: LoadedSettings): World | null {
  const kept = out.world;
  if (kept !== null && kept.settings === settings && kept.shipClasses[0] === ship.shipClass) {
    const known = kept.bodies[0]!;
    if (known.name === body.name && known.mass === body.mass && known.radius === body.radius) return kept;
  }
  const loaded = loadBody({ name: body.name, mass: body.mass, radius: body.radius });
  if (!loaded.ok) return null;
  return {
    settings,
    shipClasses: [ship.shipClass],
    bodies: [loaded.value],
    terrainHeight: terrainInPlace((point) => {
      const { rise } = out;
      point[HEIGHT] = out.ground + (rise[0]! * point[0]! + rise[1]! * point[1]! + rise[2]! * point[2]!);
    }),
    terrainNormals: TERRAIN_NORMALS,
  };
}
