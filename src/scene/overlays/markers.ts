import { CylinderGeometry, DoubleSide, Group, Mesh, MeshBasicMaterial, SphereGeometry } from 'three';
import { type LocalFrame, rotate, toLocalPoint, type Turn } from '../localFrame';
import { createGroundRing } from './ringOnGround';

/** Marks on the ground for the pilot: pads with their beacons, and the predicted touch. */
export interface Markers {
  /** Body axes, m from the body's centre; the next pad shines. */
  pads: readonly { readonly place: ArrayLike<number>; readonly radius: number; readonly isNext: boolean }[];
  /** Relative to the body's centre, ICRF axes, m; null: no touch is predicted. */
  touch: Float64Array | null;
}

export interface MarkerPlaces {
  readonly frame: LocalFrame;
  readonly turn: Turn;
  /** Local, m. */
  readonly eye: Float64Array;
  /** Local height of the ground, m. */
  readonly groundY: (x: number, z: number) => number;
}

export interface MarkerGroup {
  readonly group: Group;
  readonly place: (markers: Markers, places: MarkerPlaces) => void;
  readonly dispose: () => void;
}

const PAD_SEGMENTS = 64;
const TOUCH_SEGMENTS = 24;
/** m. */
const PAD_RING_WIDTH = 0.9;
const TOUCH_RADIUS = 3.4;
const TOUCH_RING_WIDTH = 0.5;
const MAST_HEIGHT = 7;
const BEAM_HEIGHT = 90;
/** m: a predicted touch that moves by less stays where it is drawn. */
const TOUCH_STEP = 0.1;
const NEXT = 0x7fe4ff;
const REST = 0x8a98a6;
const TOUCH = 0xffd24a;

export function createMarkers(): MarkerGroup {
  const group = new Group();
  const pads = createPads(group);
  const touch = createTouchMark();
  group.add(touch.mesh);
  return {
    group,
    place(markers, places) {
      pads.place(markers.pads, places);
      touch.place(markers.touch, places);
    },
    dispose() {
      pads.dispose();
      touch.dispose();
    },
  };
}

interface Pad {
  readonly group: Group;
  readonly ring: Mesh;
  /** Local, m. */
  readonly at: Float64Array;
}

function createPads(parent: Group) {
  const materials = { next: flat(NEXT, 0.95), rest: flat(REST, 0.7), glow: flat(NEXT, 0.16) };
  const mast = new CylinderGeometry(0.12, 0.2, MAST_HEIGHT, 8);
  const lamp = new SphereGeometry(0.55, 12, 8);
  const beam = new CylinderGeometry(0.35, 0.9, BEAM_HEIGHT, 12, 1, true);
  let built: Markers['pads'] = [];
  let frame: LocalFrame | null = null;
  let pads: Pad[] = [];

  const clear = () => {
    for (const pad of pads) {
      pad.ring.geometry.dispose();
      parent.remove(pad.group);
    }
    pads = [];
  };
  const build = ({ place, radius, isNext }: Markers['pads'][number], places: MarkerPlaces): Pad => {
    const at = new Float64Array(3);
    rotate(at, places.frame.axes, place);
    at[1] = places.groundY(at[0]!, at[2]!);
    const outline = createGroundRing(radius, PAD_RING_WIDTH, PAD_SEGMENTS);
    outline.fit(at, places.groundY);
    const group = new Group();
    const add = (mesh: Mesh, y: number) => {
      // Beside the pad, so that nobody lands on the mast.
      mesh.position.set(radius, y, 0);
      group.add(mesh);
    };
    const material = isNext ? materials.next : materials.rest;
    const ring = new Mesh(outline.geometry, material);
    group.add(ring);
    add(new Mesh(mast, material), MAST_HEIGHT / 2);
    add(new Mesh(lamp, material), MAST_HEIGHT);
    if (isNext) add(new Mesh(beam, materials.glow), BEAM_HEIGHT / 2);
    parent.add(group);
    return { group, ring, at };
  };
  return {
    place(wanted: Markers['pads'], places: MarkerPlaces) {
      if (wanted !== built || places.frame !== frame) {
        clear();
        built = wanted;
        frame = places.frame;
        pads = wanted.map((pad) => build(pad, places));
      }
      for (const pad of pads) subtract(pad.group, pad.at, places.eye);
    },
    dispose() {
      clear();
      for (const each of [...Object.values(materials), mast, lamp, beam]) each.dispose();
    },
  };
}

function createTouchMark() {
  const ring = createGroundRing(TOUCH_RADIUS, TOUCH_RING_WIDTH, TOUCH_SEGMENTS);
  const material = flat(TOUCH, 0.9);
  const mesh = new Mesh(ring.geometry, material);
  mesh.frustumCulled = false;
  const local = new Float64Array(3);
  const fitted = new Float64Array(3);
  let fittedIn: LocalFrame | null = null;
  return {
    mesh,
    place(touch: Float64Array | null, { frame, turn, eye, groundY }: MarkerPlaces) {
      mesh.visible = touch !== null;
      if (touch === null) return;
      toLocalPoint(local, frame, turn, touch);
      const moved = Math.hypot(local[0]! - fitted[0]!, local[2]! - fitted[2]!);
      if (fittedIn !== frame || moved > TOUCH_STEP) {
        fittedIn = frame;
        fitted[0] = local[0]!;
        fitted[1] = groundY(local[0]!, local[2]!);
        fitted[2] = local[2]!;
        ring.fit(fitted, groundY);
      }
      subtract(mesh, fitted, eye);
    },
    dispose() {
      ring.geometry.dispose();
      material.dispose();
    },
  };
}

function flat(color: number, opacity: number): MeshBasicMaterial {
  return new MeshBasicMaterial({
    color,
    opacity,
    transparent: true,
    side: DoubleSide,
    // Both sides have one colour: three's second pass would show the same, and prepares the program again twice per frame.
    forceSinglePass: true,
    depthWrite: false,
    toneMapped: false,
  });
}

function subtract(part: Group | Mesh, at: Float64Array, eye: Float64Array): void {
  part.position.set(at[0]! - eye[0]!, at[1]! - eye[1]!, at[2]! - eye[2]!);
}
