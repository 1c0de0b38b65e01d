import { compose, inverse, rotate } from '../../authority';
import {
  ATTITUDE,
  BODY_ATTITUDE,
  CRASHED,
  EVENT_CONTACT,
  EVENT_TIPPED,
  FUEL,
  IMPACT_SPEED,
  LANDED,
  POSITION,
  type Quat,
  readQuat,
  readVec3,
  type Result,
  ok,
  SURFACE_STATE,
  type Timing,
  type Vec3,
} from '../../dynamics';
import { startScenario } from '../runScenario';
import {
  runTick,
  type Schedule,
  scheduleOf,
  type ScenarioWorld,
  type ScheduledInput,
  type TickRun,
} from '../runTick';
import { loadScenario, ticksOf } from '../scenario';
import { cosineOfTilt } from '../tilt';
import type { Mission } from './mission';
import { padPlaces } from './pads';
import { TRACK_RATE } from './track';

/** Controls from the start of a substep on, ascending in time. */
export type RunInput = ScheduledInput;

/** The result of a flight. SI units, degrees. */
export interface RunOutcome {
  /** 'landed' on the last pad, 'crashed', or 'unfinished' when the time ran out. */
  readonly outcome: 'landed' | 'crashed' | 'unfinished';
  /** Game seconds from the start to the end. */
  readonly seconds: number;
  readonly padsReached: number;
  /** Hardest touch of the landings that count, m/s. */
  readonly touchSpeed: number;
  /** Largest distance of the landings from the pad's centre, m. */
  readonly distance: number;
  /** Largest lean between a touch and rest. */
  readonly tilt: number;
  readonly fuelUsed: number;
  readonly hasTipped: boolean;
  /** Ten poses per second in body axes: position x, y, z (m), and attitude relative to the body's (x, y, z, w). */
  readonly track: Float64Array;
}

interface Flight extends ScenarioWorld {
  readonly track: number[];
  /** Until the end or the crash. */
  substeps: number;
  padsReached: number;
  touchSpeed: number;
  distance: number;
  tilt: number;
  hasTipped: boolean;
  /** Maxima since the present landing's first touch. */
  touching: { speed: number; tilt: number } | null;
}

/**
 * Replays a mission from its inputs on the dynamics alone. The same inputs give the same flight to the bit, which verifies a run.
 * Ends on the last pad, in a crash, or after the scenario's duration.
 */
export function flyRun(mission: Mission, inputs: readonly RunInput[]): Result<RunOutcome> {
  const loaded = loadScenario(mission.scenario);
  if (!loaded.ok) return loaded;
  const prepared = startScenario(loaded.value);
  if (!prepared.ok) return prepared;
  const { timing } = loaded.value;
  const pads = padPlaces(mission, loaded.value);
  const flight: Flight = {
    ...prepared.value,
    track: [],
    substeps: 0,
    padsReached: 0,
    touchSpeed: 0,
    distance: 0,
    tilt: 0,
    hasTipped: false,
    touching: null,
  };
  const { ship } = flight;
  const began = ship[FUEL]!;
  const run = flightRun(flight, timing, planUntilFlown(scheduleOf(loaded.value.inputs), scheduleOf(inputs)));
  const ticks = ticksOf(loaded.value);
  for (let tick = 0; tick < ticks; tick++) {
    runTick(flight, tick, run);
    recordPad(flight, pads, mission);
    if (ship[CRASHED] === 1 || flight.padsReached === pads.length) break;
  }
  const outcome =
    ship[CRASHED] === 1 ? 'crashed' : flight.padsReached === pads.length ? 'landed' : 'unfinished';
  return ok({
    outcome,
    seconds: flight.substeps * timing.dt,
    padsReached: flight.padsReached,
    touchSpeed:
      flight.touching === null ? flight.touchSpeed : Math.max(flight.touchSpeed, flight.touching.speed),
    distance: flight.distance,
    tilt: flight.tilt,
    fuelUsed: began - ship[FUEL]!,
    hasTipped: flight.hasTipped,
    track: Float64Array.from(flight.track),
  });
}

/** Records the track and the touches, substep by substep, until the ship crashes. */
function flightRun(flight: Flight, timing: Timing, schedule: Schedule): TickRun {
  const { ship } = flight;
  const apart = Math.max(1, Math.round(1 / (TRACK_RATE * timing.dt)));
  let flies: boolean;
  return {
    timing,
    schedule,
    before() {
      flies = ship[CRASHED] === 0;
      if (flies && flight.substeps % apart === 0) record(flight);
    },
    after(event) {
      if (!flies) return;
      recordTouch(flight, event);
      flight.substeps++;
    },
  };
}

/** The scenario's own inputs until the pilot's first one, as the authority applies them. */
function planUntilFlown(plan: Schedule, pilot: Schedule): Schedule {
  let isFlown = false;
  return (tick, substep) => {
    const planned = isFlown ? null : plan(tick, substep);
    const flown = pilot(tick, substep);
    if (flown !== null) isFlown = true;
    return flown ?? planned;
  };
}

function recordTouch(flight: Flight, event: number): void {
  const { ship } = flight;
  if (event === EVENT_TIPPED) flight.hasTipped = true;
  if (event === EVENT_CONTACT) {
    flight.touching ??= { speed: 0, tilt: 0 };
    flight.touching.speed = Math.max(flight.touching.speed, ship[IMPACT_SPEED]!);
  }
  if (flight.touching === null || ship[SURFACE_STATE] === 0) return;
  flight.touching.tilt = Math.max(flight.touching.tilt, tiltOf(ship));
}

/** Called at a tick boundary, where body and ship are at the same instant. */
function recordPad(flight: Flight, pads: readonly Vec3[], mission: Mission): void {
  const { ship, bodies } = flight;
  if (ship[SURFACE_STATE] !== LANDED || flight.touching === null) return;
  const at = rotate(inverse(bodyAttitude(bodies)), readVec3(ship, POSITION));
  const pad = pads[flight.padsReached]!;
  const off = lengthOf([at[0] - pad[0], at[1] - pad[1], at[2] - pad[2]], at);
  if (off > mission.pads[flight.padsReached]!.radius) {
    // A landing beside the pad does not count; the next one may.
    flight.touching = null;
    return;
  }
  flight.touchSpeed = Math.max(flight.touchSpeed, flight.touching.speed);
  flight.tilt = Math.max(flight.tilt, flight.touching.tilt);
  flight.distance = Math.max(flight.distance, off);
  flight.touching = null;
  flight.padsReached++;
}

/** The length of an offset along the ground at `at`. */
function lengthOf(offset: Vec3, at: Vec3): number {
  const distance = Math.hypot(...at);
  const up = (offset[0] * at[0] + offset[1] * at[1] + offset[2] * at[2]) / distance;
  return Math.sqrt(Math.max(0, offset[0] ** 2 + offset[1] ** 2 + offset[2] ** 2 - up * up));
}

function tiltOf(ship: Float64Array): number {
  const cosine = cosineOfTilt(readQuat(ship, ATTITUDE), readVec3(ship, POSITION));
  return (Math.acos(Math.min(1, Math.max(-1, cosine))) * 180) / Math.PI;
}

function record({ ship, bodies, track }: Flight): void {
  const back = inverse(bodyAttitude(bodies));
  const [x, y, z] = rotate(back, readVec3(ship, POSITION));
  track.push(x, y, z, ...compose(back, readQuat(ship, ATTITUDE)));
}

function bodyAttitude(bodies: Float64Array): Quat {
  return readQuat(bodies, BODY_ATTITUDE);
}
