import { ANGULAR_VELOCITY, ATTITUDE, BODY_ANGULAR_VELOCITY, POSITION, VELOCITY } from './layout';
import {
  AXES,
  COS_TILT,
  END,
  GRAVITY,
  INDEX,
  NORMAL,
  PENETRATION,
  quantity as q,
  RADIAL_SPEED,
  type Step,
  TANGENTIAL_SPEED,
  TANGENTIAL_VELOCITY,
} from './quantities';

/**
 * Fills the quantities at `surface` (START or END) from the ship's position and velocity as they are now.
 * @param bodyAxes BODY_AXES at a substep's start, BODY_END_AXES at its end: how the body lies under the ship.
 */
export function readSurface(surface: number, step: Step, bodyAxes: number): void {
  const to = surface & INDEX;
  const { ships, bodies, body, world } = step;
  const bodyAt = step.bodyAt & INDEX;
  const at = step.at & INDEX;
  const rx = ships[at + POSITION]!;
  const ry = ships[at + POSITION + 1]!;
  const rz = ships[at + POSITION + 2]!;
  const squared = rx * rx + ry * ry + rz * rz;
  const distance = Math.sqrt(squared);
  const perDistance = 1 / distance;
  const nx = rx * perDistance;
  const ny = ry * perDistance;
  const nz = rz * perDistance;
  q[to + NORMAL] = nx;
  q[to + NORMAL + 1] = ny;
  q[to + NORMAL + 2] = nz;

  const axes = (bodyAt + bodyAxes) & INDEX;
  const height = world.terrainHeight(
    body.name,
    bodies[axes]! * nx + bodies[axes + 3]! * ny + bodies[axes + 6]! * nz,
    bodies[axes + 1]! * nx + bodies[axes + 4]! * ny + bodies[axes + 7]! * nz,
    bodies[axes + 2]! * nx + bodies[axes + 5]! * ny + bodies[axes + 8]! * nz,
  );
  q[to + PENETRATION] = body.radius + height + step.shipClass.groundContactOffset - distance;

  const ox = bodies[bodyAt + BODY_ANGULAR_VELOCITY]!;
  const oy = bodies[bodyAt + BODY_ANGULAR_VELOCITY + 1]!;
  const oz = bodies[bodyAt + BODY_ANGULAR_VELOCITY + 2]!;
  const vx = ships[at + VELOCITY]! - (oy * rz - oz * ry);
  const vy = ships[at + VELOCITY + 1]! - (oz * rx - ox * rz);
  const vz = ships[at + VELOCITY + 2]! - (ox * ry - oy * rx);
  const radial = vx * nx + vy * ny + vz * nz;
  const tx = vx - radial * nx;
  const ty = vy - radial * ny;
  const tz = vz - radial * nz;
  q[to + RADIAL_SPEED] = radial;
  q[to + TANGENTIAL_VELOCITY] = tx;
  q[to + TANGENTIAL_VELOCITY + 1] = ty;
  q[to + TANGENTIAL_VELOCITY + 2] = tz;
  q[to + TANGENTIAL_SPEED] = Math.sqrt(tx * tx + ty * ty + tz * tz);
  q[to + GRAVITY] = body.gravityParameter / squared;
}

/** Fills AXES, the rotation matrix of the ship's attitude as it is now. */
export function readAxes(step: Step): void {
  const { ships } = step;
  const at = step.at & INDEX;
  const x = ships[at + ATTITUDE]!;
  const y = ships[at + ATTITUDE + 1]!;
  const z = ships[at + ATTITUDE + 2]!;
  const w = ships[at + ATTITUDE + 3]!;
  const x2 = x + x;
  const y2 = y + y;
  const z2 = z + z;
  q[AXES] = 1 - (y * y2 + z * z2);
  q[AXES + 1] = x * y2 - w * z2;
  q[AXES + 2] = x * z2 + w * y2;
  q[AXES + 3] = x * y2 + w * z2;
  q[AXES + 4] = 1 - (x * x2 + z * z2);
  q[AXES + 5] = y * z2 - w * x2;
  q[AXES + 6] = x * z2 - w * y2;
  q[AXES + 7] = y * z2 + w * x2;
  q[AXES + 8] = 1 - (x * x2 + y * y2);
}

/** Fills the third column of AXES alone: `up` of the attitude as it is now. */
export function readUp(step: Step): void {
  const { ships } = step;
  const at = step.at & INDEX;
  const x = ships[at + ATTITUDE]!;
  const y = ships[at + ATTITUDE + 1]!;
  const z = ships[at + ATTITUDE + 2]!;
  const w = ships[at + ATTITUDE + 3]!;
  const x2 = x + x;
  const y2 = y + y;
  const z2 = z + z;
  q[AXES + 2] = x * z2 + w * y2;
  q[AXES + 5] = y * z2 - w * x2;
  q[AXES + 8] = 1 - (x * x2 + y * y2);
}

/** COS_TILT = n · up at the substep's end, from the third column of AXES. */
export function readTilt(): void {
  q[COS_TILT] =
    q[END + NORMAL]! * q[AXES + 2]! +
    q[END + NORMAL + 1]! * q[AXES + 5]! +
    q[END + NORMAL + 2]! * q[AXES + 8]!;
}

/** u = Ω × r: the ship moves as the ground at its centre of mass. */
export function moveWithGround(step: Step): void {
  const { ships, bodies } = step;
  const bodyAt = step.bodyAt & INDEX;
  const at = step.at & INDEX;
  const ox = bodies[bodyAt + BODY_ANGULAR_VELOCITY]!;
  const oy = bodies[bodyAt + BODY_ANGULAR_VELOCITY + 1]!;
  const oz = bodies[bodyAt + BODY_ANGULAR_VELOCITY + 2]!;
  const rx = ships[at + POSITION]!;
  const ry = ships[at + POSITION + 1]!;
  const rz = ships[at + POSITION + 2]!;
  ships[at + VELOCITY] = oy * rz - oz * ry;
  ships[at + VELOCITY + 1] = oz * rx - ox * rz;
  ships[at + VELOCITY + 2] = ox * ry - oy * rx;
}

/** w = Ω: the ship turns as the ground. */
export function spinWithGround(step: Step): void {
  const { ships, bodies } = step;
  const bodyAt = step.bodyAt & INDEX;
  const at = step.at & INDEX;
  ships[at + ANGULAR_VELOCITY] = bodies[bodyAt + BODY_ANGULAR_VELOCITY]!;
  ships[at + ANGULAR_VELOCITY + 1] = bodies[bodyAt + BODY_ANGULAR_VELOCITY + 1]!;
  ships[at + ANGULAR_VELOCITY + 2] = bodies[bodyAt + BODY_ANGULAR_VELOCITY + 2]!;
}
