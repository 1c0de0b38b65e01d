import { HEIGHT, readHeight, type TerrainHeight, terrainInPlace, type World } from '../../dynamics';

/**
 * Differences between the server's ground and ours, from one ship's server states (PREDICTION, Learned ground): places with an offset
 * above our terrain, m, and a slope. Without any, the world is used unchanged.
 */
export interface LearnedGround {
  /** Newest last; where places overlap, the newer one takes precedence. */
  readonly places: GroundPlace[];
  /** The simulation's world with the places on its ground; null without any. */
  world: World | null;
  /** The world it was made from. */
  base: World | null;
  /** Functions that read the places; null until `beginReading`, so that a page without `learnedGround` does not load them. */
  reading: GroundReading | null;
}

export interface GroundReading {
  readonly worldOf: typeof worldOf;
  readonly offsetAt: typeof offsetAt;
  readonly confidenceAt: typeof confidenceAt;
}

export interface GroundPlace {
  readonly bodyName: string;
  /** m */
  readonly bodyRadius: number;
  /** Unit direction in the body's axes. */
  readonly direction: Float64Array;
  /** The server's ground above ours there, m. */
  offset: number;
  /** Gradient of the offset along the ground, m/m, in the body's axes, perpendicular to `direction`. */
  readonly slope: Float64Array;
  /** Server states that confirm it. */
  states: number;
  /** Client wall s of the newest of them. */
  seenAt: number;
  /** 0 … 1, fading with age. */
  weight: number;
}

/** Distances from a place, m: full effect up to WHOLE, none beyond GONE. */
const WHOLE = 150;
const GONE = 1000;
/** Client wall s since a place was confirmed: full effect up to FRESH, none beyond FORGOTTEN. */
const FRESH = 300;
const FORGOTTEN = 1200;
/** Places kept per ship. */
const MAX_PLACES = 8;

export function createLearnedGround(): LearnedGround {
  return { places: [], world: null, base: null, reading: null };
}

/** The world in which a ship is simulated: the configured one with the learned ground. */
function worldOf(ground: LearnedGround, world: World): World {
  if (ground.places.length === 0) return world;
  if (ground.world === null || ground.base !== world) {
    ground.base = world;
    ground.world = { ...world, terrainHeight: raised(ground.places, world.terrainHeight) };
  }
  return ground.world;
}

function raised(places: readonly GroundPlace[], terrainHeight: TerrainHeight): TerrainHeight {
  return terrainInPlace((point, bodyName) => {
    const offset = offsetAt(places, bodyName, point[0]!, point[1]!, point[2]!);
    readHeight(point, terrainHeight, bodyName);
    point[HEIGHT] = point[HEIGHT]! + offset;
  });
}

/** The server's ground above ours, m, along a unit direction in the body's axes. Continuous: a step would be a wall. */
export function offsetAt(
  places: readonly GroundPlace[],
  bodyName: string,
  nx: number,
  ny: number,
  nz: number,
): number {
  let sum = 0;
  let left = 1;
  for (let i = places.length - 1; i >= 0 && left > 0; i--) {
    const place = places[i]!;
    if (place.bodyName !== bodyName) continue;
    const { direction, slope, bodyRadius } = place;
    const x = (nx - direction[0]!) * bodyRadius;
    const y = (ny - direction[1]!) * bodyRadius;
    const z = (nz - direction[2]!) * bodyRadius;
    const share = left * place.weight * nearness(Math.sqrt(x * x + y * y + z * z));
    sum += share * (place.offset + slope[0]! * x + slope[1]! * y + slope[2]! * z);
    left -= share;
  }
  return sum;
}

/** 1 at a place, 0 far from it, smooth in between. */
function nearness(distance: number): number {
  if (distance <= WHOLE) return 1;
  if (distance >= GONE) return 0;
  const t = (GONE - distance) / (GONE - WHOLE);
  return t * t * (3 - 2 * t);
}

/** The newest place with full effect at a direction, or null. */
export function placeAt(
  { places }: LearnedGround,
  bodyName: string,
  direction: Float64Array,
): GroundPlace | null {
  for (let i = places.length - 1; i >= 0; i--) {
    const place = places[i]!;
    if (place.bodyName === bodyName && metresFrom(place, direction) < WHOLE) return place;
  }
  return null;
}

/** Distance along the ground from a place, m, accurate for a few hundred. */
export function metresFrom({ direction: from, bodyRadius }: GroundPlace, direction: Float64Array): number {
  const x = direction[0]! - from[0]!;
  const y = direction[1]! - from[1]!;
  const z = direction[2]! - from[2]!;
  return Math.sqrt(x * x + y * y + z * z) * bodyRadius;
}

/** Keeps a place and removes a nearby one that it replaces. */
export function keepPlace(ground: LearnedGround, place: GroundPlace): void {
  const { places } = ground;
  const old = placeAt(ground, place.bodyName, place.direction);
  if (old !== null) places.splice(places.indexOf(old), 1);
  places.push(place);
  if (places.length > MAX_PLACES) places.shift();
}

/** Ages places and removes expired ones. */
export function agePlaces({ places }: LearnedGround, now: number): void {
  for (let i = places.length - 1; i >= 0; i--) {
    const place = places[i]!;
    const left = (FORGOTTEN - (now - place.seenAt)) / (FORGOTTEN - FRESH);
    place.weight = left >= 1 ? 1 : left;
    if (left <= 0) places.splice(i, 1);
  }
}

/** 0 … 1: confidence in the ground in a direction, ½ after one state. */
function confidenceAt(ground: LearnedGround, bodyName: string, direction: Float64Array): number {
  const place = placeAt(ground, bodyName, direction);
  return place === null ? 0 : (place.weight * place.states) / (place.states + 1);
}

const READING: GroundReading = Object.freeze({ worldOf, offsetAt, confidenceAt });

/** From now on the ship's places are part of its ground. */
export function beginReading(ground: LearnedGround): void {
  ground.reading = READING;
}
