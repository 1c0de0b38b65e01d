import type { BodyState, ShipState } from '../../../wire';
import type { Warn } from '../../warnings';

/** A known body. One that frames do not carry has no position: it has moved since it was passed. */
export type KnownBody = Omit<BodyState, 'position'> & {
  readonly position?: BodyState['position'] | undefined;
};

type Vector = readonly [number, number, number];

const minus = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const times = (a: Vector, k: number): Vector => [a[0] * k, a[1] * k, a[2] * k];
const lengthOf = (v: readonly number[]): number => Math.hypot(...v);

/** rad/s: two turns per second, more than any thrusters reach. */
const MAX_SPIN = 12.6;
/** m above or below the body's radius at which a ship can be landed: the highest mountains. */
const MAX_GROUND_HEIGHT = 30_000;
/** m/s: a landing ship moves no faster than this relative to its body. */
const FAST = 10_000;

/** Warns of an implausible ship state: wrong units, order of components or frame. Malformed states are refused elsewhere. */
export function checkShip(warn: Warn, ship: ShipState, bodies: readonly KnownBody[]): void {
  const { shipId } = ship;
  const size = lengthOf(ship.attitude);
  if (Math.abs(size - 1) > 1e-3)
    warn('attitude-not-unit', `The attitude of ${shipId} has length ${size}: expected a unit quaternion.`, {
      shipId,
      value: ship.attitude,
    });
  const spin = lengthOf(ship.angularVelocity);
  if (spin > MAX_SPIN)
    warn('spin-in-degrees', `${shipId} turns by ${spin} rad/s: pass radians, not degrees.`, {
      shipId,
      value: ship.angularVelocity,
    });
  const [x, y, z, w] = ship.attitude;
  const isFirst = x === 1 && y === 0 && z === 0 && w === 0;
  // [0, 0, 0, 1] read as a list of JSON, which begins with w.
  const isThird = z === 1 && x === 0 && y === 0 && w === 0;
  if (isFirst || isThird) warnOfOrder(warn, ship);
  checkCommands(warn, ship);
  const near = nearestBody(ship.position, bodies);
  if (near !== null && !warnOfKilometres(warn, ship, near, bodies)) checkPlace(warn, ship, near);
  checkRelative(warn, ship, bodies);
}

function warnOfOrder(warn: Warn, { shipId, attitude }: ShipState): void {
  const message = `The attitude of ${shipId} is in another order: records have [x, y, z, w], lists in JSON [w, x, y, z].`;
  warn('quaternion-order', message, { shipId, value: attitude });
}

/** The body whose ground is nearest, if any has a position. */
function nearestBody(position: Vector, bodies: readonly KnownBody[]): BodyState | null {
  let best: BodyState | null = null;
  let least = Infinity;
  for (const body of bodies) {
    if (!isPlaced(body)) continue;
    const height = Math.abs(lengthOf(minus(position, body.position)) - body.radius);
    if (height >= least) continue;
    least = height;
    best = body;
  }
  return best;
}

function isPlaced(body: KnownBody): body is BodyState {
  return Array.isArray(body.position);
}

/** Warns of a position in km: relative to `near`, or to ICRF, where any body may be the one meant. Returns whether it did. */
function warnOfKilometres(
  warn: Warn,
  { shipId, position }: ShipState,
  near: BodyState,
  bodies: readonly KnownBody[],
): boolean {
  const distance = lengthOf(minus(position, near.position));
  const meant = nearestBody(times(position, 1000), bodies) ?? near;
  const enlarged = lengthOf(minus(times(position, 1000), meant.position));
  const isRelative = Math.abs((distance * 1000) / near.radius - 1) < 0.3;
  const isIcrf = distance > 10 * near.radius && enlarged < 2 * meant.radius;
  if (!isRelative && !isIcrf) return false;
  const { name } = isRelative ? near : meant;
  const message = `${shipId} would be near ${name} at a thousand times its position: pass metres, not km.`;
  warn('position-in-kilometres', message, { shipId, value: position });
  return true;
}

function checkPlace(warn: Warn, ship: ShipState, body: BodyState): void {
  const { shipId } = ship;
  const from = minus(ship.position, body.position);
  const distance = lengthOf(from);
  if (distance < 0.5 * body.radius)
    warn('ship-inside-body', `${shipId} is inside ${body.name}: positions are ICRF metres, not relative.`, {
      shipId,
      body: body.name,
      value: ship.position,
    });
  const speed = lengthOf(minus(ship.velocity, body.velocity));
  const enlargedSpeed = lengthOf(minus(times(ship.velocity, 1000), body.velocity));
  if (distance < 2 * body.radius && speed > FAST && enlargedSpeed < FAST)
    warn(
      'velocity-in-kilometres',
      `${shipId} moves at ${speed} m/s relative to ${body.name}: pass m/s, not km/s.`,
      {
        shipId,
        value: ship.velocity,
      },
    );
  else if (distance < 2 * body.radius) checkFrame(warn, ship, body, speed);
  if (ship.landedBodyName === body.name) checkLanded(warn, ship, { body, from, distance });
}

/** A ship near a fast body that has almost none of its velocity: the velocity is relative to the body. */
function checkFrame(warn: Warn, { shipId, velocity }: ShipState, body: BodyState, speed: number): void {
  const own = lengthOf(body.velocity);
  if (own < FAST || lengthOf(velocity) > 0.3 * own) return;
  const message = `${shipId} moves at ${speed} m/s relative to ${body.name}: velocity is ICRF; one relative to the body goes into relativeVelocity.`;
  warn('velocity-frame', message, { shipId, value: velocity, speed });
}

interface Landed {
  readonly body: BodyState;
  readonly from: Vector;
  readonly distance: number;
}

function checkLanded(warn: Warn, ship: ShipState, { body, from, distance }: Landed): void {
  const height = distance - body.radius;
  if (Math.abs(height) > MAX_GROUND_HEIGHT && distance > 0.5 * body.radius) {
    const message = `${ship.shipId} is on the ground of ${body.name}, ${height} m from its radius: are ship and bodies of the same tick?`;
    warn('landed-off-ground', message, { shipId: ship.shipId, height });
  }
  if (ship.surfaceContactState !== 'landed' && ship.surfaceContactState !== '') return;
  const [x, y, z, w] = ship.attitude;
  const upright = along([x, y, z, w], from) / distance;
  const reordered = along([y, z, w, x], from) / distance;
  if (upright < 0.5 && reordered > 0.98) warnOfOrder(warn, ship);
}

/** The component along `v` of the ship's +Z axis, its up; the quaternion is [x, y, z, w]. */
function along([x, y, z, w]: readonly [number, number, number, number], v: Vector): number {
  return 2 * (x * z + w * y) * v[0] + 2 * (y * z - w * x) * v[1] + (1 - 2 * (x * x + y * y)) * v[2];
}

function checkRelative(warn: Warn, ship: ShipState, bodies: readonly KnownBody[]): void {
  const { shipId, relativePosition, referenceBody, landedBodyName } = ship;
  if (Array.isArray(relativePosition)) {
    const body = bodies.find(({ name }) => name === referenceBody);
    const distance = lengthOf(relativePosition as Vector);
    if (body !== undefined) checkBothPlaces(warn, ship, body);
    if (body !== undefined && distance < 0.01 * body.radius)
      warn(
        'position-in-kilometres',
        `${shipId} is ${distance} m from the centre of ${referenceBody}: metres, not km.`,
        {
          shipId,
          value: relativePosition,
        },
      );
  }
  const named = landedBodyName || referenceBody;
  if (bodies.length > 0 && named !== '' && !bodies.some(({ name }) => name === named))
    warn(
      'body-unknown',
      `${shipId} is at ${named}, which is not among the bodies: list it in defaults.bodies, the hello or each frame.`,
      {
        shipId,
        body: named,
      },
    );
}

/** The position relative to the body may differ from the ICRF one, m, by a double's resolution there and by the body's motion in a tick. */
const PLACES_APART = 100_000;

function checkBothPlaces(warn: Warn, ship: ShipState, body: KnownBody): void {
  const { shipId, position, relativePosition } = ship;
  if (!isPlaced(body)) return;
  const apart = lengthOf(minus(minus(position, body.position), relativePosition as Vector));
  if (apart <= PLACES_APART) return;
  const message = `relativePosition of ${shipId} and its position are ${apart} m apart: relativePosition is relative to the centre of ${body.name}, in ICRF axes.`;
  warn('relative-position', message, { shipId, position, relativePosition });
}

function checkCommands(warn: Warn, ship: ShipState): void {
  const { shipId, thrustLevel, rotationInput, translationInput, fuel } = ship;
  const largest = Math.max(thrustLevel, ...[...rotationInput, ...translationInput].map(Math.abs));
  if (largest > 1.001 || thrustLevel < 0)
    warn(
      'state-out-of-range',
      `${shipId} has a control of ${largest}: expected 0 (thrustLevel) or −1 to 1, not percent.`,
      {
        field: 'controls',
        shipId,
        thrustLevel,
        rotationInput,
        translationInput,
      },
    );
  if (fuel < 0)
    warn('state-out-of-range', `${shipId} has ${fuel} kg of fuel: expected 0 or more.`, {
      field: 'fuel',
      shipId,
      fuel,
    });
}
