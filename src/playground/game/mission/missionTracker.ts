import { type Vec3 } from '../../../dynamics';
import type { WorldView } from '../../../prediction';
import { toInertial } from '../../../readout';
import type { Target } from '../../../readout';
import { findScenario, type Mission, padPlaces, loadScenario } from '../../../scenarios';

/** How a mission stands, from the confirmed states alone: a prediction may be withdrawn. */
export type MissionPhase =
  | 'flying'
  /** Landed, but not on the pad. */
  | 'beside'
  | 'tipped'
  | 'crashed'
  /** On a pad that is not the last. */
  | 'padReached'
  | 'done';

export interface MissionTracker {
  readonly begin: (mission: Mission | null) => void;
  readonly mission: () => Mission | null;
  /** Once a frame; true when the phase has changed. */
  readonly watch: (view: WorldView) => boolean;
  readonly phase: () => MissionPhase;
  /** Pads reached so far. */
  readonly reached: () => number;
  /** m from the pad's centre, at the last landing. */
  readonly off: () => number;
  /** The pad to land on next, ICRF axes as the body is turned now; null without a mission. */
  readonly target: () => Target | null;
  /** Body axes, for the picture; the same list while nothing changed. */
  readonly pads: () => readonly PadMark[];
  /** Of a hover lesson: seconds held so far. */
  readonly held: () => number;
}

export interface PadMark {
  readonly place: Vec3;
  readonly radius: number;
  readonly isNext: boolean;
}

export function createMissionTracker(): MissionTracker {
  let mission: Mission | null = null;
  let places: Vec3[] = [];
  let marks: PadMark[] = [];
  let phase: MissionPhase = 'flying';
  let reached = 0;
  let off = NaN;
  let held = 0;
  let before = NaN;
  const bodyPlace = new Float64Array(3);
  const target = { place: new Float64Array(3), radius: 0 };
  const attitude = new Float64Array(4);

  const mark = () => {
    marks = (mission?.pads ?? []).map(({ radius }, i) => ({
      place: places[i]!,
      radius,
      isNext: i === reached,
    }));
  };
  const aim = (view: WorldView, index: number) => {
    const body = view.bodies[view.own!.body]!;
    bodyPlace.set(places[index]!);
    attitude.set(body.attitude);
    toInertial(target.place, attitude, bodyPlace);
    target.radius = mission!.pads[index]!.radius;
  };
  const offOf = (position: Float64Array): number => {
    const away = [0, 1, 2].map((k) => position[k]! - target.place[k]!);
    const up = [0, 1, 2].reduce((sum, k) => sum + (away[k]! * position[k]!) / Math.hypot(...position), 0);
    return Math.sqrt(Math.max(0, away.reduce((sum, v) => sum + v * v, 0) - up * up));
  };
  const next = (view: WorldView): MissionPhase => {
    const ship = view.own!;
    const { done, pads } = mission!;
    if (phase === 'done' || phase === 'crashed') return phase;
    if (ship.provenance !== 'confirmed' && ship.shownState !== '') return phase;
    if (ship.shownState === 'crashed') return 'crashed';
    if (done.kind === 'hover') {
      const passed = gameSeconds(view) - before;
      const inside = ship.shownState === '' && ship.feetHeight >= done.low && ship.feetHeight <= done.high;
      held = inside ? held + Math.max(0, Number.isNaN(passed) ? 0 : passed) : 0;
      if (held >= done.seconds) return 'done';
    } else if (done.kind === 'reach' && ship.shownState === '') {
      const slow = speedOverGround(view) < done.speed;
      if (offOf(ship.position) <= pads[reached]!.radius && ship.feetHeight < done.below && slow)
        return 'done';
    }
    if (ship.shownState === 'tipped') return 'tipped';
    if (ship.shownState !== 'landed') return 'flying';
    if (phase === 'padReached' || phase === 'beside') return phase;
    off = offOf(ship.position);
    if (done.kind !== 'land' || off > pads[reached]!.radius) return 'beside';
    reached += 1;
    mark();
    return reached === pads.length ? 'done' : 'padReached';
  };

  return {
    begin(given) {
      mission = given;
      reached = 0;
      phase = 'flying';
      off = NaN;
      held = 0;
      before = NaN;
      const scenario = given === null ? null : findScenario(given.scenario.name);
      const loaded = scenario === null ? null : loadScenario(scenario);
      places = loaded?.ok === true && given !== null ? padPlaces(given, loaded.value) : [];
      mark();
    },
    mission: () => mission,
    watch(view) {
      if (mission === null || !view.ready || view.own === null || places.length === 0) return false;
      aim(view, Math.min(reached, places.length - 1));
      const now = next(view);
      before = gameSeconds(view);
      const changed = now !== phase;
      phase = now;
      return changed;
    },
    phase: () => phase,
    reached: () => reached,
    off: () => off,
    target: () => (mission === null || places.length === 0 || target.radius === 0 ? null : target),
    pads: () => marks,
    held: () => held,
  };
}

/** Game seconds since tick 0. */
export function gameSeconds(view: WorldView): number {
  return (view.tick * view.timeScale) / view.tickRate + view.sinceTick;
}

function speedOverGround({ own, bodies }: WorldView): number {
  const [wx, wy, wz] = bodies[own!.body]!.angularVelocity;
  const [x, y, z] = own!.position as unknown as [number, number, number];
  const [vx, vy, vz] = own!.velocity as unknown as [number, number, number];
  return Math.hypot(vx - (wy * z - wz * y), vy - (wz * x - wx * z), vz - (wx * y - wy * x));
}
