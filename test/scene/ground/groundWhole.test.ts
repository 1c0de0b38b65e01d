import { Group, PerspectiveCamera, Scene, ShaderMaterial, type WebGLRenderer } from 'three';
import { describe, expect, it } from 'vitest';
import { LESSONS, loadScenario, MISSIONS, type Scenario, SCENARIOS } from '../../../src/scenarios';
import { createCone } from '../../../src/scene/camera/viewCone';
import { createGround, type Ground } from '../../../src/scene/ground/ground';
import { CELLS, FINEST, MAX_LEVELS, VERTICES } from '../../../src/scene/ground/levels';
import { createLocalFrame, toBodyAxes } from '../../../src/scene/localFrame';
import { lookOf } from '../../../src/scene/sky/bodyLook';

const ALL: readonly Scenario[] = [
  ...SCENARIOS,
  ...MISSIONS.map(({ scenario }) => scenario),
  ...LESSONS.map(({ scenario }) => scenario),
];
/** The ground as the scene builds it around a scenario's ship, before its first picture. */
function groundOf(scenario: Scenario): Ground {
  const loaded = loadScenario(scenario);
  if (!loaded.ok) throw new Error(loaded.reason);
  const { body, ship, terrainHeight } = loaded.value;
  const under = new Float64Array(3);
  toBodyAxes(under, body.attitude, Float64Array.from(ship.relativePosition));
  const ground = createGround(new ShaderMaterial());
  ground.rebuild(createLocalFrame(body, under, lookOf(body.name).sun), terrainHeight);
  return ground;
}

/** Every range of the index that is drawn: the first by three, the others by the mesh after it. */
function drawnRanges({ mesh }: Ground): (readonly [start: number, count: number])[] {
  if (!mesh.visible) return [];
  const { start, count } = mesh.geometry.drawRange;
  const ranges: (readonly [number, number])[] = [[start, count]];
  const gl = {
    drawElements: (_mode: number, drawn: number, _type: number, bytes: number) =>
      ranges.push([bytes / Uint16Array.BYTES_PER_ELEMENT, drawn]),
  };
  const renderer = { getContext: () => gl } as unknown as WebGLRenderer;
  const { geometry, material } = mesh;
  mesh.onAfterRender(renderer, new Scene(), new PerspectiveCamera(), geometry, material, new Group());
  return ranges;
}

/** The cells that each level draws around the eye, as "x z" in its own spacing. */
function drawnCells(ground: Ground): ReadonlySet<string>[] {
  ground.place(new Float64Array(3), createCone());
  const index = ground.mesh.geometry.index!.array;
  const places = ground.mesh.material.uniforms['levelPlaces']!.value as Float32Array;
  const levels = Array.from({ length: MAX_LEVELS }, () => new Set<string>());
  for (const [start, count] of drawnRanges(ground)) {
    const n = Math.floor(index[start]! / (VERTICES * VERTICES));
    const firstVertex = n * VERTICES * VERTICES;
    const spacing = FINEST * 2 ** n;
    const [cornerX, cornerZ] = [places[3 * n]!, places[3 * n + 2]!].map(
      (at) => Math.round(at / spacing) - CELLS / 2,
    );
    for (let at = start; at < start + count; at += 3) {
      const vertex = Math.min(index[at]!, index[at + 1]!, index[at + 2]!) - firstVertex;
      // A cell's second triangle begins one vertex further along.
      const first = (at - start) % 6 === 0 ? vertex : vertex - 1;
      levels[n]!.add(`${cornerX! + (first % VERTICES)} ${cornerZ! + Math.floor(first / VERTICES)}`);
    }
  }
  return levels;
}

/** How many levels draw the ground at each of a few hundred places up to `reach` m around (x, z). */
function layersAround(ground: Ground, x: number, z: number, reach: number): number[] {
  const levels = drawnCells(ground);
  return Array.from({ length: 400 }, (_, n) => {
    // Uniform in angle and in the logarithm of the distance: as many near the ship as far away.
    const away = 0.3 * (reach / 0.3) ** ((n % 20) / 20);
    const angle = 2 * Math.PI * ((n * 0.618) % 1);
    const [px, pz] = [x + away * Math.cos(angle), z + away * Math.sin(angle)];
    return levels.filter((cells, level) => {
      const spacing = FINEST * 2 ** level;
      return cells.has(`${Math.floor(px / spacing)} ${Math.floor(pz / spacing)}`);
    }).length;
  });
}

describe('drawn ground around the ship', () => {
  it.each(ALL.map((scenario) => [scenario.name, scenario] as const))(
    'has no gap in the first frame of %s',
    (_, scenario) => {
      const ground = groundOf(scenario);
      ground.follow(0, 0, Infinity);
      const layers = layersAround(ground, 0, 0, 3000);
      expect(layers.every((count) => count === 1)).toBe(true);
      ground.dispose();
    },
  );

  it('has no gap and full detail at once after a teleport', () => {
    const ground = groundOf(SCENARIOS[0]!);
    ground.follow(0, 0, Infinity);
    ground.follow(1234, -2345, 2);
    expect(new Set(layersAround(ground, 1234, -2345, 3000))).toEqual(new Set([1]));
    const finest = drawnCells(ground)[0]!;
    expect(finest.has(`${Math.floor(1234 / FINEST)} ${Math.floor(-2345 / FINEST)}`)).toBe(true);
    ground.dispose();
  });

  it('has no gap under a flying ship when two levels move per frame', () => {
    const ground = groundOf(SCENARIOS[0]!);
    ground.follow(0, 0, Infinity);
    for (let n = 1; n <= 60; n++) {
      ground.follow(3 * n, -2 * n, 2);
      if (n % 10 === 0) expect(new Set(layersAround(ground, 3 * n, -2 * n, 1500))).toEqual(new Set([1]));
    }
    ground.dispose();
  });
});
