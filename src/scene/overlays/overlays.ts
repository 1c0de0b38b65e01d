import type { Quaternion } from 'three';
import {
  BufferGeometry,
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

/** What can be laid over the picture. */
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
  /** From where the ship is drawn to where it is predicted at the same instant: 0 while nothing is being corrected. */
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
  /** m/s², in local axes: what thrust, weight and ground give the ship. */
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
const LOOKS = {
  error: 0xff5a4f,
  normal: 0x7fe0ff,
  footprint: 0xffd24a,
  thrust: 0xffa040,
  weight: 0xc88cff,
  support: 0x7dff9a,
} as const;

/** Metres of arrow per m/s² of acceleration. */
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
    const material = paint(colour);
    const made = { whole: new Group(), shaft: new Mesh(shaft, material), head: new Mesh(head, material) };
    made.whole.add(made.shaft, made.head);
    made.whole.renderOrder = 5;
    group.add(made.whole);
    return made;
  };
  const ghostMaterial = new MeshBasicMaterial({
    color: new Color(0x58b8ff),
    wireframe: true,
    transparent: true,
    opacity: 0.22,
    depthWrite: false,
  });
  materials.push(ghostMaterial);
  const ghost = new Mesh(new BufferGeometry(), ghostMaterial);
  const error = new Mesh(shaft, paint(LOOKS.error));
  const ring = new Mesh(new TorusGeometry(1, 0.012, 6, 64), paint(LOOKS.footprint));
  group.add(ghost, error, ring);
  const normal = arrow(LOOKS.normal);
  const forces = { thrust: arrow(LOOKS.thrust), weight: arrow(LOOKS.weight), support: arrow(LOOKS.support) };
  const way = new Vector3();

  const point = (made: ReturnType<typeof arrow>, from: Vector3, vector: Vector3, visible: boolean) => {
    const length = vector.length();
    made.whole.visible = visible && length > 0.05;
    if (!made.whole.visible) return;
    made.whole.position.copy(from);
    made.whole.quaternion.setFromUnitVectors(Z, way.copy(vector).normalize());
    made.shaft.scale.z = Math.max(length - 0.4, 0.01);
    made.head.position.z = Math.max(length - 0.5, 0);
  };

  return {
    group,
    setGhostHull(hull) {
      ghost.geometry = hull;
    },
    update(choice, places) {
      ghost.visible = choice.ghost && places.ghostKnown;
      ghost.position.copy(places.ghost);
      ghost.quaternion.copy(places.ghostTurn);
      const gap = places.error.length();
      error.visible = choice.errorSegment && gap > 0.01;
      if (error.visible) {
        error.position.copy(places.ship);
        error.quaternion.setFromUnitVectors(Z, way.copy(places.error).divideScalar(gap));
        error.scale.set(1, 1, gap);
      }
      ring.visible = choice.footprint;
      ring.position.copy(places.footprint).addScaledVector(places.ground, 0.05);
      ring.quaternion.setFromUnitVectors(Z, places.ground);
      ring.scale.setScalar(places.legRadius);
      point(normal, places.foot, places.ground.clone().multiplyScalar(4), choice.contactNormal);
      for (const name of ['thrust', 'weight', 'support'] as const) {
        const from = name === 'support' ? places.foot : places.ship;
        point(forces[name], from, places[name].clone().multiplyScalar(SCALE), choice.forces);
      }
    },
    dispose() {
      for (const geometry of [shaft, head, ring.geometry]) geometry.dispose();
      for (const material of materials) material.dispose();
    },
  };
}
