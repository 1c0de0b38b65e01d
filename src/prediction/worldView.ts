import { BODY_ANGULAR_VELOCITY, BODY_POSITION, BODY_STRIDE, BODY_VELOCITY } from '../dynamics';
import { boundaryAt } from './bodyTrack';
import { lengthOf, quaternion } from './rotation';
import { writeBodyAttitude } from './pose';
import type { Simulation } from './simulation';
import type { Instant } from './status';
import { indexOf, type Moment, spanOf } from './timeline';
import type { Track } from './track';
import type { ShipView, WorldView } from './view';
import { createShipView, fillShipView } from './viewing';

/** A view under construction: what the page sees, and which track each ship's record belongs to. */
export interface Shown {
  readonly view: WorldView;
  readonly ships: Map<Track, ShipView>;
  viewedAt: number;
}

interface BodyView {
  readonly name: string;
  readonly mass: number;
  readonly radius: number;
  readonly position: [number, number, number];
  readonly velocity: [number, number, number];
  readonly attitude: [number, number, number, number];
  readonly angularVelocity: [number, number, number];
}

export function createShown(sim: Simulation): Shown {
  const bodies = sim.world.bodies.map(({ name, mass, radius }): BodyView => {
    return {
      name,
      mass,
      radius,
      position: [0.5, 0.5, 0.5],
      velocity: [0.5, 0.5, 0.5],
      attitude: [0.5, 0.5, 0.5, 0.5],
      angularVelocity: [0.5, 0.5, 0.5],
    };
  });
  const view: WorldView = {
    tick: 0,
    sinceTick: 0,
    tickRate: 1,
    timeScale: 1,
    paused: false,
    ready: false,
    settings: sim.world.settings,
    bodies,
    ships: [],
    own: null,
    diagnosis: sim.counters,
  };
  return { view, ships: new Map(), viewedAt: Number.NaN };
}

/** Fills the view for the moment that is drawn. */
export function fillView(
  shown: Shown,
  sim: Simulation,
  at: { now: number; present: number; moment: Moment },
): void {
  const { view } = shown;
  const { timeline, front } = sim;
  const { moment } = at;
  const ahead =
    indexOf(timeline, front.tick, front.substep) - indexOf(timeline, moment.tick, 0) - moment.substeps;
  sim.alpha = ahead <= 0 ? 1 : ahead >= 1 ? 0 : 1 - ahead;
  fillLabel(view, sim);
  fillBodies(view, sim);
  instant.elapsed = Number.isNaN(shown.viewedAt) ? 0 : Math.max(0, at.now - shown.viewedAt);
  shown.viewedAt = at.now;
  instant.now = at.now;
  instant.present = at.present;
  instant.tickRate = view.tickRate;
  instant.paused = view.paused;
  fillShips(shown, sim);
}

const instant: Instant = { now: 0, present: 0, elapsed: 0, tickRate: 1, paused: false };

/** The label of the present: exactly the place between two substep boundaries that is drawn. */
function fillLabel(view: WorldView, sim: Simulation): void {
  const { front, timeline, alpha } = sim;
  const onBoundary = front.substep === 0 && alpha === 1;
  view.tick = front.substep > 0 || onBoundary ? front.tick : front.tick - 1;
  const { timing, tickRate, timeScale } = spanOf(timeline, view.tick);
  const substeps = onBoundary ? 0 : (front.substep > 0 ? front.substep : timing.substeps) - 1 + alpha;
  view.sinceTick = substeps * timing.dt;
  view.tickRate = tickRate;
  view.timeScale = timeScale;
  view.paused = spanOf(timeline, sim.newestTick).paused;
  view.ready = true;
}

function fillBodies(view: WorldView, sim: Simulation): void {
  const rows = boundaryAt(sim.bodies, sim.timeline, sim.front.tick);
  const since =
    view.tick === sim.front.tick
      ? view.sinceTick
      : view.sinceTick - spanOf(sim.timeline, view.tick).timing.tickSeconds;
  for (let i = 0; i < view.bodies.length; i++) {
    const body = view.bodies[i] as BodyView;
    const at = i * BODY_STRIDE;
    for (let k = 0; k < 3; k++) {
      body.velocity[k] = rows[at + BODY_VELOCITY + k]!;
      body.position[k] = rows[at + BODY_POSITION + k]! + body.velocity[k]! * since;
      body.angularVelocity[k] = rows[at + BODY_ANGULAR_VELOCITY + k]!;
    }
    writeBodyAttitude(attitude, sim, i, sim.alpha);
    for (let k = 0; k < 4; k++) body.attitude[k] = attitude[k]!;
  }
}

const attitude = quaternion();

function fillShips(shown: Shown, sim: Simulation): void {
  const { view, ships } = shown;
  const { tracks } = sim.fleet;
  view.own = null;
  view.ships.length = tracks.length;
  for (let i = 0; i < tracks.length; i++) {
    const track = tracks[i]!;
    let ship = ships.get(track);
    if (ship === undefined) {
      ship = createShipView(track, sim.world);
      ships.set(track, ship);
    }
    fillShipView(ship, sim, track, instant);
    view.ships[i] = ship;
    if (!track.own) continue;
    view.own = ship;
    sim.counters.offsetPosition = lengthOf(track.ease.offset);
    sim.counters.offsetAngle = lengthOf(track.ease.turn);
  }
  if (ships.size > tracks.length)
    for (const track of ships.keys()) if (!tracks.includes(track)) ships.delete(track);
}
