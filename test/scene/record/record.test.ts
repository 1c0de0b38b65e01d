/** What the scene is built of, compared with golden files: no page draws each of its parts, and a picture's tolerance hides many. */
import { type Object3D, Vector3 } from 'three';
import { expect, it } from 'vitest';
import { BODIES, SHIP_CLASSES } from '../../../src/dynamics';
import { createBlobShadows } from '../../../src/scene/effects/blobShadows';
import { createCrash } from '../../../src/scene/effects/crash';
import { createDust } from '../../../src/scene/effects/dust';
import { createFlame } from '../../../src/scene/effects/flame';
import { buildJets } from '../../../src/scene/effects/jets';
import { createDetailTexture } from '../../../src/scene/ground/detailTexture';
import { createRocks } from '../../../src/scene/ground/rocks';
import { createLocalFrame, createTurn, turnOfFrame } from '../../../src/scene/localFrame';
import { createMarkers } from '../../../src/scene/overlays/markers';
import { createOverlays } from '../../../src/scene/overlays/overlays';
import { createPlumbLine } from '../../../src/scene/overlays/plumbLine';
import { buildShip } from '../../../src/scene/ships/models/models';
import { lookOf } from '../../../src/scene/sky/bodyLook';
import { NIGHT_ELEVATION, underSun } from '../../../src/scene/sky/underSun';
import { createSky } from '../../../src/scene/sky/sky';
import { createSunlight } from '../../../src/scene/sky/sunlight';
import { geometryLines, recordOf } from './sceneRecord';

const matchesGolden = (name: string, lines: readonly string[]) =>
  expect(`${lines.join('\n')}\n`).toMatchFileSnapshot(`golden/${name}.txt`);

it.each(SHIP_CLASSES.map((shipClass) => [shipClass.name, shipClass] as const))(
  'the model of %s',
  async (name, shipClass) => {
    const { engines, thrusters, geometry: whole, coarser } = buildShip(shipClass);
    const nozzles = [...engines, ...thrusters].map((nozzle) =>
      JSON.stringify(nozzle, (_, value: unknown) =>
        typeof value === 'number' ? Number(value.toFixed(4)) + 0 : value,
      ),
    );
    const shapes = Object.entries({ geometry: whole, coarser: coarser() }).flatMap(([part, geometry]) => [
      part,
      ...[geometry].flat().flatMap(geometryLines),
    ]);
    const jets = [true, false].flatMap((inAir) => geometryLines(buildJets(buildShip(shipClass), inAir)));
    await matchesGolden(name, [...shapes, ...nozzles, 'jets', ...jets]);
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
  await matchesGolden(name, recordOf(create()));
});

it('the look of each body', async () => {
  const looks = ['Luna', 'Earth', 'Mars', 'Phobos', 'Unknown'].map((body) =>
    JSON.stringify([body, lookOf(body)]),
  );
  await matchesGolden('looks', looks);
});

const EYE = Float64Array.of(3, 40, -7);
const slope = (x: number, z: number) => 0.1 * x - 0.05 * z;
const placed = () => {
  const frame = createLocalFrame(BODIES[0]!, [0.36, 0.48, 0.8], { elevation: 15, azimuth: 60 });
  return { frame, turn: turnOfFrame(createTurn(), frame, [0, 0, 0, 1]), eye: EYE, groundY: slope };
};
const skyOver = (body: string, elevation: number | null) => {
  const sky = createSky(detail);
  sky.paint(underSun(lookOf(body), elevation));
  sky.look(900, 1.7e6, Float64Array.of(0.1, 0.5, -0.5, 0.7));
  return sky.group;
};
const dustOver = (body: string) => {
  const dust = createDust(detail, flame.uniforms);
  dust.paint(lookOf(body), new Vector3(0.8, 0.6, 0));
  dust.update(10, 1.6, 700);
  dust.throwGrain([1, 2, 3], [4, 5, 6], { seconds: 2, size: 0.5, opacity: 0.75 });
  dust.throwGrain([-1, 2, -3], [0, 5, 1], { seconds: 3, size: 1.1, opacity: 0.5 });
  dust.update(10.5, 1.6, 700);
  dust.shade(0.25);
  return dust.points;
};
const plumbLineAt = (height: number) => {
  const line = createPlumbLine();
  line.place([5, 90, 2], height, EYE);
  return line.group;
};
const PLACED: Readonly<Record<string, () => Object3D>> = {
  'sky of Luna': () => skyOver('Luna', null),
  'sky of Earth': () => skyOver('Earth', null),
  'sky of Earth at night': () => skyOver('Earth', NIGHT_ELEVATION),
  'dust of Luna': () => dustOver('Luna'),
  'dust of Mars': () => dustOver('Mars'),
  'plumb line of 12 m': () => plumbLineAt(12),
  'plumb line of 55 m': () => plumbLineAt(55),
  'plumb line of 5000 m': () => plumbLineAt(5000),
  markers() {
    const markers = createMarkers();
    const pads = [0, 30].map((aside) => ({
      place: [0.36 * 1_737_400, 0.48 * 1_737_400 + aside, 0.8 * 1_737_400],
      radius: 20 + aside,
      isNext: aside === 0,
    }));
    markers.place({ pads, touch: Float64Array.of(625_470, 833_960, 1_389_920) }, placed());
    return markers.group;
  },
  shadows() {
    const shadows = createBlobShadows();
    shadows.paint(new Vector3(0.8, 0.6, 0));
    for (const height of [5, 60, 400])
      shadows.put([10, height, 20], new Vector3(4, 0, 20), new Vector3(-0.1, 1, 0.05).normalize(), EYE, 4);
    shadows.finish();
    return shadows.mesh;
  },
};

it.each(Object.entries(PLACED))('%s, painted and placed', async (name, create) => {
  await matchesGolden(`placed/${name.replaceAll(' ', '-')}`, recordOf(create()));
});
