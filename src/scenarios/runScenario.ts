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
import { type Scenario, stage, type StagedScenario, ticksOf } from './scenario';

/** What a scenario comes to, run on the dynamics alone. */
export interface Rehearsed {
  readonly staged: StagedScenario;
  readonly world: World;
  /** Ship rows at tick boundaries 0, 1, …, one after another. */
  readonly ships: Float64Array;
  /** Body rows at the same boundaries. */
  readonly bodies: Float64Array;
  readonly events: readonly RehearsedEvent[];
  /** Moves between surface states that the law does not know; empty unless the law is broken. */
  readonly illegalMoves: readonly string[];
  /** Of all ship rows: one number for the trajectory's bits. */
  readonly hash: number;
}

/** What happened in substep `substep` of the interval that begins at tick `tick`. */
export interface RehearsedEvent {
  readonly type: ShipEventName;
  readonly tick: number;
  readonly substep: number;
}

/** Runs a scenario from its start to the end of its duration; a reason that names the field when it cannot be staged. */
export function rehearse(scenario: Scenario): Result<Rehearsed> {
  const checked = stage(scenario);
  if (!checked.ok) return checked;
  const staged = checked.value;
  const prepared = prepare(staged);
  if (!prepared.ok) return prepared;
  const { world, ship, bodies } = prepared.value;
  const ticks = ticksOf(staged);
  const ships = new Float64Array((ticks + 1) * SHIP_STRIDE);
  const bodyRows = new Float64Array((ticks + 1) * BODY_STRIDE);
  ships.set(ship);
  bodyRows.set(bodies);
  const run: Run = { staged, world, ship, bodies, events: [], illegalMoves: [], nextInput: 0 };
  for (let tick = 0; tick < ticks; tick++) {
    runTick(run, tick);
    ships.set(ship, (tick + 1) * SHIP_STRIDE);
    bodyRows.set(bodies, (tick + 1) * BODY_STRIDE);
  }
  const { events, illegalMoves } = run;
  return ok({ staged, world, ships, bodies: bodyRows, events, illegalMoves, hash: hashRows(ships) });
}

/** The world of a scenario at its start: one ship, one body. */
export function prepare({
  scenario,
  body,
  shipClass,
  terrainHeight,
  ship,
}: StagedScenario): Result<Prepared> {
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

export interface Prepared {
  readonly world: World;
  readonly ship: Float64Array;
  readonly bodies: Float64Array;
}

interface Run extends Prepared {
  readonly staged: StagedScenario;
  readonly events: RehearsedEvent[];
  readonly illegalMoves: string[];
  nextInput: number;
}

const reported = new Uint8Array(1);

function runTick(run: Run, tick: number): void {
  const { staged, world, ship, bodies } = run;
  const { substeps, dt } = staged.timing;
  beginTick(ship, bodies, world);
  for (let s = 0; s < substeps; s++) {
    applyInputs(run, tick, s);
    const before = ship[SURFACE_STATE]!;
    stepWorld(ship, bodies, reported, world, dt);
    checkMove(run, before, `tick ${tick} substep ${s}`);
    if (reported[0] === NO_EVENT) continue;
    run.events.push({ type: EVENT_NAMES[reported[0]!] as ShipEventName, tick, substep: s });
  }
  endTick(bodies, world, staged.timing);
}

function applyInputs(run: Run, tick: number, substep: number): void {
  const { inputs } = run.staged;
  while (run.nextInput < inputs.length) {
    const next = inputs[run.nextInput]!;
    if (next.tick > tick || (next.tick === tick && next.substep > substep)) return;
    writeControls(run.ship, 0, next.controls);
    run.nextInput++;
  }
}

function checkMove(run: Run, before: number, when: string): void {
  const after = run.ship[SURFACE_STATE]!;
  if (run.ship[CRASHED] === 1 || isTransitionAllowed(before, after)) return;
  const [from, to] = [SURFACE_STATES[before] ?? before, SURFACE_STATES[after] ?? after];
  run.illegalMoves.push(`${when}: '${from}' → '${to}'`);
}
