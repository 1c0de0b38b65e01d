import { add, compose, cross, inverse, rotate } from '../authority';
import {
  type Body,
  type BodyMotion,
  cosineOfDegrees,
  type Quat,
  type ShipClass,
  type ShipInit,
  sineOfDegrees,
  type SurfaceState,
  type TerrainHeight,
  type Vec3,
} from '../dynamics';
import { minus } from './vectors';

/** A place on a body, degrees: latitude from the equator toward the pole (body Y), longitude from the prime meridian (Z) toward X. */
export interface Site {
  readonly latitude: number;
  readonly longitude: number;
}

/** A ship as seen from the ground. Local axes are [east, north, up]; the ground turns with the body. */
export interface LocalState {
  /** Height of an upright ship's feet above the ground, m; negative is below it. */
  readonly height: number;
  /** Relative to the ground, m/s. */
  readonly velocity: Vec3;
  /** Degrees from the vertical, and the direction in which the top leans: degrees from north toward east. */
  readonly tilt: number;
  readonly leanTo: number;
  /** Where body +Y points, seen from above an upright ship: degrees from north toward east. */
  readonly heading: number;
  /** Relative to the ground, rad/s. */
  readonly spin: Vec3;
}

/** The place and ground of a local state. */
export interface Ground {
  readonly body: Body & BodyMotion;
  readonly site: Site;
  readonly terrainHeight: TerrainHeight;
}

/** The part of a ship's state that does not depend on its place. */
export interface Craft {
  readonly shipClass: ShipClass;
  readonly fuel: number;
  readonly surfaceContactState: SurfaceState;
  readonly contactImpactSpeed: number;
}

/** The ship relative to the body's centre in ICRF axes; exact arithmetic, so that scenarios start with the same bits in every engine. */
export function toBodyRelative(local: LocalState, craft: Craft, ground: Ground): ShipInit {
  const { body } = ground;
  const axes = localAxes(ground);
  const up = rotate(axes, [0, 0, 1]);
  const reach = surfaceReach(craft.shipClass, ground) + local.height;
  const relativePosition: Vec3 = [up[0] * reach, up[1] * reach, up[2] * reach];
  // About the axis up × lean direction.
  const lean = rotationAbout([-cosineOfDegrees(local.leanTo), sineOfDegrees(local.leanTo), 0], local.tilt);
  const heading = rotationAbout([0, 0, 1], -local.heading);
  return {
    shipClass: craft.shipClass.name,
    referenceBody: body.name,
    relativePosition,
    relativeVelocity: add(cross(body.angularVelocity, relativePosition), rotate(axes, local.velocity)),
    attitude: compose(axes, compose(lean, heading)),
    angularVelocity: add(body.angularVelocity, rotate(axes, local.spin)),
    fuel: craft.fuel,
    surfaceContactState: craft.surfaceContactState,
    contactImpactSpeed: craft.contactImpactSpeed,
    crashed: false,
  };
}

/** Position (m), velocity (m/s) and spin (rad/s) of a ship in [east, north, up] from the ground at a site. */
export interface SeenFromSite {
  readonly position: Vec3;
  readonly velocity: Vec3;
  /** Unit vector: the direction of the ship's top (body +Z). */
  readonly top: Vec3;
  readonly spin: Vec3;
}

/** The inverse of toBodyRelative; `ground.body` in its attitude at that instant. */
export function fromBodyRelative(ship: ShipInit, shipClass: ShipClass, ground: Ground): SeenFromSite {
  const { body } = ground;
  const toLocal = inverse(localAxes(ground));
  const [east, north, up] = rotate(toLocal, ship.relativePosition);
  const groundVelocity = cross(body.angularVelocity, ship.relativePosition);
  const reach = surfaceReach(shipClass, ground);
  return {
    position: [east, north, up - reach],
    velocity: rotate(toLocal, minus(ship.relativeVelocity, groundVelocity)),
    top: rotate(toLocal, rotate(ship.attitude, [0, 0, 1])),
    spin: rotate(toLocal, minus(ship.angularVelocity, body.angularVelocity)),
  };
}

/** A vector of the site's [east, north, up] in ICRF axes; `ground.body` in its attitude at that instant. */
export function siteToIcrf(vector: Vec3, ground: Ground): Vec3 {
  return rotate(localAxes(ground), vector);
}

/** Turns [east, north, up] of the site into ICRF: body attitude · longitude about Y · −latitude about X. */
function localAxes({ body, site }: Ground): Quat {
  const meridian = rotationAbout([0, 1, 0], site.longitude);
  return compose(body.attitude, compose(meridian, rotationAbout([1, 0, 0], -site.latitude)));
}

/** Distance from the body's centre to the centre of mass of an upright ship that touches the ground at the site, m. */
function surfaceReach(shipClass: ShipClass, { body, site, terrainHeight }: Ground): number {
  const level = cosineOfDegrees(site.latitude);
  const nx = level * sineOfDegrees(site.longitude);
  const ny = sineOfDegrees(site.latitude);
  const nz = level * cosineOfDegrees(site.longitude);
  return body.radius + terrainHeight(body.name, nx, ny, nz) + shipClass.groundContactOffset;
}

function rotationAbout([x, y, z]: Vec3, degrees: number): Quat {
  const s = sineOfDegrees(degrees / 2);
  return [x * s, y * s, z * s, cosineOfDegrees(degrees / 2)];
}
