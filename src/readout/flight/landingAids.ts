import { EVENT_CONTACT, EVENT_DESTROYED, IMPACT_SPEED, POSITION, VELOCITY } from '../../dynamics';
import type { ShipView, WorldView } from '../../prediction';
import { cross, writeDot } from '../axes';
import { createViewClock, followView, type ViewClock } from '../landing/viewClock';
import { measureCorridor } from './corridor';
import {
  createProjection,
  type Projection,
  projectedCosTilt,
  startProjection,
  stepProjection,
} from './projection';
import { createSurface, measureSurface, type Surface } from '../surface';
import { viewOf } from '../arguments';
import { writeGroundPlace, writePlaceNow } from './touchPlace';

/** Landing aids: the predicted touchdown, the latest time to brake, the descent speed to aim for. SI units. */
export interface LandingAids {
  /** In flight, below the ceiling of the descent data. */
  shown: boolean;
  /** Result of simulating ahead under the present controls: 'touch' once the ship has touched, 'none' if it does not within two minutes. */
  outcome: 'working' | 'touch' | 'none';
  /** Game s until that touch. */
  touchSeconds: number;
  /** m/s at the touch, relative to the ground. */
  touchVertical: number;
  touchHorizontal: number;
  /** Degrees. */
  touchTilt: number;
  /** Relative to the body's centre, ICRF axes, at the ground's present rotation, m. */
  readonly touchPlace: Float64Array;
  /** Game s until full thrust must begin to stop just above the ground; ≤ 0: now; NaN while the ship does not fall. */
  burnSeconds: number;
  /** The approach corridor: the descent speed that leaves half of the engine in reserve, and how well the ship keeps it. */
  aimSpeed: number;
  corridor: 'slow' | 'good' | 'fast' | 'none';
  /**
   * What the throttle should do, from the corridor a moment ahead: a pilot reacts late and would overshoot the present one. 'push': the
   * engine is off, there is next to no gravity, and thrusters must push the ship down.
   */
  advice: 'more' | 'hold' | 'less' | 'push' | 'none';
  /** Kept from view to view; not shown. @internal */
  readonly memory: AidsMemory;
}

interface AidsMemory {
  readonly surface: Surface;
  readonly clock: ViewClock;
  readonly projection: Projection;
  startedAt: number;
  /** Of the last touch predicted, on the view clock; NaN before. */
  touchAt: number;
  /** Its place, body axes, m. */
  readonly touched: Float64Array;
}

/** Game s simulated ahead. */
const HORIZON = 120;
/** Game s by which the same touch may be later in the next run. */
const SAME_TOUCH = 1;
/** About 80 µs per call. */
const SUBSTEPS_A_CALL = 400;
/** m AGL, as the descent data. */
const CEILING = 50_000;
/**
 * Empty landing aids, filled by updateLandingAids.
 *
 * @example
 * ```ts
 * const aids = updateLandingAids(createLandingAids(), predictor.view(now));
 * console.log(aids.outcome);
 * ```
 */
export function createLandingAids(): LandingAids {
  return {
    shown: false,
    outcome: 'working',
    touchSeconds: NaN,
    touchVertical: NaN,
    touchHorizontal: NaN,
    touchTilt: NaN,
    touchPlace: new Float64Array(3),
    burnSeconds: NaN,
    aimSpeed: NaN,
    corridor: 'none',
    advice: 'none',
    memory: {
      surface: createSurface(),
      clock: createViewClock(),
      projection: createProjection(),
      startedAt: NaN,
      touchAt: NaN,
      touched: new Float64Array(3),
    },
  };
}

/**
 * Depends on the view and on the simulation ahead kept in `out`; without a ship, or for one on the ground, it costs nothing.
 *
 * @example
 * ```ts
 * const aids = createLandingAids(); // once
 * const { touchSeconds, touchVertical } = updateLandingAids(aids, predictor.view(now)); // s, m/s
 * ```
 */
export function updateLandingAids(out: LandingAids, given: WorldView | null): LandingAids {
  const view = viewOf('updateLandingAids', out, given);
  const ship = view.ready ? view.own : null;
  const body = ship === null ? undefined : view.bodies[ship.body];
  const { surface, clock, projection } = out.memory;
  const flies =
    ship !== null && ship.surfaceContactState === '' && !ship.crashed && ship.provenance !== 'stale';
  if (ship === null || body === undefined || !flies) {
    forgetAids(out);
    return out;
  }
  measureSurface(surface, ship, body);
  if (!followView(clock, view, ship)) forgetAids(out);
  out.shown = surface.clearance < CEILING;
  if (!out.shown) return out;
  measureCorridor(out, surface, ship);
  if (!projection.running) {
    out.memory.startedAt = clock.now;
    startProjection(projection, ship, body, view.settings, ship.controls);
  }
  runAhead(out, view, ship);
  return out;
}

function forgetAids(out: LandingAids): void {
  out.shown = false;
  out.outcome = 'working';
  out.touchSeconds = NaN;
  out.touchVertical = NaN;
  out.touchHorizontal = NaN;
  out.touchTilt = NaN;
  out.burnSeconds = NaN;
  out.aimSpeed = NaN;
  out.corridor = 'none';
  out.advice = 'none';
  out.memory.projection.running = false;
}

const groundVelocity = new Float64Array(3);
const bodySpin = new Float64Array(3);
const place = new Float64Array(3);
const product = new Float64Array(2);

function runAhead(out: LandingAids, view: WorldView, ship: ShipView): void {
  const { projection, clock } = out.memory;
  for (let i = 0; i < SUBSTEPS_A_CALL && projection.running; i++) {
    const event = stepProjection(projection);
    const touched = event === EVENT_CONTACT || event === EVENT_DESTROYED;
    if (!touched && projection.elapsed < HORIZON) continue;
    projection.running = false;
    out.outcome = touched ? 'touch' : 'none';
    if (touched) readTouch(out, view, ship);
  }
  const { startedAt, touchAt, touched } = out.memory;
  // The controls have changed since that touch was predicted: this run has flown past it.
  if (out.outcome === 'touch' && projection.running && startedAt + projection.elapsed > touchAt + SAME_TOUCH)
    out.outcome = 'working';
  if (out.outcome === 'touch') {
    out.touchSeconds = Math.max(0, touchAt - clock.now);
    writePlaceNow(out.touchPlace, touched, view.bodies[ship.body]!);
    return;
  }
  out.touchSeconds = NaN;
  out.touchVertical = NaN;
  out.touchHorizontal = NaN;
  out.touchTilt = NaN;
}

function readTouch(out: LandingAids, view: WorldView, ship: ShipView): void {
  const { projection, startedAt, clock, touched } = out.memory;
  const { ships, elapsed } = projection;
  const body = view.bodies[ship.body]!;
  out.memory.touchAt = startedAt + elapsed;
  for (let k = 0; k < 3; k++) {
    place[k] = ships[POSITION + k]!;
    bodySpin[k] = body.angularVelocity[k]!;
  }
  cross(groundVelocity, bodySpin, place);
  let along = 0;
  writeDot(product, 0, place, place);
  const distance = Math.sqrt(product[0]!);
  for (let k = 0; k < 3; k++) along += ((ships[VELOCITY + k]! - groundVelocity[k]!) * place[k]!) / distance;
  let level = 0;
  for (let k = 0; k < 3; k++)
    level += (ships[VELOCITY + k]! - groundVelocity[k]! - (along * place[k]!) / distance) ** 2;
  out.touchVertical = Math.max(ships[IMPACT_SPEED]!, Math.abs(along));
  out.touchHorizontal = Math.sqrt(level);
  out.touchTilt = (Math.acos(Math.min(1, Math.max(-1, projectedCosTilt(projection)))) * 180) / Math.PI;
  writeGroundPlace(touched, place, body, out.memory.touchAt - clock.now);
}
