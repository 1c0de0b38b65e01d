import { type Vec3 } from '../../../dynamics';
import type { ShipView, WorldView } from '../../../prediction';
import { toInertial } from '../../../readout';
import type { Target } from '../../../readout';
import { findScenario, loadScenario, type Mission, type MissionGoal, padPlaces } from '../../../scenarios';

/** The state of a mission, from confirmed states only: a prediction may be withdrawn. */
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
  /** The ship is over the pad to land on next, at the last `watch`. */
  readonly isOverPad: () => boolean;
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

/** Where a mission is, between two frames. */
interface Tracked {
  mission: Mission | null;
  /** Of the pads, body axes. */
  places: readonly Vec3[];
  marks: readonly PadMark[];
  phase: MissionPhase;
  reached: number;
  off: number;
  held: number;
  isOverPad: boolean;
  /** Game seconds of the frame before; NaN at first. */
  before: number;
  readonly target: { readonly place: Float64Array; radius: number };
}

const AT_FIRST = { phase: 'flying', reached: 0, off: NaN, held: 0, isOverPad: false, before: NaN } as const;

export function createMissionTracker(): MissionTracker {
  const tracked: Tracked = {
    ...AT_FIRST,
    mission: null,
    places: [],
    marks: [],
    target: { place: new Float64Array(3), radius: 0 },
  };
  return {
    begin(mission) {
      Object.assign(tracked, AT_FIRST, { mission, places: placesOf(mission) });
      tracked.target.radius = 0;
      markPads(tracked);
    },
    mission: () => tracked.mission,
    watch(view) {
      if (tracked.mission === null || !view.ready || view.own === null || tracked.places.length === 0)
        return false;
      updateTarget(tracked, view, view.own);
      tracked.isOverPad = distanceTo(tracked.target, view.own.position) <= tracked.target.radius;
      const phase = nextPhase(tracked, tracked.mission, view, view.own);
      tracked.before = gameSeconds(view);
      const hasChanged = phase !== tracked.phase;
      tracked.phase = phase;
      return hasChanged;
    },
    phase: () => tracked.phase,
    reached: () => tracked.reached,
    off: () => tracked.off,
    // Known from the first view on.
    target: () => (tracked.target.radius === 0 ? null : tracked.target),
    isOverPad: () => tracked.isOverPad,
    pads: () => tracked.marks,
    held: () => tracked.held,
  };
}

function placesOf(mission: Mission | null): readonly Vec3[] {
  const scenario = mission === null ? null : findScenario(mission.scenario.name);
  const loaded = scenario === null ? null : loadScenario(scenario);
  return loaded?.ok === true && mission !== null ? padPlaces(mission, loaded.value) : [];
}

function markPads(tracked: Tracked): void {
  tracked.marks = (tracked.mission?.pads ?? []).map(({ radius }, i) => ({
    place: tracked.places[i]!,
    radius,
    isNext: i === tracked.reached,
  }));
}

const bodyPlace = new Float64Array(3);
const bodyAttitude = new Float64Array(4);

/** The target is the next pad, as the body is turned now. */
function updateTarget({ mission, places, reached, target }: Tracked, view: WorldView, own: ShipView): void {
  const index = Math.min(reached, places.length - 1);
  bodyPlace.set(places[index]!);
  bodyAttitude.set(view.bodies[own.body]!.attitude);
  toInertial(target.place, bodyAttitude, bodyPlace);
  target.radius = mission!.pads[index]!.radius;
}

/** m along the ground from the target. */
function distanceTo({ place }: Tracked['target'], position: Float64Array): number {
  const away = [0, 1, 2].map((k) => position[k]! - place[k]!);
  const up = [0, 1, 2].reduce((sum, k) => sum + (away[k]! * position[k]!) / Math.hypot(...position), 0);
  return Math.sqrt(Math.max(0, away.reduce((sum, v) => sum + v * v, 0) - up * up));
}

function nextPhase(tracked: Tracked, { done, pads }: Mission, view: WorldView, own: ShipView): MissionPhase {
  const { phase } = tracked;
  if (phase === 'done' || phase === 'crashed') return phase;
  if (own.provenance !== 'confirmed' && own.shownState !== '') return phase;
  if (own.shownState === 'crashed') return 'crashed';
  if (done.kind === 'hover' && hasHovered(tracked, done, view, own)) return 'done';
  if (done.kind === 'reach' && hasReached(tracked, done, view, own)) return 'done';
  if (own.shownState === 'tipped') return 'tipped';
  if (own.shownState !== 'landed') return 'flying';
  if (phase === 'padReached' || phase === 'beside') return phase;
  tracked.off = distanceTo(tracked.target, own.position);
  if (done.kind !== 'land' || tracked.off > pads[tracked.reached]!.radius) return 'beside';
  tracked.reached += 1;
  markPads(tracked);
  return tracked.reached === pads.length ? 'done' : 'padReached';
}

type Goal<Kind extends MissionGoal['kind']> = Extract<MissionGoal, { readonly kind: Kind }>;

function hasHovered(tracked: Tracked, { low, high, seconds }: Goal<'hover'>, view: WorldView, own: ShipView) {
  const passed = gameSeconds(view) - tracked.before;
  const isInside = own.shownState === '' && own.feetHeight >= low && own.feetHeight <= high;
  tracked.held = isInside ? tracked.held + Math.max(0, Number.isNaN(passed) ? 0 : passed) : 0;
  return tracked.held >= seconds;
}

function hasReached({ target }: Tracked, { below, speed }: Goal<'reach'>, view: WorldView, own: ShipView) {
  return (
    own.shownState === '' &&
    own.feetHeight < below &&
    distanceTo(target, own.position) <= target.radius &&
    speedOverGround(view) < speed
  );
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
