import {
  BufferAttribute,
  type BufferGeometry,
  Color,
  InstancedMesh,
  type Material,
  Object3D,
  Texture,
} from 'three';

/** Rounded to five digits, so that another engine's sine writes the same. */
const short = (value: number) => (Math.abs(value) < 1e-9 ? '0' : String(Number(value.toPrecision(5))));

/** Count, smallest, largest and a sum in which each value has a weight of its own. */
function numbersOf(values: ArrayLike<number>): string {
  let [low, high, sum] = [Infinity, -Infinity, 0];
  for (let i = 0; i < values.length; i++) {
    const value = values[i]!;
    low = Math.min(low, value);
    high = Math.max(high, value);
    sum += value * ((i % 89) + 1);
  }
  return `${values.length} numbers from ${short(low)} to ${short(high)}, weighted sum ${short(sum / values.length)}`;
}

export function geometryLines(geometry: BufferGeometry): string[] {
  const { index, attributes, drawRange } = geometry;
  return [
    ...(index === null ? [] : [`index: ${numbersOf(index.array)}`]),
    ...Object.entries(attributes).map(([name, attribute]) =>
      attribute instanceof BufferAttribute
        ? `${name} × ${attribute.itemSize}: ${numbersOf(attribute.array)}`
        : `${name} × ${attribute.itemSize}`,
    ),
    ...(drawRange.start > 0 || drawRange.count < Infinity
      ? [`drawn: ${drawRange.start}, ${drawRange.count}`]
      : []),
  ];
}

/** Numbers, words, colours and vectors of anything, by name. */
function plainOf(value: unknown): string | null {
  if (typeof value === 'number') return short(value);
  if (typeof value === 'string' || typeof value === 'boolean') return String(value);
  if (value instanceof Texture)
    return numbersOf((value.image as { data: ArrayLike<number> } | null)?.data ?? []);
  if (value instanceof Color) return `#${value.getHexString()}`;
  if (typeof value !== 'object' || value === null) return null;
  if ('toArray' in value && typeof value.toArray === 'function')
    return (value.toArray as () => unknown[])()
      .map((part) => short(Number(part)))
      .join(' ');
  return Array.isArray(value) ? value.map(plainOf).join(' ') : null;
}

/** Names of its own, by which three tells a thing from others, and what it computes from the rest. */
const LEFT_OUT = /^(id|uuid|type|name|version|_.*|matrix.*|is[A-Z].*|vertexShader|fragmentShader)$/;

/** The members that differ from three's defaults. */
function membersOf(thing: object, defaults: object): string[] {
  const usual = defaults as Readonly<Record<string, unknown>>;
  return Object.entries(thing).flatMap(([name, value]) => {
    const plain = LEFT_OUT.test(name) ? null : plainOf(value);
    return plain === null || plain === plainOf(usual[name]) ? [] : [`${name} ${plain}`];
  });
}

function materialLines(material: Material & { uniforms?: Record<string, { value: unknown }> }): string[] {
  const uniforms = Object.entries(material.uniforms ?? {}).map(
    ([name, { value }]) => `${name} ${plainOf(value) ?? 'none'}`,
  );
  return [
    `${material.type}: ${[...membersOf(material, new (material.constructor as new () => Material)()), ...uniforms].join(', ')}`,
  ];
}

type Drawn = Object3D & { geometry?: BufferGeometry; material?: Material | Material[] };

/** The object and what is in it: how each is placed and drawn, from what material and which vertices. */
export function recordOf(object: Object3D, indent = ''): string[] {
  const { geometry, material } = object as Drawn;
  const inside = [
    ...(material === undefined ? [] : [material].flat().flatMap(materialLines)),
    ...(geometry === undefined ? [] : geometryLines(geometry)),
    ...(object instanceof InstancedMesh && object.count > 0
      ? [`places of ${object.count}: ${numbersOf(object.instanceMatrix.array.slice(0, 16 * object.count))}`]
      : []),
  ];
  return [
    `${indent}${object.type}: ${membersOf(object, new Object3D()).join(', ')}`,
    ...inside.map((line) => `${indent}  ${line}`),
    ...object.children.flatMap((child) => recordOf(child, `${indent}  `)),
  ];
}
