import { GRAVITATIONAL_CONSTANT } from '../dynamics';
import type { ShipView, WorldView } from '../prediction';
import { releaseRig, turnRig, zoomRig } from './camera/cameraRig';
import { aimCamera, FIRST_AZIMUTH, FIRST_ELEVATION } from './camera/cameras';
import { checkedScene, requireScene, type SceneOptions } from './checks';
import { createFence } from './fence';
import { placeGrain } from './ground/groundMaterial';
import { rebuildIfNeeded, showWatchedClass } from './surroundings';
import { rotate, writeScreenAxes } from './localFrame';
import { anyChosen, placeOverlays } from './overlays/overlayPlaces';
import { beginPrograms } from './programs';
import type { Quality } from './quality';
import { createParts, disposeParts } from './sceneParts';
import { createState, frameOf, type SceneState } from './sceneState';
import { poseShips, placeShips } from './shipsInScene';
import type { ShipActor } from './ships/shipActor';
import type { SceneView } from './sceneView';
import { aimCone } from './camera/viewCone';
import { frameShip, halfTangent } from './camera/framing';

/** s: a longer pause between two frames raises no more dust than this. */
const LONGEST_STEP = 0.25;

/**
 * Creates the scene in `canvas`.
 * @throws RangeError that names the invalid argument or option; Error where the browser has no WebGL 2
 *
 * @example
 * ```ts
 * const scene = createSceneView(canvas, qualityFor(document));
 * scene.resize(innerWidth, innerHeight, devicePixelRatio);
 * scene.draw(predictor.view(now), now);
 * ```
 */
export function createSceneView(
  canvas: HTMLCanvasElement,
  quality: Quality,
  options: SceneOptions = {},
): SceneView {
  requireScene(canvas, quality, options);
  return checkedScene(sceneIn(canvas, quality), options.onWarning);
}

function sceneIn(canvas: HTMLCanvasElement, quality: Quality): SceneView {
  const state = createState(createParts(canvas, quality));
  const { parts, rig } = state;
  beginPrograms(parts);
  const fence = createFence(parts.renderer.getContext() as WebGL2RenderingContext);
  return {
    overlays: state.choice,
    markers: state.markers,
    translucent: state.translucent,
    screenAxes(out) {
      if (state.frame === null) return false;
      writeScreenAxes(out, state.turn, rig.eye, rig.focus);
      return true;
    },
    pixelSize() {
      const { eye, focus } = rig;
      const distance = Math.hypot(eye[0]! - focus[0]!, eye[1]! - focus[1]!, eye[2]! - focus[2]!);
      const height = parts.renderer.domElement.height / parts.renderer.getPixelRatio();
      return (2 * distance * halfTangent(parts.camera)) / Math.max(height, 1);
    },
    setTerrain(terrainHeight) {
      if (terrainHeight !== state.terrain) state.frame = null;
      state.terrain = terrainHeight;
      state.isNewWorld = true;
    },
    setSunElevation(elevation) {
      if (elevation === state.sunElevation) return;
      state.sunElevation = elevation;
      state.frame = null;
    },
    draw(view, seconds) {
      const watched = view.own ?? view.ships[0];
      if (!view.ready || watched === undefined) return;
      drawWatched(state, view, watched, seconds);
      if (state.actors.count === 1) fence.set();
    },
    hasDrawn: fence.isPassed,
    ...framingCalls(state),
    turnCamera: (azimuth, elevation) => turnRig(rig, azimuth, elevation),
    zoomCamera: (factor) => zoomRig(rig, factor, 8),
    setCamera(view) {
      state.cameraView = view;
      // The eye changes at once: there is nothing to see half-way between two cameras.
      releaseRig(rig);
    },
    resetCamera() {
      rig.azimuth = FIRST_AZIMUTH;
      rig.elevation = FIRST_ELEVATION;
      rig.raised = 0;
      rig.facesPad = false;
      state.watchedClass = '';
    },
    dispose: () => disposeParts(parts),
  };
}

function framingCalls(state: SceneState): Pick<SceneView, 'resize' | 'setMargins'> {
  const { parts, rig, framing } = state;
  return {
    resize(width, height, pixelRatio) {
      parts.renderer.setPixelRatio(pixelRatio);
      parts.renderer.setSize(width, height, false);
      Object.assign(framing, { width, height });
      frameShip(parts.camera, rig, state);
    },
    setMargins(top, bottom) {
      if (top === framing.top && bottom === framing.bottom) return;
      Object.assign(framing, { top, bottom });
      frameShip(parts.camera, rig, state);
    },
  };
}

/** Draws one frame; each step uses the results of the steps before it. */
function drawWatched(state: SceneState, view: WorldView, watched: ShipView, seconds: number): void {
  const waited = Number.isNaN(state.before) ? 0 : Math.max(seconds - state.before, 0);
  state.before = seconds;
  rebuildIfNeeded(state, view, watched);
  showWatchedClass(state, watched);
  const gravity = gravityOf(view, watched);
  updateDust(state, gravity, seconds);
  poseShips(state, view, watched, Math.min(waited, LONGEST_STEP));
  const actor = state.actors.byId.get(watched.shipId)!;
  const { parts, rig, groundY } = state;
  aimCamera(parts.camera, rig, state.cameraView, {
    actor,
    seconds: waited,
    groundY,
    pad: nextPad(state),
  });
  placeGround(state, actor);
  placeShips(state, actor);
  parts.crash.update(seconds, gravity, rig.eye);
  lightScene(state, actor, waited);
  placeMarks(state, view, watched, actor);
  const flicker = 0.92 + 0.08 * Math.sin(seconds * 61) * Math.sin(seconds * 37);
  parts.flame.place(actor, watched, rig.eye, flicker);
  parts.shipResources.jet.uniforms['flicker']!.value = flicker;
  for (const part of parts.scene.children) if (part.visible) part.updateMatrixWorld();
  parts.renderer.render(parts.scene, parts.camera);
}

/** The pad to land on next, local, m; null without one. */
function nextPad(state: SceneState): Float64Array | null {
  const { pad, markers } = state;
  const next = markers.pads.find(({ isNext }) => isNext);
  if (next === undefined) return null;
  const { axes, radius } = frameOf(state);
  rotate(pad, axes, next.place);
  pad[1] = pad[1]! - radius;
  return pad;
}

/** Call before ships raise dust: sets the time at which grains are emitted. */
function updateDust({ parts }: SceneState, gravity: number, seconds: number): void {
  const pixels = parts.renderer.domElement.height / (2 * Math.tan((parts.camera.fov * Math.PI) / 360));
  parts.dust.update(seconds, gravity, pixels);
}

function placeGround({ parts, rig, cone, opening }: SceneState, { place }: ShipActor): void {
  const { ground, rocks, dust, groundMaterial } = parts;
  const { eye, focus } = rig;
  ground.follow(place[0]!, place[2]!, 2);
  rocks.follow(place[0]!, place[2]!, ground.shadowY);
  aimCone(cone, eye, focus, opening);
  ground.place(eye, cone);
  placeGrain(groundMaterial, eye);
  rocks.place(eye, cone);
  dust.points.position.set(-eye[0]!, -eye[1]!, -eye[2]!);
}

function lightScene(state: SceneState, { place, height, sunlit }: ShipActor, seconds: number): void {
  const { light, sky, renderer, dust } = state.parts;
  const { eye } = state.rig;
  const size = height * 2.2;
  const above = Math.max(place[1]! - state.groundY(place[0]!, place[2]!), 0);
  // Past the ground under the map's farthest row: ground beyond the map's depth would be black.
  light.follow(place, eye, size, size + (above + size) / light.direction.y);
  renderer.toneMappingExposure = light.shade(sunlit, seconds);
  dust.shade(sunlit);
  sky.look(eye[1]!, frameOf(state).radius, state.turn.quaternion);
}

function placeMarks(state: SceneState, view: WorldView, ship: ShipView, actor: ShipActor): void {
  const { parts, choice, turn, groundY } = state;
  const { eye } = state.rig;
  const frame = frameOf(state);
  const { overlays } = parts;
  overlays.group.visible = anyChosen(choice);
  if (overlays.group.visible) {
    placeOverlays(state.places, { view, ship, actor, frame, turn, eye, groundY });
    overlays.update(choice, state.places);
  }
  parts.markers.place(state.markers, { frame, turn, eye, groundY });
  const { place } = actor;
  const isFlying = ship.surfaceContactState === '' && !ship.crashed;
  const feet = place[1]! - ship.shipClass.groundContactOffset;
  const clear = isFlying ? feet - groundY(place[0]!, place[2]!) : 0;
  parts.plumbLine.place([place[0]!, feet, place[2]!], clear, eye);
}

function gravityOf(view: WorldView, ship: ShipView): number {
  const body = view.bodies[ship.body]!;
  return (GRAVITATIONAL_CONSTANT * body.mass) / body.radius ** 2;
}
