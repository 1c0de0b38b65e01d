import {
  type Controls,
  CRASHED,
  FUEL,
  LANDED,
  NEUTRAL_CONTROLS,
  SURFACE_STATE,
  TIPPED,
  writeControls,
} from '../../dynamics';
import type { ShipView, WorldView } from '../../prediction';
import {
  createProjection,
  type Projection,
  projectedCosTilt,
  startProjection,
  stepProjection,
} from '../flight/projection';
import type { Surface } from '../surface';

/**
 * Simulates a tipped ship ahead, flown as the hint says: the righting keys held until it leans less than its
 * point of no return, then rate damping alone until it has landed. Without damping the swing that lifts a ship usually
 * carries it over to its other side.
 */
export interface RightingRun {
  readonly projection: Projection;
  outcome: 'working' | 'lands' | 'fails';
  /** Game s of holding, in this run; NaN while the keys are held. */
  released: number;
  /** Game s to hold the keys; NaN unless it lands. */
  holdSeconds: number;
  /** kg until it has landed; NaN unless it does. */
  fuelNeeded: number;
  /** What the run was started for; a new one starts only where these differ. */
  startInputX: number;
  startInputY: number;
  /** kg */
  startFuel: number;
  /** rad */
  startTilt: number;
}

/** Game s; a ship that needs longer than this is not being righted. */
const HORIZON = 60;
/** Some 40 µs a call. */
const SUBSTEPS_A_CALL = 200;
const DAMPED: Controls = { ...NEUTRAL_CONTROLS, attitudeHold: true };
/** Differences that would hardly show in the answer, kg and rad. */
const SAME_FUEL = 10;
const SAME_TILT = 0.035;

export function createRightingRun(): RightingRun {
  return {
    projection: createProjection(),
    outcome: 'working',
    released: NaN,
    holdSeconds: NaN,
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
  run.holdSeconds = NaN;
  run.fuelNeeded = NaN;
  run.startInputX = NaN;
}

/** Continues the run of these inputs, or starts it. The last answer is kept until there is a new one. */
export function runRighting(
  run: RightingRun,
  inputs: Float64Array,
  surface: Surface,
  view: WorldView,
  ship: ShipView,
): void {
  if (!run.projection.running && differs(run, inputs, surface, ship)) {
    run.startInputX = inputs[0]!;
    run.startInputY = inputs[1]!;
    run.startFuel = ship.fuel;
    run.startTilt = surface.tilt;
    const controls: Controls = { ...NEUTRAL_CONTROLS, rotationInput: [inputs[0]!, inputs[1]!, 0] };
    run.released = NaN;
    startProjection(run.projection, ship, view.bodies[ship.body]!, view.settings, controls);
  }
  if (run.projection.running) runAhead(run, Math.cos(surface.noReturn));
}

function differs(run: RightingRun, inputs: Float64Array, { tilt }: Surface, { fuel }: ShipView): boolean {
  return !(
    run.startInputX === inputs[0] &&
    run.startInputY === inputs[1] &&
    Math.abs(run.startFuel - fuel) < SAME_FUEL &&
    Math.abs(run.startTilt - tilt) < SAME_TILT
  );
}

function runAhead(run: RightingRun, cosStanding: number): void {
  const { projection } = run;
  const { ships } = projection;
  for (let i = 0; i < SUBSTEPS_A_CALL && projection.running; i++) {
    stepProjection(projection);
    if (Number.isNaN(run.released) && projectedCosTilt(projection) > cosStanding) {
      run.released = projection.elapsed;
      writeControls(ships, 0, DAMPED);
    }
    const landed = ships[SURFACE_STATE] === LANDED;
    const fallen = ships[SURFACE_STATE] === TIPPED && !Number.isNaN(run.released);
    if (!landed && !fallen && ships[CRASHED] === 0 && projection.elapsed < HORIZON) continue;
    projection.running = false;
    run.outcome = landed ? 'lands' : 'fails';
    run.holdSeconds = landed ? run.released : NaN;
    run.fuelNeeded = landed ? run.startFuel - ships[FUEL]! : NaN;
  }
}
