import { BufferAttribute, BufferGeometry, Euler, Matrix4, Quaternion, Vector3 } from 'three';
import { coarsen, type Coarseness } from '../../ground/coarsen';

/** The material of a part of a ship. */
export interface Finish {
  /** Linear RGB. */
  readonly colour: readonly [number, number, number];
  readonly roughness: number;
  readonly metalness: number;
  /** Light of its own, as a share of its colour. */
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

/** Where a part stands in body axes (m; +Z up): its own z axis is turned to `along`, then it is shifted to `at`. */
export interface Placement {
  readonly at: readonly [number, number, number];
  readonly along?: readonly [number, number, number];
  /** rad about its own z before that. */
  readonly spin?: number;
  readonly scale?: readonly [number, number, number];
  readonly flex?: Flex;
}

/** How a part follows foot `leg` upward when the leg takes up a touch: the share at the part's low and high end of its own z. */
export interface Flex {
  readonly leg: number;
  readonly low: number;
  readonly high: number;
}

/** A model's geometries: full, and with decreasing detail for distant ships. */
export interface ShipGeometries {
  readonly geometry: BufferGeometry;
  /** Made when first asked for: most flights never show a ship from far away. */
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
  const whole = createHeap();
  let parts: Part[] = [];
  let made: readonly BufferGeometry[] | null = null;
  const coarser = () => {
    made ??= COARSER.map((coarseness) => coarseGeometry(parts, coarseness));
    parts = [];
    return made;
  };
  return {
    add(geometry, finish, placement) {
      parts.push({ geometry, finish, placement });
      pushPart(whole, geometry, finish, placement);
    },
    build: () => ({ geometry: geometryOf(whole), coarser }),
  };
}

interface Part {
  readonly geometry: BufferGeometry;
  readonly finish: Finish;
  readonly placement: Placement;
}

function coarseGeometry(parts: readonly Part[], coarseness: Coarseness): BufferGeometry {
  const heap = createHeap();
  for (const { geometry, finish, placement } of parts) {
    const coarse = coarsen(geometry, coarseness);
    if (coarse !== null) pushPart(heap, coarse, finish, placement);
  }
  return geometryOf(heap);
}

/** Attributes of all vertices so far, three to a triangle. */
interface Heap {
  readonly positions: number[];
  readonly normals: number[];
  readonly colours: number[];
  readonly surfaces: number[];
  readonly flexes: number[];
}

function createHeap(): Heap {
  return { positions: [], normals: [], colours: [], surfaces: [], flexes: [] };
}

function pushPart(out: Heap, given: BufferGeometry, finish: Finish, placement: Placement): void {
  const geometry = given.index === null ? given.clone() : given.toNonIndexed();
  pushFlex(out.flexes, geometry, placement.flex);
  // Otherwise three.js computes the bounds again, which took half of the time of building a ship.
  geometry.boundingBox = null;
  geometry.applyMatrix4(matrixOf(placement));
  const { array: positions, count } = geometry.getAttribute('position');
  const { array: normals } = geometry.getAttribute('normal');
  const [red, green, blue] = finish.colour;
  for (let i = 0; i < 3 * count; i++) {
    out.positions.push(positions[i]!);
    out.normals.push(normals[i]!);
  }
  for (let i = 0; i < count; i++) {
    out.colours.push(red, green, blue);
    out.surfaces.push(finish.roughness, finish.metalness, finish.glow ?? 0);
  }
  geometry.dispose();
  given.dispose();
}

function geometryOf(heap: Heap): BufferGeometry {
  const geometry = new BufferGeometry();
  const attribute = (values: number[]) => new BufferAttribute(new Float32Array(values), 3);
  geometry.setAttribute('position', attribute(heap.positions));
  geometry.setAttribute('normal', attribute(heap.normals));
  geometry.setAttribute('color', attribute(heap.colours));
  geometry.setAttribute('surface', attribute(heap.surfaces));
  geometry.setAttribute('flex', new BufferAttribute(new Float32Array(heap.flexes), 2));
  geometry.computeBoundingSphere();
  return geometry;
}

/** Leg and share of each vertex, linear along the part's own z. */
function pushFlex(out: number[], geometry: BufferGeometry, flex: Flex | undefined): void {
  const position = geometry.getAttribute('position');
  if (flex === undefined) {
    for (let i = 0; i < position.count; i++) out.push(0, 0);
    return;
  }
  geometry.computeBoundingBox();
  const { min, max } = geometry.boundingBox!;
  for (let i = 0; i < position.count; i++) {
    const along = (position.getZ(i) - min.z) / (max.z - min.z);
    out.push(flex.leg, flex.low + (flex.high - flex.low) * along);
  }
}

function matrixOf({ at, along, spin, scale }: Placement): Matrix4 {
  const turn = new Quaternion();
  if (along !== undefined) turn.setFromUnitVectors(Z, new Vector3(...along).normalize());
  if (spin !== undefined) turn.multiply(new Quaternion().setFromEuler(new Euler(0, 0, spin)));
  return new Matrix4().compose(new Vector3(...at), turn, new Vector3(...(scale ?? [1, 1, 1])));
}
