import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  BODIES,
  type Body,
  BODY_ANGULAR_VELOCITY,
  BODY_ATTITUDE,
  BODY_STRIDE,
  type BodyMotion,
  type Result,
  type Controls,
  flatTerrain,
  loadBody,
  loadControls,
  loadSettings,
  loadShipClass,
  NEUTRAL_CONTROLS,
  POSITION,
  type Quat,
  type Settings,
  SHIP_CLASSES,
  SHIP_STRIDE,
  type ShipClass,
  spawnShip,
  stepWorld,
  SURFACE_STATE,
  type SurfaceState,
  type TerrainHeight,
  type Vec3,
  VELOCITY,
  type World,
  writeBodyMotion,
  writeControls,
  TERRAIN_NORMALS,
} from '../../src/dynamics';
import { cross, dot, lengthOf, plus, product, rotate, times, turnAbout, unit } from './vectors';

export type MovingBody = Body & BodyMotion;

/** One ship over one body, described from the ground. By default at rest, upright, full, feet on the ground. */
export interface Setup {
  readonly body?: MovingBody;
  readonly shipClass?: ShipClass;
  readonly settings?: Partial<Settings>;
  readonly terrain?: TerrainHeight;
  /** Local up in the body's axes; not its pole Y, where east is undefined. */
  readonly place?: Vec3;
  /** Height of an upright ship's feet above the body's radius, m. */
  readonly height?: number;
  /** Relative to the ground: [east, north, up], m/s. */
  readonly velocity?: Vec3;
  /** Degrees by which the top leans east. */
  readonly tilt?: number;
  /** Degrees by which it is first turned about its own axis. */
  readonly roll?: number;
  /** Relative to the ground: about [east, north, up], rad/s. */
  readonly spin?: Vec3;
  readonly fuel?: number;
  readonly state?: SurfaceState;
  readonly impactSpeed?: number;
  readonly controls?: Partial<Controls>;
}

export interface Trial {
  readonly ships: Float64Array;
  readonly bodies: Float64Array;
  readonly events: Uint8Array;
  readonly world: World;
}

/** The 16 t class of "What this gives": h 4 m, leg radius 3 m. */
export const LANDER: ShipClass = {
  name: 'lander',
  dryMass: 8000,
  fuelCapacity: 8000,
  inertiaTensor: [
    [108160, 0, 0],
    [0, 108160, 0],
    [0, 0, 77440],
  ],
  groundContactOffset: 4,
  legRadius: 3,
  mainEngineThrust: 60000,
  mainEngineIsp: 311,
  rcsThrust: [2000, 2000, 2000],
  rcsTorque: [120000, 120000, 40000],
  rcsLever: 4,
  rcsIsp: 280,
  reactionWheelTorque: [2000, 2000, 1000],
  reactionWheelCapacity: null,
  attitudeNaturalFrequency: 2,
  dryInertiaRatio: 0.5,
};

export function bodyNamed(name: string): MovingBody {
  return BODIES.find((body) => body.name === name)!;
}

export function classNamed(name: string): ShipClass {
  return name === LANDER.name ? LANDER : SHIP_CLASSES.find((shipClass) => shipClass.name === name)!;
}

/** The body without its spin, so that a formula for level ground at rest applies. */
export function still(name: string): MovingBody {
  return { ...bodyNamed(name), angularVelocity: [0, 0, 0] };
}

/** Surface gravity at the centre of mass of a ship standing on the body, m/s². */
export function gravityOn({ mass, radius }: Body, h = LANDER.groundContactOffset): number {
  return (6.6743e-11 * mass) / (radius + h) ** 2;
}

/** @throws if the law refuses the value */
export function must<T>(checked: Result<T>): T {
  if (!checked.ok) throw new Error(checked.reason);
  return checked.value;
}

/** A world of one ship and one body. @throws if the law refuses it */
export function createTrial(setup: Setup): Trial {
  const body = setup.body ?? bodyNamed('Luna');
  const shipClass = setup.shipClass ?? LANDER;
  const world: World = {
    settings: must(loadSettings(setup.settings ?? {})),
    shipClasses: [must(loadShipClass(shipClass))],
    bodies: [must(loadBody(body))],
    terrainHeight: setup.terrain ?? flatTerrain,
    terrainNormals: TERRAIN_NORMALS,
  };
  const ships = new Float64Array(SHIP_STRIDE);
  const bodies = new Float64Array(BODY_STRIDE);
  const reason =
    writeBodyMotion(bodies, 0, body) ?? spawnShip(ships, 0, placed(setup, body, shipClass), world);
  if (reason !== null) throw new Error(reason);
  const trial = { ships, bodies, events: new Uint8Array(1), world };
  command(trial, setup.controls ?? {});
  return trial;
}

/** Gives the ship these controls, neutral where absent. */
export function command(trial: Trial, controls: Partial<Controls>): void {
  writeControls(trial.ships, 0, must(loadControls({ ...NEUTRAL_CONTROLS, ...controls })));
}

/** One substep; the event. */
export function stepOnce({ ships, bodies, events, world }: Trial, dt = 0.01): number {
  stepWorld(ships, bodies, events, world, dt);
  return events[0]!;
}

/** Steps until `stop` returns true for an event, or for `seconds`. Returns the number of substeps. */
export function run(trial: Trial, seconds: number, stop?: (event: number) => boolean, dt = 0.01): number {
  const most = Math.round(seconds / dt);
  for (let done = 1; done <= most; done++) {
    const event = stepOnce(trial, dt);
    if (stop?.(event) === true) return done;
  }
  return most;
}

/** The ship as measured from the ground: metres, m/s, rad/s, degrees. */
export interface Seen {
  readonly state: number;
  /** Of the feet of an upright ship above the body's radius. */
  readonly height: number;
  readonly climb: number;
  readonly slide: number;
  readonly tilt: number;
  readonly spin: number;
  /** Local up, ICRF. */
  readonly up: Vec3;
}

export function see({ ships, bodies, world }: Trial): Seen {
  const position = vectorAt(ships, POSITION);
  const ground = cross(vectorAt(bodies, BODY_ANGULAR_VELOCITY), position);
  const velocity = plus(vectorAt(ships, VELOCITY), ground, -1);
  const up = unit(position);
  const climb = dot(velocity, up);
  const top = rotate(quaternionAt(ships, ATTITUDE), [0, 0, 1]);
  const spin = plus(vectorAt(ships, ANGULAR_VELOCITY), vectorAt(bodies, BODY_ANGULAR_VELOCITY), -1);
  const stands = world.bodies[0]!.radius + world.shipClasses[0]!.groundContactOffset;
  return {
    state: ships[SURFACE_STATE]!,
    height: lengthOf(position) - stands,
    climb,
    slide: lengthOf(plus(velocity, up, -climb)),
    tilt: (Math.atan2(lengthOf(cross(up, top)), dot(up, top)) * 180) / Math.PI,
    spin: lengthOf(spin),
    up,
  };
}

export function vectorAt(rows: Float64Array, at: number): Vec3 {
  return [rows[at]!, rows[at + 1]!, rows[at + 2]!];
}

export function quaternionAt(rows: Float64Array, at: number): Quat {
  return [rows[at]!, rows[at + 1]!, rows[at + 2]!, rows[at + 3]!];
}

/** The ship's position in the body's axes: constant if fixed to the ground. */
export function onTheBody({ ships, bodies }: Trial): Vec3 {
  const [x, y, z, w] = quaternionAt(bodies, BODY_ATTITUDE);
  return rotate([-x, -y, -z, w], vectorAt(ships, POSITION));
}

const NO_TURN: Vec3 = [0, 0, 0];

function placed(setup: Setup, body: MovingBody, shipClass: ShipClass) {
  const up = rotate(body.attitude, unit(setup.place ?? [0.6, 0.48, 0.64]));
  const east = unit(cross(rotate(body.attitude, [0, 1, 0]), up));
  const north = cross(up, east);
  const local = ([e, n, u]: Vec3) => plus(plus(times(east, e), north, n), up, u);
  const reach = body.radius + shipClass.groundContactOffset + (setup.height ?? 0);
  const relativePosition = times(up, reach);
  const level = cross([0, 0, 1], up);
  const overPole: Quat = up[2] > 0 ? [0, 0, 0, 1] : [1, 0, 0, 0];
  const upright: Quat =
    lengthOf(level) > 1e-9 ? turnAbout(unit(level), Math.atan2(lengthOf(level), up[2])) : overPole;
  const lean = turnAbout(north, ((setup.tilt ?? 0) * Math.PI) / 180);
  const roll = turnAbout([0, 0, 1], ((setup.roll ?? 0) * Math.PI) / 180);
  return {
    shipClass: shipClass.name,
    referenceBody: body.name,
    relativePosition,
    relativeVelocity: plus(cross(body.angularVelocity, relativePosition), local(setup.velocity ?? NO_TURN)),
    attitude: product(lean, product(upright, roll)),
    angularVelocity: plus(body.angularVelocity, local(setup.spin ?? NO_TURN)),
    fuel: setup.fuel ?? shipClass.fuelCapacity,
    surfaceContactState: setup.state ?? '',
    contactImpactSpeed: setup.impactSpeed ?? 0,
    crashed: false,
  } as const;
}
