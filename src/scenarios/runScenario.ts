import {
  ok,
  beginTick,
  BODY_STRIDE,
  type Result,
  CRASHED,
  endTick,
  err,
  EVENT_NAMES,
  hashRows,
  isTransitionAllowed,
  loadWorld,
  NO_EVENT,
  SHIP_STRIDE,
  type ShipEventName,
  spawnShip,
  stepWorld,
  SURFACE_STATE,
  SURFACE_STATES,
  type World,
  writeBodyMotion,
  writeControls,
} from '../dynamics';
import { type Scenario, loadScenario, type LoadedScenario, ticksOf } from './scenario';

/** The trajectory of a scenario, run on the dynamics alone. */
export interface ScenarioRun {
  readonly loaded: LoadedScenario;
  readonly world: World;
  /** The ship's row at tick boundaries 0, 1, … */
  readonly ships: Float64Array;
  /** The body's row at the same boundaries. */
  readonly bodies: Float64Array;
  readonly events: readonly ScenarioEvent[];
  /** Transitions that are not in the state transitions table; empty unless the dynamics are broken. */
  readonly illegalTransitions: readonly string[];
  /** Hash of all ship rows, bit by bit. */
  readonly hash: number;
}

/** An event in substep `substep` of the interval that begins at tick `tick`. */
export interface ScenarioEvent {
  readonly type: ShipEventName;
  readonly tick: number;
  readonly substep: number;
}

/** Runs a scenario from its start to the end of its duration; or returns a reason that names the invalid field. */
export function runScenario(scenario: Scenario): Result<ScenarioRun> {
  const checked = loadScenario(scenario);
  if (!checked.ok) return checked;
  const loaded = checked.value;
  const prepared = createScenarioWorld(loaded);
  if (!prepared.ok) return prepared;
  const { world, ship, bodies } = prepared.value;
  const ticks = ticksOf(loaded);
  const ships = new Float64Array((ticks + 1) * SHIP_STRIDE);
  const bodyRows = new Float64Array((ticks + 1) * BODY_STRIDE);
  ships.set(ship);
  bodyRows.set(bodies);
  const run: Run = { loaded, world, ship, bodies, events: [], illegalTransitions: [], nextInput: 0 };
  for (let tick = 0; tick < ticks; tick++) {
    runTick(run, tick);
    ships.set(ship, (tick + 1) * SHIP_STRIDE);
    bodyRows.set(bodies, (tick + 1) * BODY_STRIDE);
  }
  const { events, illegalTransitions } = run;
  return ok({ loaded, world, ships, bodies: bodyRows, events, illegalTransitions, hash: hashRows(ships) });
}

/** The world of a scenario at its start: one ship, one body. */
export function createScenarioWorld({
  scenario,
  body,
  shipClass,
  terrainHeight,
  ship,
}: LoadedScenario): Result<ScenarioWorld> {
  const loaded = loadWorld({
    settings: scenario.settings,
    shipClasses: [shipClass],
    bodies: [body],
    terrainHeight,
  });
  if (!loaded.ok) return loaded;
  const world = loaded.value;
  const row = new Float64Array(SHIP_STRIDE);
  const bodies = new Float64Array(BODY_STRIDE);
  const reason = writeBodyMotion(bodies, 0, body) ?? spawnShip(row, 0, ship, world);
  return reason === null ? ok({ world, ship: row, bodies }) : err(reason);
}

export interface ScenarioWorld {
  readonly world: World;
  readonly ship: Float64Array;
  readonly bodies: Float64Array;
}

interface Run extends ScenarioWorld {
  readonly loaded: LoadedScenario;
  readonly events: ScenarioEvent[];
  readonly illegalTransitions: string[];
  nextInput: number;
}

const reported = new Uint8Array(1);

function runTick(run: Run, tick: number): void {
  const { loaded, world, ship, bodies } = run;
  const { substeps, dt } = loaded.timing;
  beginTick(ship, bodies, world);
  for (let s = 0; s < substeps; s++) {
    applyInputs(run, tick, s);
    const before = ship[SURFACE_STATE]!;
    stepWorld(ship, bodies, reported, world, dt);
    checkTransition(run, before, `tick ${tick} substep ${s}`);
    if (reported[0] === NO_EVENT) continue;
    run.events.push({ type: EVENT_NAMES[reported[0]!] as ShipEventName, tick, substep: s });
  }
  endTick(bodies, world, loaded.timing);
}

function applyInputs(run: Run, tick: number, substep: number): void {
  const { inputs } = run.loaded;
  while (run.nextInput < inputs.length) {
    const next = inputs[run.nextInput]!;
    if (next.tick > tick || (next.tick === tick && next.substep > substep)) return;
    writeControls(run.ship, 0, next.controls);
    run.nextInput++;
  }
}

function checkTransition(run: Run, before: number, when: string): void {
  const after = run.ship[SURFACE_STATE]!;
  if (run.ship[CRASHED] === 1 || isTransitionAllowed(before, after)) return;
  const [from, to] = [SURFACE_STATES[before] ?? before, SURFACE_STATES[after] ?? after];
  run.illegalTransitions.push(`${when}: '${from}' → '${to}'`);
}
