/** What a frame shows, and what it holds: of three's own objects, as the renderer was given them. */
import {
  type BufferGeometry,
  type Camera,
  type Color,
  type InstancedBufferAttribute,
  type Material,
  type Object3D,
  type OrthographicCamera,
  type Quaternion,
  type ShaderMaterial,
  UniformsLib,
  type Vector3,
  type WebGLRenderer,
} from 'three';

export interface Drawn {
  readonly renderer: WebGLRenderer;
  readonly scene: Object3D;
  readonly camera: Camera & Partial<Record<'fov' | 'aspect' | 'near', number>>;
}

/** Members that only some kinds of object have. */
interface Kinds {
  readonly geometry?: BufferGeometry;
  readonly material?: ShaderMaterial;
  readonly customDepthMaterial?: Material;
  readonly instanceMatrix?: InstancedBufferAttribute;
  readonly count?: number;
  readonly color?: Color;
  readonly intensity?: number;
  readonly shadow?: { readonly camera: OrthographicCamera };
}

/** Rounded to five digits, so that another engine's sine writes the same. */
const short = (values: Iterable<number> | ArrayLike<number>) =>
  Array.from(values)
    .map((x) => (Math.abs(x) < 1e-6 ? 0 : Number(x.toPrecision(5))))
    .join(' ');

function valueOf(value: unknown): string {
  if (typeof value === 'number') return short([value]);
  if (ArrayBuffer.isView(value)) return short(value as Float32Array);
  const values = value as Color | Vector3 | Quaternion | undefined;
  return typeof values?.toArray === 'function' ? short(values.toArray()) : '';
}

/** The uniforms and the colour of a material, once. */
function materialLines(material: ShaderMaterial | undefined, seen: Set<object>): string[] {
  if (material === undefined || seen.has(material)) return [];
  seen.add(material);
  const { color, opacity, uniforms } = material as ShaderMaterial & { color?: Color };
  // Uniforms that a standard material gets when it is compiled.
  const added: Pick<ShaderMaterial, 'uniforms'> = { uniforms: {} };
  material.onBeforeCompile({ ...added, vertexShader: '', fragmentShader: '' } as never, null as never);
  const own = Object.entries({ ...uniforms, ...added.uniforms }).filter(
    ([name]) => !(name in UniformsLib.lights),
  );
  const plain = `opacity ${short([opacity])}${color === undefined ? '' : `, colour ${short(color)}`}`;
  return [[plain, ...own.map(([name, { value }]) => `${name} ${valueOf(value)}`)].join(', ')];
}

/** How an object that is visible is placed and lit, and all in it. */
function objectLines(object: Object3D, seen: Set<object>, indent = ''): string[] {
  if (!object.visible) return [`${indent}${object.type}, hidden`];
  const { geometry, material, count = 0, instanceMatrix, color, intensity, shadow } = object as Kinds;
  const place = object.matrixWorldAutoUpdate ? object.position : object.matrixWorld.elements.slice(12, 15);
  const lines = [`at ${short(place)}`];
  const turn = short(object.quaternion);
  const scale = short(object.scale);
  if (turn !== '0 0 0 1') lines.push(`turned ${turn}`);
  if (scale !== '1 1 1') lines.push(`scaled ${scale}`);
  const range = geometry?.drawRange;
  if (range !== undefined && range.count < Infinity) lines.push(`vertices ${range.start}, ${range.count}`);
  if (instanceMatrix !== undefined)
    lines.push(`${count} places, the last ${short(instanceMatrix.array.slice(16 * count - 16, 16 * count))}`);
  if (color !== undefined) lines.push(`light ${short(color)}, ${short([intensity!])}`);
  if (object.castShadow && shadow !== undefined) {
    const { left, right, top, bottom, near, far } = shadow.camera;
    lines.push(`shadow map ${short([left, right, top, bottom, near, far])}`);
  }
  return [
    `${indent}${object.type} ${lines.join(', ')}`,
    ...materialLines(material, seen).map((line) => `${indent}    ${line}`),
    ...object.children.flatMap((child) => objectLines(child, seen, `${indent}  `)),
  ];
}

export function frameOf({ renderer, scene, camera }: Drawn): string[] {
  const { position, quaternion, fov = 0, aspect = 0, near = 0 } = camera;
  return [
    `camera at ${short(position)}, turned ${short(quaternion)}, ${short([fov, aspect, near])}`,
    `exposure ${short([renderer.toneMappingExposure])}, ${renderer.info.render.calls} draws`,
    ...objectLines(scene, new Set()),
  ];
}

/** All that holds memory of the GPU: geometries, materials, their textures, instances and shadow maps, each with its name. */
export function resourcesOf({ scene }: Drawn): Map<object, string> {
  const found = new Map<object, string>();
  const add = (thing: unknown, name: string) => {
    if (typeof (thing as Partial<BufferGeometry> | null | undefined)?.dispose === 'function')
      found.set(thing as object, name);
  };
  scene.traverse((object) => {
    const { geometry, material, customDepthMaterial, instanceMatrix, shadow } = object as Kinds;
    if (instanceMatrix !== undefined || shadow !== undefined) add(object, object.type);
    add(geometry, `geometry of ${object.type}`);
    for (const each of [material, customDepthMaterial]) add(each, `material of ${object.type}`);
    for (const { value } of Object.values(material?.uniforms ?? {})) add(value, 'texture');
  });
  return found;
}

/** Where the one hull is, from the eye, m. */
export function shipIn({ scene }: Drawn): number[] {
  const hulls: InstancedBufferAttribute[] = [];
  scene.traverse((object) => {
    const { instanceMatrix, customDepthMaterial } = object as Kinds;
    if (instanceMatrix !== undefined && customDepthMaterial !== undefined) hulls.push(instanceMatrix);
  });
  return [...hulls[0]!.array.slice(12, 15)];
}
