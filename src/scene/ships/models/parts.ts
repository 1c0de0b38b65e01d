import { BufferAttribute, BufferGeometry, Euler, Matrix3, Matrix4, Quaternion, Sphere, Vector3 } from 'three';
import { coarsen, type Coarseness } from '../../ground/coarsen';

/** The material of a part of a ship. */
export interface Finish {
  /** Linear RGB. */
  readonly colour: readonly [number, number, number];
  readonly roughness: number;
  readonly metalness: number;
  /** Emitted light, as a share of its colour. */
  readonly glow?: number;
}

export const FINISHES = {
  white: { colour: [0.72, 0.72, 0.7], roughness: 0.55, metalness: 0.05 },
  grey: { colour: [0.3, 0.31, 0.33], roughness: 0.5, metalness: 0.35 },
  dark: { colour: [0.055, 0.057, 0.062], roughness: 0.6, metalness: 0.3 },
  foil: { colour: [0.85, 0.52, 0.16], roughness: 0.32, metalness: 0.55 },
  silver: { colour: [0.62, 0.63, 0.65], roughness: 0.3, metalness: 0.6 },
  bell: { colour: [0.16, 0.14, 0.13], roughness: 0.35, metalness: 0.7 },
  glass: { colour: [0.02, 0.035, 0.05], roughness: 0.08, metalness: 0.4 },
  orange: { colour: [0.75, 0.2, 0.03], roughness: 0.5, metalness: 0 },
  blue: { colour: [0.06, 0.17, 0.36], roughness: 0.5, metalness: 0.1 },
  teal: { colour: [0.05, 0.25, 0.25], roughness: 0.55, metalness: 0.1 },
  red: { colour: [0.5, 0.06, 0.03], roughness: 0.5, metalness: 0.05 },
  sand: { colour: [0.52, 0.44, 0.31], roughness: 0.6, metalness: 0.05 },
  lamp: { colour: [1, 0.86, 0.6], roughness: 0.5, metalness: 0, glow: 2.5 },
  port: { colour: [1, 0.05, 0.02], roughness: 0.5, metalness: 0, glow: 3 },
  starboard: { colour: [0.03, 1, 0.15], roughness: 0.5, metalness: 0, glow: 3 },
} as const satisfies Record<string, Finish>;

/** A part's place in body axes (m; +Z up): its z axis is turned to `along`, then it is shifted to `at`. */
export interface Placement {
  readonly at: readonly [number, number, number];
  readonly along?: readonly [number, number, number];
  /** rad about its z axis, before that. */
  readonly spin?: number;
  readonly scale?: readonly [number, number, number];
  readonly flex?: Flex;
}

/** How a part follows foot `leg` upward when the leg takes up a touch: the share at the low and the high end of the part's z axis. */
export interface Flex {
  readonly leg: number;
  readonly low: number;
  readonly high: number;
}

/** A model's geometries: full, and with decreasing detail for distant ships. */
export interface ShipGeometries {
  readonly geometry: BufferGeometry;
  /** Made on first use: most flights never show a ship from far away. */
  readonly coarser: () => readonly BufferGeometry[];
}

/** Collects parts into one geometry: a ship is one draw call instead of a hundred. */
export interface Parts {
  /** Adds a geometry whose axis is z. */
  add(geometry: BufferGeometry, finish: Finish, placement: Placement): void;
  build(): ShipGeometries;
}

/** For ships of a hundred pixels, and for those of some tens. */
const COARSER: readonly Coarseness[] = [
  { sides: 7, smallest: 0.5 },
  { sides: 4, smallest: 1 },
];

const Z = new Vector3(0, 0, 1);

export function createParts(): Parts {
  let parts: Part[] = [];
  let made: readonly BufferGeometry[] | null = null;
  const coarser = () => {
    made ??= COARSER.map((coarseness) => geometryOf(coarsened(parts, coarseness)));
    parts = [];
    return made;
  };
  return {
    add(geometry, finish, placement) {
      parts.push({ geometry, finish, placement });
    },
    build: () => ({ geometry: geometryOf(parts), coarser }),
  };
}

interface Part {
  readonly geometry: BufferGeometry;
  readonly finish: Finish;
  readonly placement: Placement;
}

function coarsened(parts: readonly Part[], coarseness: Coarseness): Part[] {
  return parts.flatMap((part) => {
    const geometry = coarsen(part.geometry, coarseness);
    return geometry === null ? [] : [{ ...part, geometry }];
  });
}

/** Attributes of all corners, three per triangle: two numbers per corner in `flexes`, three in the others. */
interface Corners {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly colours: Float32Array;
  readonly surfaces: Float32Array;
  readonly flexes: Float32Array;
}

function geometryOf(parts: readonly Part[]): BufferGeometry {
  const total = parts.reduce((sum, { geometry }) => sum + cornerCount(geometry), 0);
  const corners: Corners = {
    positions: new Float32Array(3 * total),
    normals: new Float32Array(3 * total),
    colours: new Float32Array(3 * total),
    surfaces: new Float32Array(3 * total),
    flexes: new Float32Array(2 * total),
  };
  let first = 0;
  const placed = parts.map((part) => {
    const positions = writePart(corners, first, part);
    first += cornerCount(part.geometry);
    return positions;
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(corners.positions, 3));
  geometry.setAttribute('normal', new BufferAttribute(corners.normals, 3));
  geometry.setAttribute('color', new BufferAttribute(corners.colours, 3));
  geometry.setAttribute('surface', new BufferAttribute(corners.surfaces, 3));
  geometry.setAttribute('flex', new BufferAttribute(corners.flexes, 2));
  geometry.boundingSphere = sphereAround(placed);
  return geometry;
}

function cornerCount(geometry: BufferGeometry): number {
  return (geometry.index ?? geometry.getAttribute('position')).count;
}

/** Each vertex is placed once, and then copied to the corners of its triangles. Returns the placed vertices. */
function writePart(out: Corners, first: number, { geometry, finish, placement }: Part): Numbers {
  const matrix = matrixOf(placement);
  const position = geometry.getAttribute('position') as BufferAttribute;
  const normal = geometry.getAttribute('normal') as BufferAttribute;
  const turn = new Matrix3().getNormalMatrix(matrix);
  const count = cornerCount(geometry);
  const vertices = geometry.index?.array ?? null;
  const placed = position.clone().applyMatrix4(matrix).array;
  copyCorners(out.positions, first, placed, vertices);
  copyCorners(out.normals, first, normal.clone().applyNormalMatrix(turn).array, vertices);
  fillCorners(out.colours, first, count, finish.colour);
  fillCorners(out.surfaces, first, count, [finish.roughness, finish.metalness, finish.glow ?? 0]);
  if (placement.flex === undefined) return placed;
  const shares = flexShares(position, placement.flex);
  for (let n = 0; n < count; n++) {
    out.flexes[2 * (first + n)] = placement.flex.leg;
    out.flexes[2 * (first + n) + 1] = shares[vertices === null ? n : vertices[n]!]!;
  }
  return placed;
}

type Numbers = ArrayLike<number>;

/** Three numbers of each vertex; without `vertices` all of them, in order. */
function copyCorners(out: Float32Array, first: number, from: Numbers, vertices: Numbers | null): void {
  const count = vertices === null ? from.length / 3 : vertices.length;
  for (let n = 0, to = 3 * first; n < count; n++, to += 3) {
    const at = 3 * (vertices === null ? n : vertices[n]!);
    out[to] = from[at]!;
    out[to + 1] = from[at + 1]!;
    out[to + 2] = from[at + 2]!;
  }
}

function fillCorners(out: Float32Array, first: number, count: number, three: Numbers): void {
  const [x, y, z] = [three[0]!, three[1]!, three[2]!];
  const end = 3 * (first + count);
  for (let to = 3 * first; to < end; to += 3) {
    out[to] = x;
    out[to + 1] = y;
    out[to + 2] = z;
  }
}

/** As three.js computes it, which takes many times as long: the middle of the box around all vertices, out to the farthest. */
function sphereAround(parts: readonly Numbers[]): Sphere {
  const middle = [0, 1, 2].map((axis) => {
    let low = Infinity;
    let high = -Infinity;
    for (const vertices of parts) {
      for (let at = axis; at < vertices.length; at += 3) {
        const value = vertices[at]!;
        if (value < low) low = value;
        if (value > high) high = value;
      }
    }
    return (low + high) * 0.5;
  });
  const [x, y, z] = [middle[0]!, middle[1]!, middle[2]!];
  let farthest = 0;
  for (const vertices of parts) {
    for (let at = 0; at < vertices.length; at += 3) {
      const dx = x - vertices[at]!;
      const dy = y - vertices[at + 1]!;
      const dz = z - vertices[at + 2]!;
      const square = dx * dx + dy * dy + dz * dz;
      if (square > farthest) farthest = square;
    }
  }
  return new Sphere(new Vector3(x, y, z), Math.sqrt(farthest));
}

/** The leg's share of each vertex, linear along the part's z axis. */
function flexShares(position: BufferAttribute, { low, high }: Flex): Float64Array {
  const along = Float64Array.from({ length: position.count }, (_, n) => position.getZ(n));
  const [from, to] = [Math.min(...along), Math.max(...along)];
  return along.map((z) => low + (high - low) * ((z - from) / (to - from)));
}

function matrixOf({ at, along, spin, scale }: Placement): Matrix4 {
  const turn = new Quaternion();
  if (along !== undefined) turn.setFromUnitVectors(Z, new Vector3(...along).normalize());
  if (spin !== undefined) turn.multiply(new Quaternion().setFromEuler(new Euler(0, 0, spin)));
  return new Matrix4().compose(new Vector3(...at), turn, new Vector3(...(scale ?? [1, 1, 1])));
}
