import { ACESFilmicToneMapping, Group, PCFShadowMap, PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { createBlobShadows } from './effects/blobShadows';
import { createCrash } from './effects/crash';
import { createDust } from './effects/dust';
import { createFlame } from './effects/flame';
import { createJetMaterial } from './effects/jets';
import { createDetailTexture } from './ground/detailTexture';
import { createGround } from './ground/ground';
import { createGroundMaterial } from './ground/groundMaterial';
import { createRocks } from './ground/rocks';
import { createMarkers } from './overlays/markers';
import { createOverlays } from './overlays/overlays';
import { createPlumbLine } from './overlays/plumbLine';
import type { Quality } from './quality';
import { createHulls } from './ships/hulls';
import { createModelCache } from './ships/shipActor';
import { createShipMaterial } from './ships/shipMaterial';
import { createTranslucentShips } from './ships/translucentShips';
import { createSky } from './sky/sky';
import { createSunlight } from './sky/sunlight';

/** Everything that is drawn, and the renderer. Created once; `disposeParts` releases the GPU's memory. */
export type SceneParts = ReturnType<typeof createParts>;

/** @throws without WebGL 2 */
export function createParts(canvas: HTMLCanvasElement, quality: Quality) {
  const renderer = createRenderer(canvas, quality);
  const detail = createDetailTexture(quality.anisotropy);
  const flame = createFlame();
  const groundMaterial = createGroundMaterial(detail, flame.uniforms);
  const shipResources = { cache: createModelCache(), hull: createShipMaterial(), jet: createJetMaterial() };
  const parts = {
    renderer,
    scene: new Scene(),
    camera: new PerspectiveCamera(48, 16 / 9, 0.4, 600_000),
    detail,
    flame,
    groundMaterial,
    shipResources,
    ground: createGround(groundMaterial),
    sky: createSky(detail),
    light: createSunlight(),
    rocks: createRocks(),
    dust: createDust(detail, flame.uniforms),
    crash: createCrash(),
    hulls: createHulls(shipResources.hull),
    shadows: createBlobShadows(),
    translucent: createTranslucentShips(),
    jets: new Group(),
    overlays: createOverlays(),
    markers: createMarkers(),
    plumbLine: createPlumbLine(),
  };
  const { scene, sky, ground, light, rocks, hulls, jets, dust } = parts;
  // These stay at the origin: their matrices, and those of their fixed children, are computed once.
  const { overlays, markers, translucent } = parts;
  for (const fixed of [sky, light, hulls, overlays, markers, translucent])
    fixed.group.matrixAutoUpdate = false;
  jets.matrixAutoUpdate = false;
  // drawWatched updates the parts in sight.
  scene.matrixWorldAutoUpdate = false;
  scene.add(sky.group, ground.mesh, light.group, rocks.mesh, parts.shadows.mesh, hulls.group, jets);
  scene.add(
    flame.light,
    dust.points,
    parts.crash.group,
    translucent.group,
    parts.overlays.group,
    parts.markers.group,
    parts.plumbLine.group,
  );
  return parts;
}

function createRenderer(canvas: HTMLCanvasElement, quality: Quality): WebGLRenderer {
  const renderer = new WebGLRenderer({
    canvas,
    antialias: quality.antialias,
    reversedDepthBuffer: true,
    powerPreference: 'high-performance',
  });
  renderer.toneMapping = ACESFilmicToneMapping;
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  return renderer;
}

export function disposeParts(parts: SceneParts): void {
  const { shipResources, renderer } = parts;
  const owned = [
    ...[parts.ground, parts.sky, parts.light, parts.flame, parts.rocks, parts.dust, parts.crash, parts.hulls],
    ...[
      parts.shadows,
      parts.translucent,
      parts.overlays,
      parts.markers,
      parts.plumbLine,
      parts.groundMaterial,
      parts.detail,
    ],
    ...[shipResources.cache, shipResources.hull, shipResources.jet],
  ];
  for (const each of owned) each.dispose();
  renderer.dispose();
}
