/** Rotations by Rodrigues' formula: v cos φ + (n × v) sin φ + n (n · v)(1 − cos φ). */
import { describe, expect, it } from 'vitest';
import * as rotation from '../../../src/prediction/drawn/rotation';

type Vector = readonly [number, number, number];
type Quaternion = readonly [number, number, number, number];

const of = (values: readonly number[]) => Float64Array.from(values);
const dot = (a: readonly number[], b: readonly number[]) => a.reduce((sum, x, k) => sum + x * b[k]!, 0);
const cross = ([a, b, c]: Vector, [x, y, z]: Vector): Vector => [b * z - c * y, c * x - a * z, a * y - b * x];
const unit = (v: Vector): Vector => v.map((x) => x / Math.sqrt(dot(v, v))) as unknown as Vector;

/** A turn by `angle`, rad, about the unit vector `axis`. */
interface Turn {
  readonly axis: Vector;
  readonly angle: number;
}
const quaternionOf = ({ axis, angle }: Turn): Quaternion => {
  const [x, y, z] = axis.map((n) => n * Math.sin(angle / 2)) as unknown as Vector;
  return [x, y, z, Math.cos(angle / 2)];
};
function turned({ axis, angle }: Turn, v: Vector): Vector {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const side = cross(axis, v);
  const along = dot(axis, v) * (1 - cos);
  return v.map((x, k) => x * cos + side[k]! * sin + axis[k]! * along) as unknown as Vector;
}
const back = ({ axis, angle }: Turn): Turn => ({ axis, angle: -angle });

const A: Turn = { axis: unit([1, 2, -3]), angle: 1.1 };
const B: Turn = { axis: unit([-2, 0.5, 0.7]), angle: 2.3 };
const V: Vector = [3, -5, 7];

const near = (found: ArrayLike<number>, expected: readonly number[]) => {
  expect(found).toHaveLength(expected.length);
  for (const [k, x] of expected.entries()) expect(found[k]).toBeCloseTo(x, 12);
};
/** What a function that writes to its first argument writes. */
const written = (size: number, write: (out: Float64Array) => void) => {
  const out = new Float64Array(size);
  write(out);
  return out;
};
/** What the quaternion that a function writes does to V. */
const effect = (write: (out: Float64Array) => void) =>
  written(3, (out) => rotation.rotate(out, written(4, write), of(V)));

describe('a rotation', () => {
  const [a, b, v] = [of(quaternionOf(A)), of(quaternionOf(B)), of(V)];

  it('rotates a vector and back, also in place', () => {
    near(
      written(3, (out) => rotation.rotate(out, a, v)),
      turned(A, V),
    );
    near(
      written(3, (out) => rotation.rotateBack(out, a, v)),
      turned(back(A), V),
    );
    const own = of(V);
    rotation.rotate(own, a, own);
    rotation.rotateBack(own, a, own);
    near(own, V);
  });

  it('is composed with another, expressed in its axes, and recovered as the difference', () => {
    near(
      effect((out) => rotation.compose(out, a, b)),
      turned(A, turned(B, V)),
    );
    near(
      effect((out) => rotation.relativeRotation(out, a, b)),
      turned(back(A), turned(B, V)),
    );
    near(
      effect((out) => rotation.rotationBetween(out, a, b)),
      turned(A, turned(back(B), V)),
    );
    for (const combine of [rotation.compose, rotation.relativeRotation, rotation.rotationBetween])
      near(
        [rotation.angleOf(written(4, (out) => combine(out, a, a)))],
        [combine === rotation.compose ? 2.2 : 0],
      );
  });

  it.each([1.1, 3.1, 0.01, 1e-7, 0, -2])('by %d rad is a vector of that length along its axis', (angle) => {
    const vector = A.axis.map((n) => n * angle);
    const q = written(4, (out) => rotation.fromRotationVector(out, of(vector)));
    near(q, quaternionOf({ ...A, angle }));
    // −q is the same rotation.
    for (const sign of [1, -1]) {
      const same = q.map((x) => x * sign);
      near(
        written(3, (out) => rotation.toRotationVector(out, same)),
        vector,
      );
      near([rotation.angleOf(same)], [Math.abs(angle)]);
    }
  });

  it('by more than π becomes the shorter one in the other direction', () => {
    const q = of(quaternionOf({ ...A, angle: 4 }));
    const vector = A.axis.map((n) => n * (4 - 2 * Math.PI));
    near(
      written(3, (out) => rotation.toRotationVector(out, q)),
      vector,
    );
    near([rotation.angleOf(q)], [2 * Math.PI - 4]);
  });

  it.each([1, -1])('is blended along the short way and stays of unit length, from %d q', (sign) => {
    const small = (angle: number) => quaternionOf({ ...A, angle });
    const [from, to] = [small(0.7).map((x) => x * sign), small(0.708)];
    const blended = written(4, (out) => rotation.blend(out, of(from), of(to), { alpha: 0.25 }));
    expect(dot([...blended], [...blended])).toBeCloseTo(1, 14);
    // The lerp is within 1e-8 of the arc.
    for (const [k, x] of small(0.702).entries()) expect(Math.abs(blended[k]! * sign - x)).toBeLessThan(1e-8);
  });
});

it('vectors are blended, multiplied, measured, read from rows and written back', () => {
  const [a, b] = [V, [-2, 11, 0.5] as const];
  const sum = of(a);
  rotation.add(sum, of(b), 0.5);
  near(sum, [2, 0.5, 7.25]);
  near([rotation.dot(of(a), of(b)), rotation.lengthOf(of(a))], [dot(a, b), Math.sqrt(83)]);
  near(
    written(3, (out) => rotation.cross(out, of(a), of(b))),
    cross(a, b),
  );
  const q = of([1, -2, 3, -4]);
  rotation.normalize(q);
  near(
    q,
    [1, -2, 3, -4].map((x) => x / Math.sqrt(30)),
  );
  const rows = of([0, 1, 2, 3, 4, 5]);
  near(
    written(3, (out) => rotation.take(out, rows, 2)),
    [2, 3, 4],
  );
  rotation.put(rows, 1, of([8, 9]));
  near(rows, [0, 8, 9, 3, 4, 5]);
  near(rotation.quaternion(), [0, 0, 0, 1]);
  near(rotation.vector(), [0, 0, 0]);
});
