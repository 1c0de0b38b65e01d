import {
  type Controls,
  CRASHED,
  FUEL,
  LANDED,
  NEUTRAL_CONTROLS,
  SURFACE_STATE,
  TIPPED,
  writeControls,
} from '../../../dynamics';
import type { ShipView, WorldView } from '../../../prediction';
import {
  createProjection,
  type Projection,
  projectedCosTilt,
  startProjection,
  stepProjection,
} from '../../flight/projection';
import type { Surface } from '../../surface';

/**
 * Simulates a tipped ship ahead, flown by the hint: the righting keys held until it leans little enough, then rate damping alone until
 * it has landed. Without damping the swing that lifts a ship usually carries it over to its other side. A first run finds how fast the ship
 * passes its point of no return: the hand lets go after the eye has seen the angle, so the angle to let go at is larger by the turn in that
 * time. The second run lets go there.
 */
export interface RightingRun {
  readonly projection: Projection;
  outcome: 'working' | 'lands' | 'fails';
  /** Game s of holding, in this run; NaN while the keys are held. */
  released: number;
  /** Lean at which the second run lets go, rad; NaN in the first. */
  releaseLean: number;
  /** The answer: lean at which to let go, rad, and game s to hold the keys; NaN unless it lands. */
  holdLean: number;
  holdSeconds: number;
  /** kg until it has landed; NaN unless it does. */
  fuelNeeded: number;
  /** The run's initial values; a new one starts only where these differ. */
  startInputX: number;
  startInputY: number;
  /** kg */
  startFuel: number;
  /** rad */
  startTilt: number;
}

/** Game s; a ship that needs longer than this is not being righted. */
const HORIZON = 60;
/** About 40 µs per call. */
const SUBSTEPS_A_CALL = 200;
/** Reaction time from reading the angle to letting go: 0.2 game s. */
const HAND_SUBSTEPS = 20;
const DAMPED: Controls = { ...NEUTRAL_CONTROLS, attitudeHold: true };
/** Differences that would hardly show in the answer, kg and rad. */
const SAME_FUEL = 10;
const SAME_TILT = 0.035;

export function createRightingRun(): RightingRun {
  return {
    projection: createProjection(),
    outcome: 'working',
    released: NaN,
    releaseLean: NaN,
    holdLean: NaN,
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
  run.releaseLean = NaN;
  run.holdLean = NaN;
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
  const { projection } = run;
  if (!projection.running) {
    const isNew = differs(run, inputs, surface, ship);
    if (isNew) {
      run.startInputX = inputs[0]!;
      run.startInputY = inputs[1]!;
      run.startFuel = ship.fuel;
      run.startTilt = surface.tilt;
      run.releaseLean = NaN;
    }
    // NaN after a second run, and where the first did not come up.
    if (isNew || !Number.isNaN(run.releaseLean)) {
      run.released = NaN;
      const controls: Controls = { ...NEUTRAL_CONTROLS, rotationInput: [inputs[0]!, inputs[1]!, 0] };
      startProjection(projection, ship, view.bodies[ship.body]!, view.settings, controls);
    }
  }
  if (projection.running) runAhead(run, surface.noReturn);
}

function differs(run: RightingRun, inputs: Float64Array, { tilt }: Surface, { fuel }: ShipView): boolean {
  return !(
    run.startInputX === inputs[0] &&
    run.startInputY === inputs[1] &&
    Math.abs(run.startFuel - fuel) < SAME_FUEL &&
    Math.abs(run.startTilt - tilt) < SAME_TILT
  );
}

function runAhead(run: RightingRun, noReturn: number): void {
  const { projection } = run;
  const { ships } = projection;
  const isFirst = Number.isNaN(run.releaseLean);
  const cosRelease = Math.cos(isFirst ? noReturn : run.releaseLean);
  let cos = projectedCosTilt(projection);
  for (let i = 0; i < SUBSTEPS_A_CALL && projection.running; i++) {
    const before = cos;
    stepProjection(projection);
    cos = projectedCosTilt(projection);
    if (Number.isNaN(run.released) && cos > cosRelease) {
      if (isFirst) {
        projection.running = false;
        run.releaseLean = noReturn + HAND_SUBSTEPS * (Math.acos(before) - Math.acos(cos));
        return;
      }
      run.released = projection.elapsed;
      writeControls(ships, 0, DAMPED);
    }
    const lands = ships[SURFACE_STATE] === LANDED;
    const falls = ships[SURFACE_STATE] === TIPPED && !Number.isNaN(run.released);
    if (!lands && !falls && ships[CRASHED] === 0 && projection.elapsed < HORIZON) continue;
    projection.running = false;
    run.outcome = lands ? 'lands' : 'fails';
    run.holdLean = lands ? run.releaseLean : NaN;
    run.holdSeconds = lands ? run.released : NaN;
    run.fuelNeeded = lands ? run.startFuel - ships[FUEL]! : NaN;
    run.releaseLean = NaN;
  }
}
