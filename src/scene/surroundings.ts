import type { ShipView, WorldView } from '../prediction';
import { releaseRig } from './camera/cameraRig';
import { paintGround } from './ground/groundMaterial';
import { createLocalFrame, toBodyAxes, toLocalPoint, turnOfFrame } from './localFrame';
import { frameOf, type SceneState } from './sceneState';
import { clearActors } from './ships/actors';
import { MIN_HEIGHT } from './ships/shipActor';
import { lookOf } from './sky/bodyLook';
import { underSun } from './sky/underSun';

/** The frame is replaced this far from its origin, m: up to there the tangent plane fits the ground. */
const FRAME_REACH = 20_000;
/** Distance of the eye in heights of the centre of mass over the feet. */
const FIRST_DISTANCE = 5.2;

/** Builds the surroundings again for another body, or for a ship that has gone far. */
export function rebuildIfNeeded(state: SceneState, view: WorldView, watched: ShipView): void {
  const body = view.bodies[watched.body]!;
  if (state.frame?.bodyName !== body.name || state.frame.radius !== body.radius) lay(state, view, watched);
  else turnOfFrame(state.turn, state.frame, body.attitude);
  toLocalPoint(state.point, frameOf(state), state.turn, watched.meshPosition);
  if (Math.hypot(state.point[0]!, state.point[2]!) > FRAME_REACH) lay(state, view, watched);
}

/** Builds everything around the ship, and turns the frame as its body is turned. */
function lay(state: SceneState, view: WorldView, ship: ShipView): void {
  const { ground, rocks, light, sky, shipResources, dust, crash, shadows, groundMaterial, jets } =
    state.parts;
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
  dust.clear();
  crash.clear();
  releaseRig(state.rig);
  clearActors(state.actors, jets);
  // All of the ground before its first frame: otherwise the ship would be above nothing.
  toLocalPoint(state.point, frame, turnOfFrame(state.turn, frame, body.attitude), ship.meshPosition);
  ground.follow(state.point[0]!, state.point[2]!, Infinity);
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
