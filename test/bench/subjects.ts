import {
  ATTITUDE,
  BODIES,
  BODY_STRIDE,
  type Result,
  CONTACT,
  FLYING,
  LANDED,
  LANDING_SITE,
  flatTerrain,
  hillsTerrain,
  loadBody,
  loadSettings,
  loadShipClass,
  POSITION,
  SHIP_CLASSES,
  SHIP_STRIDE,
  spawnShip,
  stepWorld,
  SURFACE_STATE,
  SURFACE_STATES,
  TIPPED,
  type Vec3,
  VELOCITY,
  type World,
  writeBodyMotion,
  TERRAIN_NORMALS,
} from '../../src/dynamics';

/** A world and a ship in some state, which `step` advances and `restart` resets. */
export interface Subject {
  readonly world: World;
  readonly ships: Float64Array;
  readonly bodies: Float64Array;
  readonly state: number;
  step(times: number): void;
}

/** Its axes are ICRF's, so that a position on it is a direction. */
const MOON = { ...BODIES[0]!, attitude: [0, 0, 0, 1] as const };
/** With a full inertia tensor. */
const FRIGATE = SHIP_CLASSES[0]!;
/** Substeps after which a subject is reset, so that it stays in its state: half a second. */
const RUN = 50;
const DT = 0.01;

const world: World = {
  settings: loaded(loadSettings({})),
  shipClasses: [loaded(loadShipClass(FRIGATE))],
  bodies: [loaded(loadBody(MOON))],
  terrainHeight: flatTerrain,
  terrainNormals: TERRAIN_NORMALS,
};

/** Sliding over level ground at 30 m/s, in contact at its static depth. */
export function sliding(count = 1): Subject {
  return subject(CONTACT, { speed: 30, above: -0.0162, tilt: 0 }, { count });
}

/** Sliding over the hills at 3 m/s, with the surface normal radial or the terrain's. */
export function slidingOverHills(surfaceNormal: 'radial' | 'terrain'): Subject {
  const hills = {
    ...world,
    settings: loaded(loadSettings({ surfaceNormal })),
    terrainHeight: hillsTerrain,
  };
  return subject(CONTACT, { speed: 3, above: -0.0162, tilt: 0 }, { world: hills, site: HILLSIDE });
}

/** Coasting 500 m above the ground. */
export function flying(): Subject {
  return subject(FLYING, { speed: 30, above: 500, tilt: 0.2 });
}

/** On its side, sliding. */
export function tipped(): Subject {
  return subject(TIPPED, { speed: 5, above: -0.0162, tilt: 0.71 });
}

/** At rest. */
export function landed(): Subject {
  return subject(LANDED, { speed: 0, above: -0.0162, tilt: 0 });
}

interface Start {
  /** Along the ground, m/s. */
  readonly speed: number;
  /** Feet above the ground, m. */
  readonly above: number;
  /** Sine of half the tilt. */
  readonly tilt: number;
}

/** A hillside with 22° of slope. */
const HILLSIDE: Vec3 = [0.601265926, 0.474432245, 0.64295671];

function subject(
  state: number,
  start: Start,
  { count = 1, world: of = world, site = LANDING_SITE }: { count?: number; world?: World; site?: Vec3 } = {},
): Subject {
  const ships = new Float64Array(count * SHIP_STRIDE);
  const bodies = new Float64Array(BODY_STRIDE);
  const events = new Uint8Array(count);
  writeBodyMotion(bodies, 0, MOON);
  for (let i = 0; i < count; i++) place(ships, i * SHIP_STRIDE, { ...start, state, site, world: of });
  const firstShips = ships.slice();
  const firstBodies = bodies.slice();
  let left = RUN;
  return {
    world: of,
    ships,
    bodies,
    state,
    step(times) {
      for (let i = 0; i < times; i++) {
        if (left === 0) {
          restore(ships, firstShips);
          restore(bodies, firstBodies);
          left = RUN;
        }
        left--;
        stepWorld(ships, bodies, events, of, DT);
      }
      if (ships[SURFACE_STATE] !== state)
        throw new Error(`left state ${SURFACE_STATES[state]!} while it was timed`);
    },
  };
}

/** Element by element: TypedArray.set allocates a few bytes per call. */
function restore(rows: Float64Array, from: Float64Array): void {
  for (let i = 0; i < rows.length; i++) rows[i] = from[i]!;
}

interface Placing extends Start {
  readonly state: number;
  readonly site: Vec3;
  readonly world: World;
}

function place(ships: Float64Array, at: number, { state, site, world, ...start }: Placing): void {
  const [x, y, z] = site;
  const perLength = 1 / Math.sqrt(x * x + y * y + z * z);
  const [nx, ny, nz] = [x * perLength, y * perLength, z * perLength];
  const ground = MOON.radius + world.terrainHeight(MOON.name, nx, ny, nz);
  const distance = ground + FRIGATE.groundContactOffset + start.above;
  const reason = spawnShip(
    ships,
    at,
    {
      shipClass: FRIGATE.name,
      referenceBody: MOON.name,
      relativePosition: [nx * distance, ny * distance, nz * distance],
      relativeVelocity: [0, 0, 0],
      attitude: [0, 0, 0, 1],
      angularVelocity: [...MOON.angularVelocity],
      fuel: FRIGATE.fuelCapacity / 2,
      surfaceContactState: SURFACE_STATES[state]!,
      contactImpactSpeed: 5,
      crashed: false,
    },
    world,
  );
  if (reason !== null) throw new Error(reason);
  // Along (n_z, 0, −n_x) / √(n_x² + n_z²), level; upright is the shortest turn of z to n, then the tilt about body x.
  const level = Math.sqrt(nx * nx + nz * nz);
  const [ox, oy, oz] = MOON.angularVelocity;
  const r = ships.subarray(at + POSITION, at + POSITION + 3) as unknown as [number, number, number];
  ships[at + VELOCITY] = oy * r[2] - oz * r[1] + (start.speed * nz) / level;
  ships[at + VELOCITY + 1] = oz * r[0] - ox * r[2];
  ships[at + VELOCITY + 2] = ox * r[1] - oy * r[0] - (start.speed * nx) / level;
  const length = Math.sqrt(ny * ny + nx * nx + (1 + nz) * (1 + nz));
  const [ux, uy, uw] = [-ny / length, nx / length, (1 + nz) / length];
  const s = start.tilt;
  const c = Math.sqrt(1 - s * s);
  ships.set([ux * c + uw * s, uy * c, -uy * s, uw * c - ux * s], at + ATTITUDE);
}

function loaded<T>(checked: Result<T>): T {
  if (!checked.ok) throw new Error(checked.reason);
  return checked.value;
}
