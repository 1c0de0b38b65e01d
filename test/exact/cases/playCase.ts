/** Plays a case on the dynamics and passes on every row, for comparison with another implementation. */
import {
  ok,
  beginTick,
  BODY_ATTITUDE,
  BODY_POSITION,
  BODY_STRIDE,
  BODY_VELOCITY,
  type Result,
  type Controls,
  endTick,
  loadBody,
  loadControls,
  loadSettings,
  loadShipClass,
  loadTiming,
  err,
  SHIP_STRIDE,
  spawnShip,
  stepWorld,
  type TerrainHeight,
  TERRAINS,
  type Timing,
  type World,
  writeBodyMotion,
  writeControls,
  TERRAIN_NORMALS,
} from '../../../src/dynamics';
import type { CaseInput, CaseTerrain, ExactCase } from './exactCase';

/** A ship's row after a substep, then the event's number. */
export const SHIP_ROW = SHIP_STRIDE + 1;
/** A body's row after a tick: position, velocity, attitude. */
export const BODY_ROW = 10;
/** Stands for the substep in a body's row. */
export const AFTER_TICK = -1;

/** `row` is reused: copy what is to be kept. */
export type TakeRow = (row: Float64Array, tick: number, substep: number) => void;

export interface Playing {
  readonly world: World;
  readonly ship: Float64Array;
  readonly bodies: Float64Array;
  readonly inputs: readonly CaseInput[];
  readonly timing: Timing;
}

/** Plays a case from its start; the number of substeps, or the reason why the law refuses the case. */
export function playCase(exact: ExactCase, take: TakeRow, terrainOf = caseTerrain): Result<number> {
  const loaded = loadCase(exact, terrainOf(exact.terrain));
  if (!loaded.ok) return loaded;
  const { world, ship, bodies, inputs, timing } = loaded.value;
  const row = new Float64Array(SHIP_ROW);
  const bodyRow = new Float64Array(BODY_ROW);
  const events = new Uint8Array(1);
  let next = 0;
  for (let tick = 0; tick < exact.ticks; tick++) {
    beginTick(ship, bodies, world);
    for (let substep = 0; substep < timing.substeps; substep++) {
      for (; isDue(inputs[next], tick, substep); next++) writeControls(ship, 0, inputs[next]!.controls);
      stepWorld(ship, bodies, events, world, timing.dt);
      row.set(ship);
      row[SHIP_STRIDE] = events[0]!;
      take(row, tick, substep);
    }
    endTick(bodies, world, timing);
    for (let at = 0; at < bodies.length; at += BODY_STRIDE) {
      writeBodyRow(bodyRow, bodies, at);
      take(bodyRow, tick, AFTER_TICK);
    }
  }
  return ok(exact.ticks * timing.substeps);
}

export function caseTerrain(terrain: CaseTerrain): TerrainHeight {
  if ('name' in terrain) return TERRAINS[terrain.name]!;
  const { base, amplitude, axis } = terrain;
  return (_body, nx, ny, nz) => {
    const along = nx * axis[0] + ny * axis[1] + nz * axis[2];
    return base + amplitude * (along * along);
  };
}

function isDue(input: CaseInput | undefined, tick: number, substep: number): boolean {
  return input !== undefined && (input.tick < tick || (input.tick === tick && input.substep <= substep));
}

/** The row of the body at `at`. */
export function writeBodyRow(row: Float64Array, bodies: Float64Array, at: number): void {
  for (let k = 0; k < 3; k++) {
    row[k] = bodies[at + BODY_POSITION + k]!;
    row[3 + k] = bodies[at + BODY_VELOCITY + k]!;
  }
  for (let k = 0; k < 4; k++) row[6 + k] = bodies[at + BODY_ATTITUDE + k]!;
}

/** A case with names resolved, checked and in rows; or the reason why the law refuses it. */
export function loadCase(exact: ExactCase, terrainHeight: TerrainHeight): Result<Playing> {
  const settings = loadSettings(exact.settings);
  if (!settings.ok) return settings;
  const shipClass = loadShipClass(exact.shipClass);
  if (!shipClass.ok) return shipClass;
  const timing = loadTiming(exact.tickRate, exact.timeScale, settings.value);
  if (!timing.ok) return timing;
  const loadedBodies = [];
  const bodies = new Float64Array(exact.bodies.length * BODY_STRIDE);
  for (const [i, body] of exact.bodies.entries()) {
    const checked = loadBody(body);
    if (!checked.ok) return checked;
    const reason = writeBodyMotion(bodies, i * BODY_STRIDE, body);
    if (reason !== null) return err(reason);
    loadedBodies.push(checked.value);
  }
  const inputs: CaseInput[] = [];
  for (const input of exact.inputs) {
    const controls: Result<Controls> = loadControls(input.controls);
    if (!controls.ok) return controls;
    inputs.push({ ...input, controls: controls.value });
  }
  const world: World = {
    settings: settings.value,
    shipClasses: [shipClass.value],
    bodies: loadedBodies,
    terrainHeight,
    terrainNormals: TERRAIN_NORMALS,
  };
  const ship = new Float64Array(SHIP_STRIDE);
  const reason = spawnShip(ship, 0, exact.ship, world);
  if (reason !== null) return err(reason);
  return ok({ world, ship, bodies, inputs, timing: timing.value });
}
