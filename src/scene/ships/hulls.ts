import {
  BufferGeometry,
  DynamicDrawUsage,
  Group,
  InstancedBufferAttribute,
  InstancedMesh,
  Matrix4,
  Quaternion,
  Vector3,
} from 'three';
import { uploadFirst } from '../uploads';
import type { ShipActor } from './shipActor';
import type { ShipMaterial } from './shipMaterial';
import type { ShipModel } from './shipModel';

/** All ships' hulls: one draw per class and level of detail, whatever the number of ships. */
export interface Hulls {
  readonly group: Group;
  /** Begins a frame without ships. */
  clear(): void;
  /** Puts a posed ship in the scene. `eye` local, m; the watched ship is drawn in full detail and casts a shadow at any distance. */
  put(actor: ShipActor, eye: Float64Array, isWatched: boolean): void;
  /** Ends a frame. */
  finish(): void;
  dispose(): void;
}

/** Distance from the eye, m, in heights of the model, from which each coarser level is drawn. */
const COARSER_FROM = [5.5, 16] as const;
const FIRST_ROOM = 8;

interface Level {
  readonly geometry: BufferGeometry;
  readonly isWhole: boolean;
  mesh: InstancedMesh;
  compression: InstancedBufferAttribute;
  /** Share of the sun that reaches each ship, 0 … 1. */
  sunlit: InstancedBufferAttribute;
  /** Whether they differ from the GPU's copy. */
  hasNewCompression: boolean;
  hasNewSunlit: boolean;
  count: number;
}

export function createHulls(material: ShipMaterial): Hulls {
  const group = new Group();
  /** By model and detail, the levels that were needed so far. */
  const classes = new Map<ShipModel, Map<number, Level>>();
  const matrix = new Matrix4();
  const place = new Vector3();
  const turn = new Quaternion();
  const ONE = new Vector3(1, 1, 1);

  const levelOf = (model: ShipModel, detail: number) => {
    const levels = classes.get(model) ?? new Map<number, Level>();
    const known = levels.get(detail);
    if (known !== undefined) return known;
    const geometry = detail === 0 ? model.geometry : model.coarser()[detail - 1]!;
    const made = createLevel(geometry, detail === 0, material);
    group.add(made.mesh);
    classes.set(model, levels.set(detail, made));
    return made;
  };

  return {
    group,
    clear() {
      for (const levels of classes.values()) for (const level of levels.values()) level.count = 0;
    },
    put(actor, eye, isWatched) {
      place.set(actor.place[0]! - eye[0]!, actor.place[1]! - eye[1]!, actor.place[2]! - eye[2]!);
      const heights = place.length() / (2 * actor.model.geometry.boundingSphere!.radius);
      let detail = 0;
      if (!isWatched) while (detail < COARSER_FROM.length && heights > COARSER_FROM[detail]!) detail++;
      const level = levelOf(actor.model, detail);
      if (level.count === level.mesh.instanceMatrix.count) enlarge(level, group, material);
      turn.set(actor.turn[0]!, actor.turn[1]!, actor.turn[2]!, actor.turn[3]!);
      level.mesh.setMatrixAt(level.count, matrix.compose(place, turn, ONE));
      if (level.isWhole)
        for (let leg = 0; leg < 4; leg++)
          if (change(level.compression, 4 * level.count + leg, actor.compression[leg]!))
            level.hasNewCompression = true;
      if (change(level.sunlit, level.count, actor.sunlit)) level.hasNewSunlit = true;
      level.count++;
    },
    finish() {
      for (const levels of classes.values()) {
        for (const level of levels.values()) {
          const { mesh, count } = level;
          mesh.count = count;
          mesh.visible = count > 0;
          if (count === 0) continue;
          uploadFirst(mesh.instanceMatrix, count);
          if (level.hasNewSunlit) uploadFirst(level.sunlit, count);
          if (level.hasNewCompression) uploadFirst(level.compression, count);
          level.hasNewSunlit = level.hasNewCompression = false;
        }
      }
    },
    dispose() {
      for (const levels of classes.values()) for (const { mesh } of levels.values()) release(mesh);
    },
  };
}

/** Writes one number. Returns whether it has changed. */
function change({ array }: InstancedBufferAttribute, at: number, value: number): boolean {
  const rounded = Math.fround(value);
  if (array[at] === rounded) return false;
  array[at] = rounded;
  return true;
}

function createLevel(geometry: BufferGeometry, isWhole: boolean, material: ShipMaterial): Level {
  const isNew = { hasNewCompression: false, hasNewSunlit: false };
  return { geometry, isWhole, count: 0, ...isNew, ...createMesh(geometry, FIRST_ROOM, isWhole, material) };
}

/** Doubles the room, and keeps the ships that are there. */
function enlarge(level: Level, group: Group, material: ShipMaterial): void {
  const { mesh: old, compression: before, sunlit } = level;
  const made = createMesh(level.geometry, 2 * level.count, level.isWhole, material);
  made.mesh.instanceMatrix.set(old.instanceMatrix.array, 0);
  made.compression.set(before.array, 0);
  made.sunlit.set(sunlit.array, 0);
  group.remove(old);
  group.add(made.mesh);
  release(old);
  level.mesh = made.mesh;
  level.compression = made.compression;
  level.sunlit = made.sunlit;
}

function release(mesh: InstancedMesh): void {
  mesh.dispose();
  mesh.geometry.dispose();
}

function createMesh(
  shared: BufferGeometry,
  room: number,
  isWhole: boolean,
  material: ShipMaterial,
): Pick<Level, 'mesh' | 'compression' | 'sunlit'> {
  // The vertices are shared, the instances' attribute is not.
  const geometry = new BufferGeometry();
  for (const [name, attribute] of Object.entries(shared.attributes)) geometry.setAttribute(name, attribute);
  const compression = new InstancedBufferAttribute(new Float32Array(room * 4), 4);
  compression.setUsage(DynamicDrawUsage);
  geometry.setAttribute('compression', compression);
  const sunlit = new InstancedBufferAttribute(new Float32Array(room), 1);
  sunlit.setUsage(DynamicDrawUsage);
  geometry.setAttribute('sunlit', sunlit);
  const mesh = new InstancedMesh(geometry, material.surface, room);
  mesh.instanceMatrix.setUsage(DynamicDrawUsage);
  mesh.customDepthMaterial = material.shadow;
  mesh.castShadow = isWhole;
  mesh.receiveShadow = isWhole;
  // Only the instances have positions.
  mesh.frustumCulled = false;
  mesh.matrixAutoUpdate = false;
  return { mesh, compression, sunlit };
}
