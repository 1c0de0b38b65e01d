import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  CylinderGeometry,
  LatheGeometry,
  SphereGeometry,
  TorusGeometry,
  Vector2,
} from 'three';
import { cellNoise } from '../../ground/noise';
import type { Finish, Flex, Parts } from './parts';

/** Geometries along z, m; those of three are along y. */

export function box(x: number, y: number, z: number): BufferGeometry {
  return new BoxGeometry(x, y, z);
}

/** From z = −length/2 (radius `low`) to +length/2 (radius `high`). */
export function tube(low: number, high: number, length: number, sides = 16): BufferGeometry {
  return new CylinderGeometry(high, low, length, sides).rotateX(Math.PI / 2);
}

export function ball(radius: number, sides = 16): BufferGeometry {
  return new SphereGeometry(radius, sides, Math.max(6, sides / 2)).rotateX(Math.PI / 2);
}

export function ring(radius: number, thickness: number, sides = 24): BufferGeometry {
  return new TorusGeometry(radius, thickness, 6, sides);
}

/** Turned from a profile of [radius, z], bottom first. */
export function turned(profile: readonly (readonly [number, number])[], sides = 24): BufferGeometry {
  const points = profile.map(([radius, z]) => new Vector2(radius, z));
  return new LatheGeometry(points, sides).rotateX(Math.PI / 2);
}

/** An engine bell: its throat at z = 0, its mouth of `radius` at z = −length. */
export function bell(radius: number, length: number): BufferGeometry {
  const outside: [number, number][] = [];
  for (let n = 0; n <= 8; n++) {
    const t = 1 - n / 8;
    outside.push([radius * (0.28 + 0.72 * Math.pow(t, 0.6)), -length * t]);
  }
  const inside = outside.map(([r, z]): [number, number] => [r * 0.94, z]).reverse();
  return turned([...inside, ...outside], 20);
}

/** A flat plate across y, `thickness` m, from the corners [x, z] of a convex outline, counter-clockwise. */
export function plate(outline: readonly (readonly [number, number])[], thickness: number): BufferGeometry {
  const half = thickness / 2;
  const corners: number[] = [];
  const put = (y: number, ...indices: readonly number[]) => {
    for (const i of indices) corners.push(outline[i]![0], y, outline[i]![1]);
  };
  for (let i = 1; i + 1 < outline.length; i++) {
    put(-half, 0, i, i + 1);
    put(half, 0, i + 1, i);
  }
  for (let i = 0; i < outline.length; i++) {
    const next = (i + 1) % outline.length;
    put(-half, next, i);
    put(half, i);
    put(-half, next);
    put(half, i, next);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(corners), 3));
  geometry.computeVertexNormals();
  return geometry;
}

/** A regular prism with flat sides, crumpled like foil by `crumple` m. */
export function foilPrism(radius: number, length: number, sides: number, crumple: number): BufferGeometry {
  const geometry = new CylinderGeometry(radius, radius, length, sides * 4, 7).toNonIndexed();
  const positions = geometry.getAttribute('position').array as Float32Array;
  const step = (2 * Math.PI) / sides;
  for (let at = 0; at < positions.length; at += 3) {
    const x = positions[at]!;
    const y = positions[at + 1]!;
    const z = positions[at + 2]!;
    const angle = Math.atan2(z, x);
    // The round column is pressed flat onto the prism's sides.
    const within = angle - step * Math.floor(angle / step) - step / 2;
    const press = Math.cos(step / 2) / Math.cos(within);
    const key = Math.round(angle * 40) & 1023;
    const dent = crumple * (cellNoise(key, Math.round(y * 50), 9) - 0.5);
    const edge = Math.abs(y) > length * 0.49 ? 0 : dent;
    positions[at] = x * press * (1 + edge);
    positions[at + 2] = z * press * (1 + edge);
  }
  writeFaceNormals(geometry.getAttribute('normal').array as Float32Array, positions);
  return geometry.rotateX(Math.PI / 2);
}

/** Each triangle's normal at its three corners, as three.js computes it, which takes several times as long. */
function writeFaceNormals(normals: Float32Array, positions: Float32Array): void {
  for (let at = 0; at < positions.length; at += 9) {
    const bx = positions[at + 3]!;
    const by = positions[at + 4]!;
    const bz = positions[at + 5]!;
    const cx = positions[at + 6]! - bx;
    const cy = positions[at + 7]! - by;
    const cz = positions[at + 8]! - bz;
    const ax = positions[at]! - bx;
    const ay = positions[at + 1]! - by;
    const az = positions[at + 2]! - bz;
    const x = Math.fround(cy * az - cz * ay);
    const y = Math.fround(cz * ax - cx * az);
    const z = Math.fround(cx * ay - cy * ax);
    const perLength = 1 / (Math.sqrt(x * x + y * y + z * z) || 1);
    for (let corner = at; corner < at + 9; corner += 3) {
      normals[corner] = x * perLength;
      normals[corner + 1] = y * perLength;
      normals[corner + 2] = z * perLength;
    }
  }
}

/** A rod between two points of body axes. */
export interface Strut {
  readonly from: readonly [number, number, number];
  readonly to: readonly [number, number, number];
  readonly radius: number;
  readonly flex?: Flex;
}

export function addStrut(parts: Parts, finish: Finish, { from, to, radius, flex }: Strut): void {
  const along: [number, number, number] = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
  const at: [number, number, number] = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2, (from[2] + to[2]) / 2];
  const placement = flex === undefined ? { at, along } : { at, along, flex };
  parts.add(tube(radius, radius, Math.hypot(...along), 8), finish, placement);
}
