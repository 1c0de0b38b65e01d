/** The law of motion and contact, the same on server and client (DYNAMICS.md). */

/** Columns of a ship's and a body's row, states, modes, events. */
export * from './state/layout';
/** Validation results and tuples. */
export {
  describe,
  ok,
  requireKnown,
  type Result,
  type Mat3,
  type Quat,
  err,
  readQuat,
  readVec3,
  type Vec3,
} from './result';
/** The server's contact settings. */
export { DEFAULT_SETTINGS, loadSettings, type LoadedSettings, type Settings } from './constants/settings';
/** Ship classes: plain data in, constants out. */
export { loadShipClass, type LoadedShipClass, type ShipClass, STANDARD_GRAVITY } from './constants/shipClass';
/** Columns of a class's `constants`. */
export { LEG_RADIUS, MAIN_ENGINE_THRUST, RCS_THRUST } from './constants/constantRows';
/** Bodies: plain data in, constants out, motion in rows. */
export {
  type Body,
  type BodyMotion,
  GRAVITATIONAL_CONSTANT,
  loadBody,
  type LoadedBody,
  readBodyMotion,
  turnBodies,
  settleBodies,
  moveBodies,
  setBodyMotion,
  writeBodyMotion,
} from './constants/body';
/** The game's ship classes and bodies. */
export { BODIES, SHIP_CLASSES } from './constants/catalogue';
/** A pilot's controls. */
export {
  attitudeModeOf,
  type Controls,
  loadControls,
  modeName,
  modeNumber,
  NEUTRAL_CONTROLS,
  readControls,
  writeControls,
} from './state/controls';
/** Between a row and a plain record. */
export { landedBodyName, readShip, type ShipInit, type ShipRecord, spawnShip, writeShip } from './state/ship';
/** k / m of the contact spring, s⁻². */
export { CONTACT_STIFFNESS } from './contact/forces';
/** The step of one ship. */
export { substep } from './substep';
/** The step of a world, and the division of ticks into substeps. */
export {
  beginTick,
  endTick,
  loadTiming,
  MAX_RATE,
  MIN_RATE,
  stepWorld,
  type Timing,
  timingOfTick,
} from './tick';
export type { GroundUnderShip, HeightInPlace, TerrainHeight, TerrainNormals, World } from './constants/world';
/** A world: plain data in, constants out. */
export {
  deriveWorld,
  faultOfConstants,
  loadWorld,
  type WorldConstants,
  type WorldData,
} from './constants/loadWorld';
/** The surface normal under a ship's feet. */
export { TERRAIN_NORMALS } from './contact/terrainNormals';
/** The choice of the reference body at a tick's start. */
export { chooseReferenceBody } from './referenceBody';
/** Sine and cosine with the same bits everywhere, for configuration and scenarios. */
export { cosineOfDegrees, sineOfDegrees } from './arithmetic/angles';
/** The table of state transitions. */
export { isTransitionAllowed } from './state/stateTransitions';
/** A hash of a trajectory's bits. */
export { hashRows } from './state/hash';
/** Terrain look-ups in scratch doubles. */
export { HEIGHT, readHeight, terrainInPlace } from './terrain/inPlace';
/** Terrain made of + − × ÷ √. */
export { flatTerrain, hillsTerrain, LANDING_SITE, TERRAINS } from './terrain/terrain';
/** Terrain from a body's heights on a grid, in the game's format. */
export { type Heightmap, heightmapTerrain, readHeightmapSamples } from './terrain/heightmap';
