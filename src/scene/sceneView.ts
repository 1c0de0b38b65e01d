import { ACESFilmicToneMapping, Group, PCFShadowMap, PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { flatTerrain, GRAVITATIONAL_CONSTANT } from '../dynamics';
import type { ShipView, WorldView } from '../prediction';
import { type BodyLook, lookOf } from './sky/bodyLook';
import { createRig, placeEye, releaseRig, turnRig, updateRig, zoomRig } from './cameraRig';
import { createDetailTexture } from './ground/detailTexture';
import { createDust } from './effects/dust';
import { raiseDust } from './effects/dustSources';
import { createFence } from './fence';
import { createGround } from './ground/ground';
import { createGroundMaterial, paintGround, placeGrain } from './ground/groundMaterial';
import { shineOnGround } from './ground/groundShine';
import { createHulls } from './ships/hulls';
import { createJetMaterial } from './effects/jets';
import {
  createTurn,
  layFrame,
  type LocalFrame,
  toBodyAxes,
  toLocalPoint,
  turnOfFrame,
  writeScreenAxes,
} from './localFrame';
import { createOverlays, type OverlayChoice } from './overlays/overlays';
import { anyChosen, createPlaces, placeOverlays } from './overlays/overlayPlaces';
import { createMarkers, type Markers } from './overlays/markers';
import type { Quality } from './quality';
import { createRocks } from './ground/rocks';
import {
  createActor,
  createShelf,
  placeJets,
  poseActor,
  removeActor,
  type ShipActor,
} from './ships/shipActor';
import { createShipMaterial } from './ships/shipMaterial';
import { createSky } from './sky/sky';
import type { Stage } from './stage';
import { createSunlight } from './sky/sunlight';
import { groundPoint } from './ground/terrainLevel';
import { aimCone, coneMeets, createCone } from './viewCone';

/** Where the eye starts: from the shadow's side, a little above the ground. */
const FIRST_AZIMUTH = 1.9;
const FIRST_ELEVATION = 0.16;
/** Distance in heights of the centre of mass over the feet. */
const FIRST_DISTANCE = 5.2;
/** What a crash raises, as a touch at this speed would, m/s. */
const CRASH_SPEED = 50;
/** A frame is laid anew this far from its origin, m: the tangent plane still fits the ground. */
const FRAME_REACH = 20_000;
/** No ship is larger than this around its centre of mass, m. */
const SHIP_REACH = 30;

/** Creates the picture in `canvas`. Throws where the browser gives no WebGL 2. */
export function createStage(canvas: HTMLCanvasElement, quality: Quality): Stage {
  const renderer = new WebGLRenderer({
    canvas,
    antialias: quality.antialias,
    reversedDepthBuffer: true,
    powerPreference: 'high-performance',
  });
  renderer.toneMapping = ACESFilmicToneMapping;
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  const fence = createFence(renderer.getContext() as WebGL2RenderingContext);
  const scene = new Scene();
  const camera = new PerspectiveCamera(48, 16 / 9, 0.4, 600_000);
  const detail = createDetailTexture(quality.anisotropy);
  const groundMaterial = createGroundMaterial(detail);
  const ground = createGround(groundMaterial);
  const sky = createSky(detail);
  const light = createSunlight();
  const rocks = createRocks();
  const dust = createDust(detail);
  const overlays = createOverlays();
  const markerGroup = createMarkers();
  const markers: Markers = { pads: [], touch: null };
  const wardrobe = {
    shelf: createShelf(),
    hull: createShipMaterial(),
    jet: createJetMaterial(),
  };
  const hulls = createHulls(wardrobe.hull);
  const jets = new Group();
  scene.add(
    sky.group,
    ground.group,
    light.group,
    rocks.mesh,
    hulls.group,
    jets,
    dust.points,
    overlays.group,
    markerGroup.group,
  );
  const rig = createRig(FIRST_AZIMUTH, FIRST_ELEVATION, 24);
  const choice: OverlayChoice = {
    ghost: false,
    errorSegment: false,
    contactNormal: false,
    footprint: false,
    forces: false,
  };

  let terrain = flatTerrain;
  let frame: LocalFrame | null = null;
  let look: BodyLook = lookOf('');
  let watchedClass = '';
  let before = NaN;
  let count = 0;
  const turn = createTurn();
  const actors = new Map<string, ShipActor>();
  const point = new Float64Array(3);
  const places = createPlaces();
  const cone = createCone();
  const opening = { across: 1, upright: 1 };

  const lay = (view: WorldView, ship: ShipView) => {
    const body = view.bodies[ship.body]!;
    look = lookOf(body.name);
    toBodyAxes(point, body.attitude, ship.meshPosition);
    frame = layFrame(body, point, look.sun);
    ground.lay(frame, terrain);
    rocks.lay(frame, terrain);
    light.paint(look, frame);
    paintGround(groundMaterial, look, light.direction);
    sky.paint(look, light.direction);
    wardrobe.hull.paint(look);
    rocks.paint(look);
    dust.paint(look, light.direction);
    dust.clear();
    releaseRig(rig);
    for (const [id, actor] of actors) {
      removeActor(actor, jets);
      actors.delete(id);
    }
  };

  const groundY = (x: number, z: number) => {
    groundPoint(point, 0, x, z, { frame: frame!, terrainHeight: terrain });
    return point[1]!;
  };

  const drawShips = (view: WorldView, body: number, seconds: number) => {
    count++;
    for (const ship of view.ships) {
      if (ship.body !== body) continue;
      let actor = actors.get(ship.shipId);
      if (actor === undefined || actor.className !== ship.shipClass.name) {
        if (actor !== undefined) removeActor(actor, jets);
        actor = createActor(ship, wardrobe, look.air !== null);
        actors.set(ship.shipId, actor);
        jets.add(actor.jets);
      }
      actor.seen = count;
      poseActor(actor, ship, view, frame!, turn);
      if (ship.own || view.ships.length < 12) raise(actor, ship, seconds);
    }
    for (const [id, actor] of actors) {
      if (actor.seen === count) continue;
      removeActor(actor, jets);
      actors.delete(id);
    }
  };

  const raise = (actor: ShipActor, ship: ShipView, seconds: number) => {
    const [x, z] = [actor.place[0]!, actor.place[2]!];
    raiseDust(
      dust,
      actor.dust,
      {
        place: actor.place,
        velocity: actor.velocity,
        groundY: groundY(x, z),
        feetHeight: 0,
        legRadius: ship.shipClass.legRadius,
        grounded: ship.surfaceContactState !== '' || ship.crashed,
        impactSpeed: ship.crashed ? CRASH_SPEED : ship.impactSpeed,
        thrust: ship.crashed ? 0 : ship.shipClass.mainEngineThrust * ship.controls.thrustLevel,
        blows: actor.blows,
      },
      seconds,
    );
  };

  const seatShips = (watched: ShipActor, eye: Float64Array) => {
    hulls.clear();
    for (const actor of actors.values()) {
      const isWatched = actor === watched;
      if (isWatched || coneMeets(cone, actor.place[0]!, actor.place[2]!, SHIP_REACH))
        hulls.put(actor, eye, isWatched);
      if (actor.jets.visible) placeJets(actor, eye);
    }
    hulls.finish();
  };

  return {
    overlays: choice,
    markers,
    screenAxes(out) {
      if (frame === null) return false;
      writeScreenAxes(out, turn, rig.eye, rig.focus);
      return true;
    },
    setTerrain(terrainHeight) {
      terrain = terrainHeight;
      frame = null;
    },
    draw(view, seconds) {
      const watched = view.own ?? view.ships[0];
      if (!view.ready || watched === undefined) return;
      const body = view.bodies[watched.body]!;
      const waited = Number.isNaN(before) ? 0 : Math.max(seconds - before, 0);
      const passed = Math.min(waited, 0.25);
      before = seconds;
      if (frame?.bodyName !== body.name || frame.radius !== body.radius) lay(view, watched);
      turnOfFrame(turn, frame!, body.attitude);
      toLocalPoint(point, frame!, turn, watched.meshPosition);
      if (Math.hypot(point[0]!, point[2]!) > FRAME_REACH) {
        lay(view, watched);
        turnOfFrame(turn, frame!, body.attitude);
      }
      if (watched.shipClass.name !== watchedClass) {
        watchedClass = watched.shipClass.name;
        rig.distance = FIRST_DISTANCE * watched.shipClass.groundContactOffset;
        overlays.wear(wardrobe.shelf.model(watched).geometry);
        releaseRig(rig);
      }
      const gravity = (GRAVITATIONAL_CONSTANT * body.mass) / body.radius ** 2;
      dust.update(
        seconds,
        gravity,
        renderer.domElement.height / (2 * Math.tan((camera.fov * Math.PI) / 360)),
      );
      drawShips(view, watched.body, passed);
      const actor = actors.get(watched.shipId)!;
      updateRig(rig, actor.place, actor.velocity, waited);
      placeEye(rig, groundY);
      const { eye, focus } = rig;
      const first = count === 1;
      ground.follow(actor.place[0]!, actor.place[2]!, first ? Infinity : 2);
      rocks.follow(actor.place[0]!, actor.place[2]!, ground.shadowY);
      aimCone(cone, eye, focus, opening);
      ground.place(eye, cone);
      placeGrain(groundMaterial, eye);
      rocks.place(eye, cone);
      dust.points.position.set(-eye[0]!, -eye[1]!, -eye[2]!);
      seatShips(actor, eye);
      const height = actor.place[1]! - groundY(actor.place[0]!, actor.place[2]!);
      const size = watched.shipClass.groundContactOffset * 2.2;
      light.follow(actor.place, eye, size, size * 2 + Math.max(height, 0) / light.direction.y);
      const over = actor.place[1]! - ground.shadowY(actor.place[0]!, actor.place[2]!);
      const sunlit = 0.5 + over / (2 * watched.shipClass.groundContactOffset);
      renderer.toneMappingExposure = light.shade(Math.min(Math.max(sunlit, 0), 1), waited);
      sky.look(eye[1]!, body.radius, turn.quaternion);
      if (anyChosen(choice))
        placeOverlays(places, { view, ship: watched, actor, frame: frame!, turn, eye, groundY });
      overlays.group.visible = anyChosen(choice);
      if (overlays.group.visible) overlays.update(choice, places);
      markerGroup.place(markers, { frame: frame!, turn, eye, groundY });
      camera.up.set(0, 1, 0);
      camera.lookAt(focus[0]! - eye[0]!, focus[1]! - eye[1]!, focus[2]! - eye[2]!);
      shineOnGround(groundMaterial, actor, watched, eye);
      wardrobe.jet.uniforms['flicker']!.value = 0.92 + 0.08 * Math.sin(seconds * 61) * Math.sin(seconds * 37);
      renderer.render(scene, camera);
      if (first) fence.set();
    },
    hasDrawn: fence.isPassed,
    resize(width, height, pixelRatio) {
      renderer.setPixelRatio(pixelRatio);
      renderer.setSize(width, height, false);
      camera.aspect = width / height;
      // A tall window sees as much to the sides as a square one.
      camera.fov = camera.aspect >= 1 ? 48 : 62;
      camera.updateProjectionMatrix();
      opening.upright = Math.tan((camera.fov * Math.PI) / 360);
      opening.across = opening.upright * camera.aspect;
    },
    turnCamera(azimuth, elevation) {
      turnRig(rig, azimuth, elevation);
    },
    zoomCamera(factor) {
      zoomRig(rig, factor, 8);
    },
    resetCamera() {
      rig.azimuth = FIRST_AZIMUTH;
      rig.elevation = FIRST_ELEVATION;
      watchedClass = '';
    },
    dispose() {
      const { shelf, hull, jet } = wardrobe;
      const owned = [
        ground,
        sky,
        light,
        rocks,
        dust,
        overlays,
        markerGroup,
        shelf,
        hull,
        jet,
        hulls,
        groundMaterial,
        detail,
      ];
      for (const each of owned) each.dispose();
      renderer.dispose();
    },
  };
}
