import { Mesh, ShaderMaterial, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { LESSONS, loadScenario, MISSIONS, type Scenario, SCENARIOS } from '../../src/scenarios';
import { createCone } from '../../src/scene/camera/viewCone';
import { createGround, type Ground } from '../../src/scene/ground/ground';
import { CELLS, VERTICES } from '../../src/scene/ground/terrainLevel';
import { createLocalFrame, toBodyAxes } from '../../src/scene/localFrame';
import { lookOf } from '../../src/scene/sky/bodyLook';

const ALL: readonly Scenario[] = [
  ...SCENARIOS,
  ...MISSIONS.map(({ scenario }) => scenario),
  ...LESSONS.map(({ scenario }) => scenario),
];
/** m: as in ground.ts. */
const FINEST = 0.4;

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

/** The cells that each level draws around the eye, as "x z" in its own spacing. */
function drawnCells(ground: Ground): ReadonlySet<string>[] {
  const everywhere = createCone();
  ground.place(new Float64Array(3), everywhere);
  return ground.group.children.map((child, n) => {
    if (!(child instanceof Mesh)) throw new Error('a level is no mesh');
    const { geometry, matrixWorld } = child as Mesh;
    const position = new Vector3().setFromMatrixPosition(matrixWorld);
    const spacing = FINEST * 2 ** n;
    const [cornerX, cornerZ] = [position.x, position.z].map((at) => Math.round(at / spacing) - CELLS / 2);
    const index = geometry.index!.array;
    const { start, count } = geometry.drawRange;
    const cells = new Set<string>();
    for (let at = start; at < start + count; at += 3) {
      const vertex = Math.min(index[at]!, index[at + 1]!, index[at + 2]!);
      // A cell's second triangle begins one vertex further along.
      const first = (at - start) % 6 === 0 ? vertex : vertex - 1;
      cells.add(`${cornerX! + (first % VERTICES)} ${cornerZ! + Math.floor(first / VERTICES)}`);
    }
    return cells;
  });
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
