import type { ShipView, WorldView } from '../prediction';
import { releaseRig } from './camera/cameraRig';
import { paintGround } from './ground/groundMaterial';
import { createLocalFrame, toBodyAxes, toLocalPoint, turnOfFrame } from './localFrame';
import type { SceneState } from './sceneState';
import { clearActors } from './ships/actors';
import { MIN_HEIGHT } from './ships/shipActor';
import { lookOf } from './sky/bodyLook';
import { underSun } from './sky/underSun';

/** The frame is replaced this far from its origin, m: up to there the tangent plane fits the ground. */
const FRAME_REACH = 20_000;
/** Distance of the eye in heights of the centre of mass over the feet. */
const FIRST_DISTANCE = 5.2;

/** A world that begins this close to the frame's origin keeps the ground, m: within it the sun's elevation differs by a quarter degree on Phobos. */
const SITE_REACH = 50;

/** Builds the surroundings again for another body, or for a ship that has gone far; for a new world at the same site, clears them. */
export function rebuildIfNeeded(state: SceneState, view: WorldView, watched: ShipView): void {
  const { frame, turn, point, isNewWorld } = state;
  const body = view.bodies[watched.body]!;
  if (frame?.bodyName !== body.name || frame.radius !== body.radius) {
    lay(state, view, watched);
    return;
  }
  toLocalPoint(point, frame, turnOfFrame(turn, frame, body.attitude), watched.meshPosition);
  const away = Math.hypot(point[0]!, point[2]!);
  if (away > (isNewWorld ? SITE_REACH : FRAME_REACH)) lay(state, view, watched);
  else if (isNewWorld) beginWorld(state);
}

/** Builds everything around the ship, and turns the frame as its body is turned. */
function lay(state: SceneState, view: WorldView, ship: ShipView): void {
  const { ground, rocks, light, sky, shipResources, dust, shadows, groundMaterial } = state.parts;
  const body = view.bodies[ship.body]!;
  const look = (state.look = underSun(lookOf(body.name), state.sunElevation));
  toBodyAxes(state.point, body.attitude, ship.meshPosition);
  const frame = (state.frame = createLocalFrame(body, state.point, look.sun));
  ground.rebuild(frame, state.terrain);
  rocks.setGround(frame, state.terrain);
  light.paint(look, frame);
  paintGround(groundMaterial, look, light.direction);
  sky.paint(look);
  shadows.paint(light.direction);
  shipResources.hull.paint(look);
  rocks.paint(look);
  dust.paint(look, light.direction);
  toLocalPoint(state.point, frame, turnOfFrame(state.turn, frame, body.attitude), ship.meshPosition);
  beginWorld(state);
}

/** Clears what is left of the world before. The ship is at `state.point`. */
function beginWorld(state: SceneState): void {
  const { parts, point, actors } = state;
  parts.dust.clear();
  parts.crash.clear();
  parts.light.adapt();
  releaseRig(state.rig);
  clearActors(actors, parts.jets);
  // The whole ground at once: in the first frame nothing of it may be missing under the ship.
  parts.ground.follow(point[0]!, point[2]!, Infinity);
  state.isNewWorld = false;
}

/** Adapts camera and ghost when the watched ship has another class. */
export function showWatchedClass(state: SceneState, watched: ShipView): void {
  const { shipClass } = watched;
  if (shipClass.name === state.watchedClass) return;
  state.watchedClass = shipClass.name;
  state.rig.distance = FIRST_DISTANCE * Math.max(shipClass.groundContactOffset, MIN_HEIGHT);
  state.parts.overlays.setGhostHull(state.parts.shipResources.cache.model(watched).geometry);
  releaseRig(state.rig);
}
