/**
 * Protobuf written by hand from its encoding's description (https://protobuf.dev/programming-guides/encoding), so that
 * the codec is not tested by itself.
 */
export type Bytes = readonly number[];

export const VARINT = 0;
export const FIXED64 = 1;
export const DELIMITED = 2;
export const START_GROUP = 3;

export function varint(value: bigint | number): Bytes {
  const bytes: number[] = [];
  let rest = BigInt(value);
  while (rest >= 128n) {
    bytes.push(Number(rest & 127n) | 128);
    rest >>= 7n;
  }
  return [...bytes, Number(rest)];
}

export function tag(field: number, wireType: number): Bytes {
  return varint(field * 8 + wireType);
}

export function integer(field: number, value: bigint | number): Bytes {
  return [...tag(field, VARINT), ...varint(value)];
}

export function double(field: number, value: number): Bytes {
  const bytes = new Uint8Array(8);
  new DataView(bytes.buffer).setFloat64(0, value, true);
  return [...tag(field, FIXED64), ...bytes];
}

export function delimited(field: number, ...parts: readonly Bytes[]): Bytes {
  const content = parts.flat();
  return [...tag(field, DELIMITED), ...varint(content.length), ...content];
}

export function text(field: number, value: string): Bytes {
  return delimited(field, [...new TextEncoder().encode(value)]);
}

/** Vec3 {x=1, y=2, z=3}. */
export function vec3(field: number, x: number, y: number, z: number): Bytes {
  return delimited(field, double(1, x), double(2, y), double(3, z));
}

/** Quaternion {w=1, x=2, y=3, z=4}. */
export function quaternion(field: number, w: number, ...[x, y, z]: [number, number, number]): Bytes {
  return delimited(field, double(1, w), double(2, x), double(3, y), double(4, z));
}

export function bytesOf(...parts: readonly Bytes[]): Uint8Array {
  return Uint8Array.from(parts.flat());
}

/** The required fields of a ShipState: those that a server older than the fields 29 to 35 sends. */
export function olderShip(shipId: string): Bytes {
  return [
    ...text(1, shipId),
    ...vec3(5, 1, 2, 3),
    ...vec3(6, 4, 5, 6),
    ...quaternion(7, 1, 0, 0, 0),
    ...delimited(8),
  ];
}

/** A ServerMessage with a frame of these ShipStates. */
export function frameOf(...ships: readonly Bytes[]): Uint8Array {
  const list = ships.flatMap((ship) => delimited(6, ship));
  return bytesOf(delimited(2, integer(1, 9), double(2, 1), double(3, 1), list));
}
