import { AdditiveBlending, Group, Mesh, MeshBasicMaterial, SphereGeometry } from 'three';
import { createDebris } from './debris';

/** A crash: a flash, and pieces that fly, fall by the body's own gravity and come to rest on the ground. */
export interface Crash {
  readonly group: Group;
  /** Begins at a local place, m; `size` of the ship, m. `groundY(x, z)`: local height of the ground, m. */
  begin(place: ArrayLike<number>, size: number, groundY: (x: number, z: number) => number): void;
  /** `time` s, monotone; `gravity` m/s²; `eye` local, m. */
  update(time: number, gravity: number, eye: Float64Array): void;
  clear(): void;
  dispose(): void;
}

/** Duration of the flash, s; and its final size, in sizes of the ship. */
const FLASH = 0.5;
const FLASH_SIZE = 2.6;

export function createCrash(): Crash {
  const debris = createDebris();
  const flash = createFlash();
  const group = new Group();
  group.add(debris.mesh, flash.mesh);
  group.visible = false;
  const origin = new Float64Array(3);
  let began = NaN;
  let waiting = false;
  let reach = 1;
  let groundAt: (x: number, z: number) => number = () => 0;

  return {
    group,
    begin(place, size, groundY) {
      for (let k = 0; k < 3; k++) origin[k] = place[k]!;
      reach = size;
      groundAt = groundY;
      waiting = true;
    },
    update(time, gravity, eye) {
      if (waiting) {
        began = time;
        debris.begin(origin, gravity, groundAt);
      }
      waiting = false;
      group.visible = !Number.isNaN(began);
      if (!group.visible) return;
      group.position.set(origin[0]! - eye[0]!, origin[1]! - eye[1]!, origin[2]! - eye[2]!);
      debris.place(time - began, gravity, reach);
      flash.show((time - began) / FLASH, reach * FLASH_SIZE);
    },
    clear() {
      began = NaN;
      waiting = false;
      group.visible = false;
    },
    dispose() {
      debris.dispose();
      flash.dispose();
    },
  };
}

function createFlash() {
  const material = new MeshBasicMaterial({
    color: 0xffe2b0,
    transparent: true,
    blending: AdditiveBlending,
    depthWrite: false,
  });
  const mesh = new Mesh(new SphereGeometry(1, 24, 16), material);
  mesh.renderOrder = 4;
  return {
    mesh,
    /** `share` of its time, 0 … 1; `size`: radius at its end, m. */
    show(share: number, size: number) {
      mesh.visible = share < 1;
      if (!mesh.visible) return;
      mesh.scale.setScalar(Math.max(size * Math.sqrt(share), 0.01));
      material.opacity = (1 - share) ** 2;
    },
    dispose() {
      mesh.geometry.dispose();
      material.dispose();
    },
  };
}
