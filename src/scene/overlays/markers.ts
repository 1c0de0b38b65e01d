import {
  BufferAttribute,
  BufferGeometry,
  CylinderGeometry,
  DoubleSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  SphereGeometry,
} from 'three';
import { type LocalFrame, rotate, toLocalPoint, type Turn } from '../localFrame';

/** What stands on the ground for the pilot: pads with their beacons, and where the ship will touch. */
export interface Markers {
  /** Body axes, m from the body's centre; the next one shines. */
  pads: readonly { readonly place: ArrayLike<number>; readonly radius: number; readonly isNext: boolean }[];
  /** Relative to the body's centre, ICRF axes, m; null: none is predicted. */
  touch: Float64Array | null;
}

export interface MarkerPlaces {
  readonly frame: LocalFrame;
  readonly turn: Turn;
  readonly eye: Float64Array;
  /** Local height of the ground, m. */
  readonly groundY: (x: number, z: number) => number;
}

export interface MarkerGroup {
  readonly group: Group;
  readonly place: (markers: Markers, places: MarkerPlaces) => void;
  readonly dispose: () => void;
}

const SEGMENTS = 64;
/** m: width of a pad's ring, and its height over the ground it follows. */
const RING_WIDTH = 0.9;
const LIFT = 0.2;
const MAST = 7;
const COLUMN = 90;
const NEXT = 0x7fe4ff;
const REST = 0x8a98a6;
const TOUCH = 0xffd24a;

export function createMarkers(): MarkerGroup {
  const group = new Group();
  const next = flat(NEXT, 0.95);
  const rest = flat(REST, 0.7);
  const glow = flat(NEXT, 0.16);
  const amber = flat(TOUCH, 0.9);
  const mast = new CylinderGeometry(0.12, 0.2, MAST, 8);
  const lamp = new SphereGeometry(0.55, 12, 8);
  const column = new CylinderGeometry(0.35, 0.9, COLUMN, 12, 1, true);
  const touch = new Mesh(new BufferGeometry(), amber);
  const local = new Float64Array(3);
  let built: Markers['pads'] = [];
  let frame: LocalFrame | null = null;
  let pads: { readonly group: Group; readonly at: Float64Array }[] = [];
  group.add(touch);

  const clear = () => {
    for (const pad of pads) {
      pad.group.traverse((part) => {
        if (part instanceof Mesh && part.name === 'ring') (part.geometry as BufferGeometry).dispose();
      });
      group.remove(pad.group);
    }
    pads = [];
  };
  const build = (markers: Markers, places: MarkerPlaces) => {
    clear();
    built = markers.pads;
    frame = places.frame;
    pads = built.map(({ place, radius, isNext }) => {
      const at = new Float64Array(3);
      rotate(at, places.frame.axes, place);
      at[1] = places.groundY(at[0]!, at[2]!);
      const pad = new Group();
      const ring = new Mesh(ringOnGround(at, radius, RING_WIDTH, places.groundY), isNext ? next : rest);
      ring.name = 'ring';
      const pole = new Mesh(mast, isNext ? next : rest);
      // Beside the pad: it is no mast to land on.
      pole.position.set(radius, MAST / 2, 0);
      const light = new Mesh(lamp, isNext ? next : rest);
      light.position.set(radius, MAST, 0);
      pad.add(ring, pole, light);
      if (isNext) {
        const beam = new Mesh(column, glow);
        beam.position.set(radius, COLUMN / 2, 0);
        pad.add(beam);
      }
      group.add(pad);
      return { group: pad, at };
    });
  };

  return {
    group,
    place(markers, places) {
      if (markers.pads !== built || places.frame !== frame) build(markers, places);
      for (const pad of pads) subtract(pad.group, pad.at, places.eye);
      touch.visible = markers.touch !== null;
      if (markers.touch === null) return;
      toLocalPoint(local, places.frame, places.turn, markers.touch);
      local[1] = places.groundY(local[0]!, local[2]!);
      touch.geometry.dispose();
      touch.geometry = ringOnGround(local, 3.4, 0.5, places.groundY, 24);
      subtract(touch, local, places.eye);
    },
    dispose() {
      clear();
      for (const each of [next, rest, glow, amber, mast, lamp, column, touch.geometry]) each.dispose();
    },
  };
}

function flat(color: number, opacity: number): MeshBasicMaterial {
  return new MeshBasicMaterial({
    color,
    opacity,
    transparent: true,
    side: DoubleSide,
    depthWrite: false,
    toneMapped: false,
  });
}

function subtract(part: Group | Mesh, at: Float64Array, eye: Float64Array): void {
  part.position.set(at[0]! - eye[0]!, at[1]! - eye[1]!, at[2]! - eye[2]!);
}

/** A ring around a place that follows the ground, relative to the place. */
function ringOnGround(
  at: Float64Array,
  radius: number,
  width: number,
  groundY: (x: number, z: number) => number,
  segments = SEGMENTS,
): BufferGeometry {
  const points = new Float32Array((segments + 1) * 6);
  const index: number[] = [];
  for (let i = 0; i <= segments; i++) {
    const angle = (2 * Math.PI * i) / segments;
    [radius - width, radius].forEach((r, side) => {
      const x = r * Math.cos(angle);
      const z = r * Math.sin(angle);
      points.set([x, groundY(at[0]! + x, at[2]! + z) - at[1]! + LIFT, z], 6 * i + 3 * side);
    });
    if (i < segments) index.push(2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 1, 2 * i + 3, 2 * i + 2);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(points, 3));
  geometry.setIndex(index);
  return geometry;
}
