/** What the scene is built of, held against what is kept: no page draws each of its parts, and a picture's tolerance hides many. */
import type { Object3D } from 'three';
import { expect, it } from 'vitest';
import { SHIP_CLASSES } from '../../../src/dynamics';
import { createBlobShadows } from '../../../src/scene/effects/blobShadows';
import { createCrash } from '../../../src/scene/effects/crash';
import { createDust } from '../../../src/scene/effects/dust';
import { createFlame } from '../../../src/scene/effects/flame';
import { buildJets } from '../../../src/scene/effects/jets';
import { createDetailTexture } from '../../../src/scene/ground/detailTexture';
import { createRocks } from '../../../src/scene/ground/rocks';
import { createMarkers } from '../../../src/scene/overlays/markers';
import { createOverlays } from '../../../src/scene/overlays/overlays';
import { createPlumbLine } from '../../../src/scene/overlays/plumbLine';
import { buildShip } from '../../../src/scene/ships/models/models';
import { lookOf } from '../../../src/scene/sky/bodyLook';
import { createSky } from '../../../src/scene/sky/sky';
import { createSunlight } from '../../../src/scene/sky/sunlight';
import { geometryLines, recordOf } from './sceneRecord';

const kept = (name: string, lines: readonly string[]) =>
  expect(`${lines.join('\n')}\n`).toMatchFileSnapshot(`kept/${name}.txt`);

it.each(SHIP_CLASSES.map((shipClass) => [shipClass.name, shipClass] as const))(
  'the model of %s',
  async (name, shipClass) => {
    const { engines, thrusters, ...geometries } = buildShip(shipClass);
    const nozzles = [...engines, ...thrusters].map((nozzle) =>
      JSON.stringify(nozzle, (_, value: unknown) =>
        typeof value === 'number' ? Number(value.toFixed(4)) + 0 : value,
      ),
    );
    const shapes = Object.entries(geometries).flatMap(([part, geometry]) => [
      part,
      ...[geometry].flat().flatMap(geometryLines),
    ]);
    const jets = [true, false].flatMap((inAir) => geometryLines(buildJets(buildShip(shipClass), inAir)));
    await kept(name, [...shapes, ...nozzles, 'jets', ...jets]);
  },
);

const detail = createDetailTexture(4);
const flame = createFlame();
const PARTS: Readonly<Record<string, () => Object3D>> = {
  sky: () => createSky(detail).group,
  sunlight: () => createSunlight().group,
  rocks: () => createRocks().mesh,
  dust: () => createDust(detail, flame.uniforms).points,
  crash: () => createCrash().group,
  shadows: () => createBlobShadows().mesh,
  overlays: () => createOverlays().group,
  markers: () => createMarkers().group,
  plumbLine: () => createPlumbLine().group,
  flame: () => flame.light,
};

it.each(Object.entries(PARTS))('the part %s, before its first update', async (name, create) => {
  await kept(name, recordOf(create()));
});

it('the look of each body', async () => {
  const looks = ['Luna', 'Earth', 'Mars', 'Phobos', 'Unknown'].map((body) =>
    JSON.stringify([body, lookOf(body)]),
  );
  await kept('looks', looks);
});
