import type { Quaternion } from 'three';
import {
  type BufferGeometry,
  Color,
  ConeGeometry,
  CylinderGeometry,
  Group,
  type Material,
  Mesh,
  MeshBasicMaterial,
  TorusGeometry,
  Vector3,
} from 'three';
import { createGhost } from './ghost';

/** The overlays that are shown. */
export interface OverlayChoice {
  ghost: boolean;
  errorSegment: boolean;
  contactNormal: boolean;
  footprint: boolean;
  forces: boolean;
}

/** Vectors and places in local axes relative to the eye, m. */
export interface OverlayPlaces {
  readonly ship: Vector3;
  readonly ghost: Vector3;
  readonly ghostTurn: Quaternion;
  readonly ghostKnown: boolean;
  /** From the drawn to the predicted position at the same instant; zero unless a correction is being eased. */
  readonly error: Vector3;
  /** On the ground straight below the ship. */
  readonly foot: Vector3;
  /** On the ground, the centre of the landing legs' circle. */
  readonly footprint: Vector3;
  /** The surface normal, unit: local up, or the slope's where the settings have it so. */
  readonly ground: Vector3;
  /** Local up, unit. */
  readonly up: Vector3;
  readonly legRadius: number;
  /** m/s², in local axes: accelerations by thrust, weight and ground. */
  readonly thrust: Vector3;
  readonly weight: Vector3;
  readonly support: Vector3;
}

export interface Overlays {
  readonly group: Group;
  setGhostHull(hull: BufferGeometry): void;
  update(choice: OverlayChoice, places: OverlayPlaces): void;
  dispose(): void;
}

const Z = new Vector3(0, 0, 1);
/** 0xrrggbb, for the picture and its legend. */
export const OVERLAY_COLOURS = {
  ghost: 0x58b8ff,
  error: 0xff5a4f,
  normal: 0x7fe0ff,
  footprint: 0xffd24a,
  thrust: 0xffa040,
  weight: 0xc88cff,
  support: 0x7dff9a,
} as const;

/** Length of an arrow per acceleration, m per m/s². */
const SCALE = 1.6;

export function createOverlays(): Overlays {
  const group = new Group();
  const materials: Material[] = [];
  const paint = (colour: number) => {
    const material = new MeshBasicMaterial({ color: new Color(colour), depthTest: false, transparent: true });
    materials.push(material);
    return material;
  };
  const shaft = new CylinderGeometry(0.05, 0.05, 1, 8).rotateX(Math.PI / 2).translate(0, 0, 0.5);
  const head = new ConeGeometry(0.2, 0.5, 12).rotateX(Math.PI / 2).translate(0, 0, 0.25);
  const arrow = (colour: number) => {
    const made = createArrow(shaft, head, paint(colour));
    group.add(made.whole);
    return made;
  };
  const ghost = createGhost(OVERLAY_COLOURS.ghost);
  const error = new Mesh(shaft, paint(OVERLAY_COLOURS.error));
  const ring = new Mesh(new TorusGeometry(1, 0.012, 6, 64), paint(OVERLAY_COLOURS.footprint));
  group.add(ghost.group, error, ring);
  const normal = arrow(OVERLAY_COLOURS.normal);
  const forces = {
    thrust: arrow(OVERLAY_COLOURS.thrust),
    weight: arrow(OVERLAY_COLOURS.weight),
    support: arrow(OVERLAY_COLOURS.support),
  };
  const scaled = new Vector3();

  return {
    group,
    setGhostHull: (hull) => ghost.setHull(hull),
    update(choice, places) {
      ghost.show(choice.ghost && places.ghostKnown, places.ghost, places.ghostTurn);
      const gap = places.error.length();
      error.visible = choice.errorSegment && gap > 0.01;
      if (error.visible) {
        error.position.copy(places.ship);
        error.quaternion.setFromUnitVectors(Z, scaled.copy(places.error).divideScalar(gap));
        error.scale.set(1, 1, gap);
      }
      ring.visible = choice.footprint;
      ring.position.copy(places.footprint).addScaledVector(places.ground, 0.05);
      ring.quaternion.setFromUnitVectors(Z, places.ground);
      ring.scale.setScalar(places.legRadius);
      point(normal, places.foot, scaled.copy(places.ground).multiplyScalar(4), choice.contactNormal);
      for (const name of ['thrust', 'weight', 'support'] as const) {
        const from = name === 'support' ? places.foot : places.ship;
        point(forces[name], from, scaled.copy(places[name]).multiplyScalar(SCALE), choice.forces);
      }
    },
    dispose() {
      ghost.dispose();
      for (const geometry of [shaft, head, ring.geometry]) geometry.dispose();
      for (const material of materials) material.dispose();
    },
  };
}

interface Arrow {
  readonly whole: Group;
  readonly shaft: Mesh;
  readonly head: Mesh;
}

function createArrow(shaft: BufferGeometry, head: BufferGeometry, material: Material): Arrow {
  const made = { whole: new Group(), shaft: new Mesh(shaft, material), head: new Mesh(head, material) };
  made.whole.add(made.shaft, made.head);
  made.whole.renderOrder = 5;
  return made;
}

const way = new Vector3();

/** Points an arrow along a vector; one too short to see is hidden. */
function point({ whole, shaft, head }: Arrow, from: Vector3, vector: Vector3, visible: boolean): void {
  const length = vector.length();
  whole.visible = visible && length > 0.05;
  if (!whole.visible) return;
  whole.position.copy(from);
  whole.quaternion.setFromUnitVectors(Z, way.copy(vector).normalize());
  shaft.scale.z = Math.max(length - 0.4, 0.01);
  head.position.z = Math.max(length - 0.5, 0);
}
