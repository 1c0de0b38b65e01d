import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Mesh, type ShaderMaterial } from 'three';
import { createSectors, type GroundSectors, type IndexRange, SECTOR_INDICES } from './groundSectors';
import { type DrawnPoints, MAX_LEVELS, VERTICES } from './levels';
import { uploadItems } from '../uploads';

/**
 * All levels of the ground in one mesh. three prepares program, uniforms and buffers once per frame, and each level in sight costs
 * one more draw call. As separate meshes they took 7 % more of a frame’s script.
 */
export interface GroundMesh {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  /** The drawn arrays of level n, and its triangles. */
  readonly points: readonly DrawnPoints[];
  readonly sectors: readonly GroundSectors[];
  /** Sends level n's points, or its triangles, to the GPU at the next draw. */
  uploadPoints(n: number): void;
  uploadSectors(n: number): void;
  /** Begins a frame without levels. */
  clear(): void;
  /** Draws a range of level n's triangles with its origin at (x, y, z) from the eye, m. */
  show(n: number, range: IndexRange, x: number, y: number, z: number): void;
  dispose(): void;
}

const POINTS = VERTICES * VERTICES;

export function createGroundMesh(material: ShaderMaterial): GroundMesh {
  const places = new Float32Array(MAX_LEVELS * 3);
  material.uniforms['levelPlaces'] = { value: places };
  const geometry = new BufferGeometry();
  const attribute = (name: string, size: number) => {
    const made = new BufferAttribute(new Float32Array(MAX_LEVELS * POINTS * size), size);
    geometry.setAttribute(name, made.setUsage(DynamicDrawUsage));
    return { made, ofLevel: levels((n) => made.array.subarray(n * POINTS * size, (n + 1) * POINTS * size)) };
  };
  const attributes = [attribute('position', 3), attribute('normal', 3), attribute('sunlit', 1)] as const;
  const [positions, normals, sunlit] = attributes.map(({ ofLevel }) => ofLevel as Float32Array[]);
  const index = new BufferAttribute(new Uint16Array(MAX_LEVELS * SECTOR_INDICES), 1);
  geometry.setIndex(index.setUsage(DynamicDrawUsage));
  const mesh = new Mesh(geometry, material);
  mesh.receiveShadow = true;
  mesh.frustumCulled = false;
  mesh.matrixAutoUpdate = false;
  const shown = createRanges();

  // three draws the first range, the others follow while its program and buffers are bound.
  mesh.onAfterRender = (renderer) => {
    const gl = renderer.getContext();
    for (let k = 1; k < shown.count; k++)
      gl.drawElements(gl.TRIANGLES, shown.counts[k]!, gl.UNSIGNED_SHORT, 2 * shown.starts[k]!);
  };

  return {
    mesh,
    points: levels((n) => ({ positions: positions![n]!, normals: normals![n]!, sunlit: sunlit![n]! })),
    sectors: levels((n) =>
      createSectors(
        index.array.subarray(n * SECTOR_INDICES, (n + 1) * SECTOR_INDICES) as Uint16Array,
        n * POINTS,
      ),
    ),
    uploadPoints(n) {
      for (const { made } of attributes) uploadItems(made, n * POINTS, POINTS);
    },
    uploadSectors(n) {
      uploadItems(index, n * SECTOR_INDICES, SECTOR_INDICES);
    },
    clear() {
      shown.count = 0;
      mesh.visible = false;
    },
    show(n, { start, count }, x, y, z) {
      const first = n * SECTOR_INDICES + start;
      if (shown.count === 0) geometry.setDrawRange(first, count);
      mesh.visible = true;
      shown.starts[shown.count] = first;
      shown.counts[shown.count++] = count;
      places[3 * n] = x;
      places[3 * n + 1] = y;
      places[3 * n + 2] = z;
    },
    dispose: () => geometry.dispose(),
  };
}

function levels<T>(of: (n: number) => T): T[] {
  return Array.from({ length: MAX_LEVELS }, (_, n) => of(n));
}

/** Ranges of the index that are drawn in this frame. */
function createRanges() {
  return { starts: new Uint32Array(MAX_LEVELS), counts: new Uint32Array(MAX_LEVELS), count: 0 };
}
