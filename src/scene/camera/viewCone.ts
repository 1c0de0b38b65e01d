/**
 * The part of the ground in sight, seen from above: a wedge between two vertical planes through the eye. It is wider than the
 * picture where the eye looks down, and everything where it looks steeply down. Local axes, m.
 */
export interface ViewCone {
  x: number;
  z: number;
  /** No direction is out of sight. */
  whole: boolean;
  /** Unit normals of the two planes, towards the inside: x, z, x, z. */
  readonly inward: Float64Array;
}

export function createCone(): ViewCone {
  return { x: 0, z: 0, whole: true, inward: new Float64Array(4) };
}

/** The eye's opening: half angles of the picture, as tangents. */
export interface Opening {
  readonly across: number;
  readonly upright: number;
}

/** Upright field of view, degrees, of a picture that is `aspect` times as wide as high. A tall picture shows as much width as a square one. */
export function fieldOfView(aspect: number): number {
  return aspect >= 1 ? 48 : 62;
}

/** Sets the cone of an eye that looks towards a point; both local, m. */
export function aimCone(
  out: ViewCone,
  eye: Float64Array,
  focus: Float64Array,
  { across, upright }: Opening,
): void {
  const [dx, dy, dz] = [focus[0]! - eye[0]!, focus[1]! - eye[1]!, focus[2]! - eye[2]!];
  const level = Math.sqrt(dx * dx + dz * dz);
  const length = Math.sqrt(level * level + dy * dy);
  out.x = eye[0]!;
  out.z = eye[2]!;
  // Of the picture's corners the two nearest to the vertical spread widest.
  const ahead = (level - Math.abs(dy) * upright) / length;
  out.whole = !(ahead > 0.05);
  if (out.whole) return;
  const spread = Math.sqrt(ahead * ahead + across * across);
  const [cos, sin] = [ahead / spread, across / spread];
  const [fx, fz] = [dx / level, dz / level];
  const { inward } = out;
  inward[0] = sin * fx - cos * fz;
  inward[1] = sin * fz + cos * fx;
  inward[2] = sin * fx + cos * fz;
  inward[3] = sin * fz - cos * fx;
}

export function copyCone(out: ViewCone, cone: ViewCone): void {
  out.x = cone.x;
  out.z = cone.z;
  out.whole = cone.whole;
  out.inward.set(cone.inward);
}

/** Whether a cone is another one moved by less than `distance`, m, and turned by less than `angle`, rad. */
export function isNearCone(cone: ViewCone, other: ViewCone, distance: number, angle: number): boolean {
  if (cone.whole !== other.whole) return false;
  if (cone.whole) return true;
  for (let i = 0; i < 4; i++) if (Math.abs(cone.inward[i]! - other.inward[i]!) > angle) return false;
  return Math.abs(cone.x - other.x) < distance && Math.abs(cone.z - other.z) < distance;
}

/** Whether a circle about (x, z) reaches into the cone. */
export function coneMeets(cone: ViewCone, x: number, z: number, radius: number): boolean {
  if (cone.whole) return true;
  const { inward } = cone;
  const offX = x - cone.x;
  const offZ = z - cone.z;
  return offX * inward[0]! + offZ * inward[1]! > -radius && offX * inward[2]! + offZ * inward[3]! > -radius;
}
