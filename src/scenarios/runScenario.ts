import {
  BODY_STRIDE,
  err,
  EVENT_NAMES,
  hashRows,
  isTransitionAllowed,
  NO_EVENT,
  ok,
  type Result,
  SHIP_STRIDE,
  type ShipEventName,
  spawnShip,
  SURFACE_STATE,
  SURFACE_STATES,
  type World,
  writeBodyMotion,
} from '../dynamics';
import { runTick, scheduleOf, type ScenarioWorld, type TickRun } from './runTick';
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
  const started = startScenario(loaded);
  if (!started.ok) return started;
  const { world, ship, bodies } = started.value;
  const ticks = ticksOf(loaded);
  const ships = new Float64Array((ticks + 1) * SHIP_STRIDE);
  const bodyRows = new Float64Array((ticks + 1) * BODY_STRIDE);
  ships.set(ship);
  bodyRows.set(bodies);
  const log = createLog(ship, loaded);
  for (let tick = 0; tick < ticks; tick++) {
    log.tick = tick;
    runTick(started.value, tick, log);
    ships.set(ship, (tick + 1) * SHIP_STRIDE);
    bodyRows.set(bodies, (tick + 1) * BODY_STRIDE);
  }
  const { events, illegalTransitions } = log;
  return ok({ loaded, world, ships, bodies: bodyRows, events, illegalTransitions, hash: hashRows(ships) });
}

/** The rows of a scenario at its start, in its world. */
export function startScenario({ world, body, ship }: LoadedScenario): Result<ScenarioWorld> {
  const row = new Float64Array(SHIP_STRIDE);
  const bodies = new Float64Array(BODY_STRIDE);
  const reason = writeBodyMotion(bodies, 0, body) ?? spawnShip(row, 0, ship, world);
  return reason === null ? ok({ world, ship: row, bodies }) : err(reason);
}

interface Log extends TickRun {
  readonly events: ScenarioEvent[];
  readonly illegalTransitions: string[];
  tick: number;
}

/** Notes the ship's events and illegal transitions. */
function createLog(ship: Float64Array, { timing, inputs }: LoadedScenario): Log {
  let state = 0;
  const log: Log = {
    timing,
    schedule: scheduleOf(inputs),
    events: [],
    illegalTransitions: [],
    tick: 0,
    before: () => {
      state = ship[SURFACE_STATE]!;
    },
    after(event, substep) {
      const { tick } = log;
      const illegal = illegalTransition(ship, state);
      if (illegal !== null) log.illegalTransitions.push(`tick ${tick} substep ${substep}: ${illegal}`);
      if (event !== NO_EVENT) log.events.push({ type: EVENT_NAMES[event] as ShipEventName, tick, substep });
    },
  };
  return log;
}

function illegalTransition(ship: Float64Array, before: number): string | null {
  const after = ship[SURFACE_STATE]!;
  if (isTransitionAllowed(before, after)) return null;
  const [from, to] = [SURFACE_STATES[before] ?? before, SURFACE_STATES[after] ?? after];
  return `'${from}' → '${to}'`;
}
