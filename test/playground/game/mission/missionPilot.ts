import { type Controls, GRAVITATIONAL_CONSTANT, NEUTRAL_CONTROLS, type Vec3 } from '../../../../src/dynamics';
import type { WorldView } from '../../../../src/prediction';
import type { Target } from '../../../../src/readout';
import type { Mission } from '../../../../src/scenarios';

/** Largest descent speed, m/s, and the speed of the last metres. */
const FAST = 12;
const TOUCH = 0.8;
/** m: descends below this only over the pad. */
const CLEARANCE = 18;
/** m/s along the ground above which the main engine brakes. */
const DRIFTING = 8;

type Vector = ArrayLike<number>;

const dot = (a: Vector, b: Vector) => a[0]! * b[0]! + a[1]! * b[1]! + a[2]! * b[2]!;
const along = (a: Vector, s: number, b: Vector = [0, 0, 0]): Vec3 => [
  a[0]! * s + b[0]!,
  a[1]! * s + b[1]!,
  a[2]! * s + b[2]!,
];
const limited = (a: Vec3, most: number) => along(a, Math.min(1, most / (Math.hypot(...a) || 1)));
const clamp = (value: number, low: number, high: number) => Math.min(Math.max(value, low), high);

/** Turns a vector by the inverse of an attitude [x, y, z, w]: ICRF to ship axes. */
function toShip([x, y, z, w]: readonly [number, number, number, number], v: Vec3): Vec3 {
  const [qx, qy, qz] = [-x, -y, -z];
  const t: Vec3 = [2 * (qy * v[2] - qz * v[1]), 2 * (qz * v[0] - qx * v[2]), 2 * (qx * v[1] - qy * v[0])];
  return [
    v[0] + w * t[0] + qy * t[2] - qz * t[1],
    v[1] + w * t[1] + qz * t[0] - qx * t[2],
    v[2] + w * t[2] + qx * t[1] - qy * t[0],
  ];
}

/** The flight as a pilot sees it, m and m/s over the ground. */
interface Seen {
  readonly up: Vec3;
  readonly height: number;
  readonly climb: number;
  readonly drift: Vec3;
  readonly toPad: Vec3;
  readonly gravity: number;
  readonly mass: number;
}

function look(view: WorldView, target: Target): Seen {
  const own = view.own!;
  const body = view.bodies[own.body]!;
  const distance = Math.hypot(...own.position);
  const up = along(own.position, 1 / distance);
  const [wx, wy, wz] = body.angularVelocity;
  const [x, y, z] = own.position as unknown as Vec3;
  const overGround = along([wy * z - wz * y, wz * x - wx * z, wx * y - wy * x], -1, own.velocity);
  const climb = dot(overGround, up);
  const away = along(own.position, -1, target.place);
  return {
    up,
    height: own.feetHeight,
    climb,
    drift: along(up, -climb, overGround),
    toPad: along(up, -dot(away, up), away),
    gravity: (GRAVITATIONAL_CONSTANT * body.mass) / distance ** 2,
    mass: own.shipClass.dryMass + own.fuel,
  };
}

/**
 * Flies a mission by the displays: over the pad by thrusters (by the main engine, against its motion, when fast), then
 * straight down; takes off again from all pads but the last. Controls are on the page's grid.
 */
export function pilot(view: WorldView, target: Target, mission: Mission): Controls {
  const own = view.own;
  if (own === null) return NEUTRAL_CONTROLS;
  const upright: Controls = { ...NEUTRAL_CONTROLS, attitudeMode: 'radial', attitudeHold: true };
  const seen = look(view, target);
  const off = Math.hypot(...seen.toPad);
  const isOver = off < target.radius / 3;
  if (own.surfaceContactState === 'landed' && isOver) return upright;
  if (own.surfaceContactState !== '' && own.surfaceContactState !== 'landed') return upright;
  const speed = Math.hypot(...seen.drift);
  const thrust = own.shipClass.mainEngineThrust / seen.mass;
  if (speed > DRIFTING && off < speed ** 2 / 4 + 4 * speed)
    return {
      ...upright,
      attitudeMode: 'surface_retrograde',
      thrustLevel: grid(clamp(5 / thrust, 0, 1), 200),
    };
  const [rcs] = own.shipClass.rcsThrust;
  const wanted = limited(
    along(seen.toPad, 0.12),
    Math.max(3, Math.min(9, Math.sqrt((rcs / seen.mass) * off))),
  );
  const push = toShip(
    own.attitude as unknown as [number, number, number, number],
    along(seen.drift, -1, wanted),
  );
  const fall = fallSpeed(seen, mission, isOver, thrust - seen.gravity);
  const wantedLift = seen.gravity + 0.8 * (-fall - seen.climb);
  return {
    ...upright,
    thrustLevel: grid(clamp(wantedLift / thrust, 0, 1), 200),
    translationInput: [
      grid(clamp((0.6 * push[0] * seen.mass) / rcs, -1, 1), 100),
      grid(clamp((0.6 * push[1] * seen.mass) / own.shipClass.rcsThrust[1], -1, 1), 100),
      grid(clamp(Math.min(0, (wantedLift * seen.mass) / own.shipClass.rcsThrust[2]), -1, 1), 100),
    ],
  };
}

/** m/s downward. */
function fallSpeed({ height }: Seen, { done }: Mission, isOver: boolean, reserve: number): number {
  if (done.kind === 'hover') return clamp((height - (done.low + done.high) / 2) / 4, -3, FAST);
  const floor = isOver && done.kind === 'land' ? 1 : CLEARANCE;
  if (height < floor && floor > 1) return clamp((height - floor) / 3, -4, 0);
  const braking = clamp(0.4 * reserve, 0.05, 2);
  return Math.min(FAST, Math.sqrt(TOUCH ** 2 + 2 * braking * Math.max(0, height - floor)));
}

function grid(value: number, steps: number): number {
  return Math.round(value * steps) / steps + 0;
}
