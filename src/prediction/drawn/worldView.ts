import { BODY_ANGULAR_VELOCITY, BODY_POSITION, BODY_STRIDE, BODY_VELOCITY } from '../../dynamics';
import { boundaryAt } from '../snapshots/bodies/bodyTrack';
import { writeBodyAttitude } from './pose';
import { lengthOf, take } from './rotation';
import type { Simulation } from '../simulation/simulation';
import { sendSeconds } from '../time/cadence';
import { staleAfter } from '../time/connection';
import { indexOf, type Moment, spanOf } from '../time/timeline';
import type { WorldView } from './view';
import type { Springs } from './ease';
import { createViewContext, type ViewContext, type ViewFeatures } from './viewContext';
import { createShipView, fillShipView } from './shipView';

/** A view under construction, and what all its ships share. */
export interface ViewBuilder {
  readonly view: WorldView;
  readonly context: ViewContext;
  /** Of the view under construction. */
  readonly instant: ViewInstant;
  viewedAt: number;
}

interface BodyView {
  readonly name: string;
  mass: number;
  radius: number;
  readonly position: [number, number, number];
  readonly velocity: [number, number, number];
  readonly attitude: [number, number, number, number];
  readonly angularVelocity: [number, number, number];
}

export function createViewBuilder(sim: Simulation, springs: Springs, features: ViewFeatures): ViewBuilder {
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
    connection: 'waiting',
    silence: Number.POSITIVE_INFINITY,
    settings: sim.world.settings,
    bodies,
    ships: [],
    own: null,
    diagnosis: sim.counters,
  };
  const context = createViewContext(sim, springs, features);
  const instant = { now: 0, present: 0, lead: 0, heard: 0 };
  return { view, context, instant, viewedAt: Number.NaN };
}

/** The simulation has a new world with the same bodies: views continue with its constants. */
export function showWorld({ view, context }: ViewBuilder, { world }: Simulation): void {
  view.settings = world.settings;
  context.world = world;
  context.ground.terrainHeight = world.terrainHeight;
  for (const [i, { mass, radius }] of world.bodies.entries()) {
    const body = view.bodies[i] as BodyView;
    body.mass = mass;
    body.radius = radius;
  }
}

/** s for which a state still confirms after the next one is due: that one is on its way. */
const GRACE = 0.04;
/** Ships put on the ground point by point in one view, besides the player's ship. */
const MAX_EXACT_SNAPS = 32;

/** Where the present lies between the substep boundary before the front and the front. */
export function placePresent(sim: Simulation, moment: Moment): void {
  const { timeline, front } = sim;
  const ahead =
    indexOf(timeline, front.tick, front.substep) - indexOf(timeline, moment.tick, 0) - moment.substeps;
  sim.alpha = ahead <= 0 ? 1 : ahead >= 1 ? 0 : 1 - ahead;
}

/** The instant of a view; kept by its owner, since a record made for each view is garbage. */
export interface ViewInstant {
  /** Client wall s. */
  now: number;
  /** Server wall s of the present, and how far it is ahead of the server. */
  present: number;
  lead: number;
  /** Server wall s at which a message that arrives now was sent, by the delay that 19 in 20 do not exceed. */
  heard: number;
}

/** Fills the view for its instant, with the present as it is placed. */
export function fillView(builder: ViewBuilder, sim: Simulation): void {
  const { view, context } = builder;
  const { now, present, lead, heard } = builder.instant;
  fillLabel(view, sim);
  fillBodies(builder, sim);
  const { at } = context;
  at.elapsed = Number.isNaN(builder.viewedAt) ? 0 : Math.max(0, now - builder.viewedAt);
  builder.viewedAt = now;
  at.now = now;
  at.present = present;
  at.staleAfter = staleAfter(sim.cadence, view.tickRate);
  at.confirms = sendSeconds(sim.cadence, view.tickRate) + lead + GRACE;
  at.paused = view.paused;
  at.bodiesKnown = sim.bodiesKnown;
  context.playback.at = heard - sendSeconds(sim.cadence, view.tickRate);
  context.playback.timeScale = view.timeScale;
  // The timeline may have changed since the last view: forget the looked-up tick.
  at.serverTick = Number.NaN;
  context.exactSnaps = MAX_EXACT_SNAPS;
  fillShips(builder, sim);
}

/** Labels the view with the exact instant that is drawn, between two substep boundaries. */
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

function fillBodies({ view, context }: ViewBuilder, sim: Simulation): void {
  const { front, timeline } = sim;
  const rows = boundaryAt(sim.bodies, timeline, front.tick);
  const before = view.tick === front.tick ? 0 : spanOf(timeline, view.tick).timing.tickSeconds;
  const since = view.sinceTick - before;
  for (let i = 0; i < view.bodies.length; i++) {
    const body = view.bodies[i] as BodyView;
    const at = i * BODY_STRIDE;
    const attitude = context.bodyAttitudes[i]!;
    take(context.bodySpins[i]!, rows, at + BODY_ANGULAR_VELOCITY);
    writeBodyAttitude(attitude, sim, i, sim);
    for (let k = 0; k < 3; k++) {
      body.velocity[k] = rows[at + BODY_VELOCITY + k]!;
      body.position[k] = rows[at + BODY_POSITION + k]! + body.velocity[k]! * since;
      body.angularVelocity[k] = rows[at + BODY_ANGULAR_VELOCITY + k]!;
    }
    for (let k = 0; k < 4; k++) body.attitude[k] = attitude[k]!;
  }
}

function fillShips({ view, context }: ViewBuilder, sim: Simulation): void {
  const { tracks } = sim.fleet;
  view.own = null;
  view.ships.length = tracks.length;
  sim.counters.shipsExtrapolated = 0;
  for (let i = 0; i < tracks.length; i++) {
    const track = tracks[i]!;
    if (track.fit.extrapolated !== '') sim.counters.shipsExtrapolated += 1;
    track.picture.view ??= createShipView(track, sim.world);
    fillShipView(track.picture.view, sim, track, context);
    view.ships[i] = track.picture.view;
    if (!track.own) continue;
    view.own = track.picture.view;
    sim.counters.groundOffset = track.picture.view.groundOffset;
    sim.counters.groundConfidence = track.picture.view.groundConfidence;
    sim.counters.offsetPosition = lengthOf(track.picture.ease.offset);
    sim.counters.offsetAngle = lengthOf(track.picture.ease.turn);
  }
}
