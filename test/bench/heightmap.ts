import { type Heightmap, heightmapTerrain, type TerrainHeight } from '../../src/dynamics';
import { type Figure, heapGrowth, timed } from './measure';

const TIMES = 100_000;
/** The game's Luna: 16 samples per degree. */
const COLUMNS = 5760;
const ROWS = 2880;

/** Look-ups at mid latitude along a track, one metre apart, and their heap allocation. */
export function heightmapFigures(): Figure[] {
  const samples = Int16Array.from({ length: ROWS * COLUMNS }, (_, i) => Math.imul(i, 0x9e3779b1) >> 18);
  return (['bilinear', 'bicubic'] as const).flatMap((interpolation) => {
    const map = {
      samples,
      rows: ROWS,
      columns: COLUMNS,
      scale: 0.5,
      referenceRadius: 1737400,
      interpolation,
    };
    const terrain = terrainOf(map);
    const look = (times: number) => lookUp(terrain, times);
    return [
      timed(`heightmap-${interpolation}`, TIMES, 1, look),
      heapGrowth(`heap-${interpolation}`, 1_000_000, look),
    ];
  });
}

/** Direction and height of a look-up, as in the substep. */
const point = new Float64Array(4);

function lookUp(terrain: TerrainHeight, times: number): void {
  const step = 1 / 1737400;
  for (let i = 0; i < times; i++) {
    const nx = 0.6 + i * step;
    const length = Math.sqrt(nx * nx + 0.64);
    point[0] = nx / length;
    point[1] = 0.48 / length;
    point[2] = 0.64 / length;
    terrain.inPlace!(point, 'Luna');
  }
}

function terrainOf(map: Heightmap): TerrainHeight {
  const terrain = heightmapTerrain({ Luna: map });
  if (!terrain.ok) throw new Error(terrain.reason);
  return terrain.value;
}
