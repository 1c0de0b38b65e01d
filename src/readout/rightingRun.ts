import { type Controls, CONTACT, CRASHED, FUEL, LANDED, NEUTRAL_CONTROLS, SURFACE_STATE } from '../dynamics';
import type { ShipView, WorldView } from '../prediction';
import {
  createProjection,
  type Projection,
  projectedCosTilt,
  startProjection,
  stepProjection,
} from './projection';
import { pointOfNoReturn } from './surface';

/** The law run ahead of a tipped ship with the righting keys held: whether it stands, after how long, on how much fuel. */
export interface RightingRun {
  readonly projection: Projection;
  outcome: 'working' | 'stands' | 'fails';
  /** Game s; NaN unless it stands. */
  seconds: number;
  /** kg; NaN unless it stands. */
  fuelNeeded: number;
  /** What the run was started for; a new one starts only where these differ. */
  startInputX: number;
  startInputY: number;
  /** kg */
  startFuel: number;
  /** rad */
  startTilt: number;
}

/** Game s; a ship that needs longer than this to stand up is not being righted. */
const HORIZON = 60;
/** Some 40 µs a call. */
const SUBSTEPS_A_CALL = 200;
/** Differences that would hardly show in the answer, kg and rad. */
const SAME_FUEL = 10;
const SAME_TILT = 0.035;

export function createRightingRun(): RightingRun {
  return {
    projection: createProjection(),
    outcome: 'working',
    seconds: NaN,
    fuelNeeded: NaN,
    startInputX: NaN,
    startInputY: NaN,
    startFuel: NaN,
    startTilt: NaN,
  };
}

export function forgetRightingRun(run: RightingRun): void {
  run.projection.running = false;
  run.outcome = 'working';
  run.seconds = NaN;
  run.fuelNeeded = NaN;
  run.startInputX = NaN;
}

/** Goes on with the run of these inputs, or starts it. `tilt` in rad. The last answer stays until there is a new one. */
export function runRighting(
  run: RightingRun,
  inputs: Float64Array,
  tilt: number,
  view: WorldView,
  ship: ShipView,
): void {
  if (!run.projection.running && differs(run, inputs, tilt, ship.fuel)) {
    run.startInputX = inputs[0]!;
    run.startInputY = inputs[1]!;
    run.startFuel = ship.fuel;
    run.startTilt = tilt;
    const controls: Controls = { ...NEUTRAL_CONTROLS, rotationInput: [inputs[0]!, inputs[1]!, 0] };
    startProjection(run.projection, ship, view.bodies[ship.body]!, view.settings, controls);
  }
  if (run.projection.running) runAhead(run, Math.cos(pointOfNoReturn(ship.shipClass)));
}

function differs(run: RightingRun, inputs: Float64Array, tilt: number, fuel: number): boolean {
  return !(
    run.startInputX === inputs[0] &&
    run.startInputY === inputs[1] &&
    Math.abs(run.startFuel - fuel) < SAME_FUEL &&
    Math.abs(run.startTilt - tilt) < SAME_TILT
  );
}

function runAhead(run: RightingRun, cosStanding: number): void {
  const { projection } = run;
  for (let i = 0; i < SUBSTEPS_A_CALL && projection.running; i++) {
    stepProjection(projection);
    const stands = standing(projection, cosStanding);
    const over = projection.elapsed >= HORIZON || projection.ships[CRASHED] === 1;
    if (!stands && !over) continue;
    projection.running = false;
    run.outcome = stands ? 'stands' : 'fails';
    run.seconds = stands ? projection.elapsed : NaN;
    run.fuelNeeded = stands ? run.startFuel - projection.ships[FUEL]! : NaN;
  }
}

/** In contact inside its feet again: from there its legs bring it upright. */
function standing(projection: Projection, cosStanding: number): boolean {
  const state = projection.ships[SURFACE_STATE];
  return state === LANDED || (state === CONTACT && projectedCosTilt(projection) > cosStanding);
}
