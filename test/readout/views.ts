/** Hand-built views for the readouts' and HUDs' tests: a position on a body, a velocity relative to the ground, a lean. */
import {
  BODIES,
  DEFAULT_SETTINGS,
  loadSettings,
  loadShipClass,
  NEUTRAL_CONTROLS,
  type Settings,
  SHIP_CLASSES,
  type SurfaceState,
} from '../../src/dynamics';
import type { Diagnosis, ShipView, WorldView } from '../../src/prediction';

export interface Pose {
  body?: 'Luna' | 'Earth' | 'Mars' | 'Phobos';
  shipClass?: 'fast_frigate' | 'cargo_hauler' | 'planetary_lander';
  /** kg; half the capacity by default. */
  fuel?: number;
  /** Terrain under the ship, m. */
  terrain?: number;
  /** ‖r‖ − surface_r, m: 0 at a touch, negative in the ground. */
  clearance?: number;
  /** Relative to the turning ground, m/s. */
  east?: number;
  north?: number;
  up?: number;
  /** Degrees, leaning towards `leanTo` degrees of azimuth (0 north, 90 east). */
  tilt?: number;
  leanTo?: number;
  /** Degrees the ship is rolled about its own Z before it leans. */
  heading?: number;
  /** rad/s relative to the ground: about the tilt axis (positive = leaning further), about local up. */
  tiltRate?: number;
  yawRate?: number;
  /** N along local up. */
  lift?: number;
  state?: SurfaceState;
  settings?: Partial<Settings>;
}

export const NO_TOUCHDOWN: ShipView['touchdown'] = {
  known: false,
  outcome: 'open',
  verticalSpeed: 0,
  horizontalSpeed: 0,
  bounces: 0,
  slideMetres: 0,
  settleSeconds: 0,
  largestTilt: 0,
};

type Triple = [number, number, number];

/** A direction without zeros, so that swapped axes show. */
export const NORMAL: Triple = [0.36, 0.48, 0.8];
const EAST: Triple = unit(crossed([0, 1, 0], NORMAL));
const NORTH: Triple = crossed(NORMAL, EAST);

export function makeView(pose: Pose = {}, changes: Partial<ShipView> = {}): WorldView & { own: ShipView } {
  const settings = loadSettings({ ...DEFAULT_SETTINGS, ...pose.settings });
  if (!settings.ok) throw new Error(settings.reason);
  const body = BODIES.findIndex((b) => b.name === (pose.body ?? 'Luna'));
  const own = makeShip(pose, changes);
  return {
    tick: 100,
    sinceTick: 0.25,
    tickRate: 1,
    timeScale: 1,
    paused: false,
    ready: true,
    connection: 'live',
    silence: 0,
    settings: settings.value,
    bodies: BODIES.map((b) => ({ ...b })),
    ships: [{ ...own, body }],
    own: { ...own, body },
    diagnosis: {} as Diagnosis,
  };
}

export function makeShip(pose: Pose = {}, changes: Partial<ShipView> = {}): ShipView {
  const body = BODIES.find((b) => b.name === (pose.body ?? 'Luna'))!;
  const given = SHIP_CLASSES.find((c) => c.name === (pose.shipClass ?? 'planetary_lander'))!;
  const shipClass = loadShipClass(given);
  if (!shipClass.ok) throw new Error(shipClass.reason);
  const ground = body.radius + (pose.terrain ?? 0);
  const distance = ground + shipClass.value.groundContactOffset + (pose.clearance ?? 0);
  const position = scaled(NORMAL, distance);
  const turning = crossed([...body.angularVelocity], position);
  const east = scaled(EAST, pose.east ?? 0);
  const north = scaled(NORTH, pose.north ?? 0);
  const up = scaled(NORMAL, pose.up ?? 0);
  const velocity = turning.map((v, k) => v + east[k]! + north[k]! + up[k]!);
  const azimuth = ((pose.leanTo ?? 0) * Math.PI) / 180;
  const towards = NORTH.map((v, k) => v * Math.cos(azimuth) + EAST[k]! * Math.sin(azimuth)) as Triple;
  const tiltAxis = crossed(NORMAL, towards);
  const upright = rotationFromZ(NORMAL);
  const rolled = multiplied(upright, aboutAxis([0, 0, 1], ((pose.heading ?? 0) * Math.PI) / 180));
  const attitude = multiplied(aboutAxis(tiltAxis, ((pose.tilt ?? 0) * Math.PI) / 180), rolled);
  const spin = [...body.angularVelocity].map(
    (v, k) => v + tiltAxis[k]! * (pose.tiltRate ?? 0) + NORMAL[k]! * (pose.yawRate ?? 0),
  );
  const state = pose.state ?? '';
  const { groundContactOffset: h, legRadius } = given;
  const lean = ((pose.tilt ?? 0) * Math.PI) / 180;
  const lowestFoot = h * Math.cos(lean) + legRadius * Math.sin(lean);
  return {
    shipId: 'ship-1',
    name: 'Kestrel',
    own: true,
    shipClass: shipClass.value,
    body: 0,
    position: Float64Array.from(position),
    velocity: Float64Array.from(velocity),
    attitude: Float64Array.from(attitude),
    angularVelocity: Float64Array.from(spin),
    wheelMomentum: new Float64Array(3),
    fuel: pose.fuel ?? given.fuelCapacity / 2,
    impactSpeed: 0,
    surfaceContactState: state,
    crashed: false,
    controls: NEUTRAL_CONTROLS,
    thrust: Float64Array.from(scaled(NORMAL, pose.lift ?? 0)),
    groundRadius: ground,
    groundNormal: Float64Array.from(NORMAL),
    groundContactOffset: given.groundContactOffset,
    groundOffset: 0,
    groundConfidence: 0,
    extrapolated: '',
    extrapolatedStates: 0,
    feetHeight: (pose.clearance ?? 0) + h - lowestFoot,
    easedPosition: Float64Array.from(position),
    meshAttitude: Float64Array.from(attitude),
    meshPosition: Float64Array.from(position),
    legCompression: new Float64Array(4),
    shownState: state,
    provenance: 'confirmed',
    age: 0.4,
    withdrawn: '',
    touchdown: NO_TOUCHDOWN,
    serverPosition: Float64Array.from(position),
    serverAttitude: Float64Array.from(attitude),
    ghostPosition: Float64Array.from(position),
    ghostAttitude: Float64Array.from(attitude),
    serverKnown: true,
    missingSends: 0,
    ...changes,
  };
}

/** The same view `seconds` of game time later, the player's ship changed. */
export function later(view: WorldView, seconds: number, own: ShipView): WorldView & { own: ShipView } {
  const since = view.sinceTick + seconds;
  const ticks = Math.floor((since * view.tickRate) / view.timeScale);
  const sinceTick = since - (ticks * view.timeScale) / view.tickRate;
  const placed = { ...own, body: view.own?.body ?? own.body };
  return { ...view, tick: view.tick + ticks, sinceTick, ships: [placed], own: placed };
}

function scaled(v: Triple, by: number): Triple {
  return [v[0] * by, v[1] * by, v[2] * by];
}

function unit(v: Triple): Triple {
  return scaled(v, 1 / Math.hypot(...v));
}

export function crossed(a: readonly number[], b: readonly number[]): Triple {
  return [a[1]! * b[2]! - a[2]! * b[1]!, a[2]! * b[0]! - a[0]! * b[2]!, a[0]! * b[1]! - a[1]! * b[0]!];
}

type Rotation = [number, number, number, number];

function aboutAxis(axis: Triple, angle: number): Rotation {
  const s = Math.sin(angle / 2);
  return [axis[0] * s, axis[1] * s, axis[2] * s, Math.cos(angle / 2)];
}

function rotationFromZ(to: Triple): Rotation {
  const axis = crossed([0, 0, 1], to);
  return aboutAxis(unit(axis), Math.atan2(Math.hypot(...axis), to[2]));
}

export function multiplied(a: Rotation, b: Rotation): Rotation {
  return [
    a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
    a[3] * b[1] + a[1] * b[3] + a[2] * b[0] - a[0] * b[2],
    a[3] * b[2] + a[2] * b[3] + a[0] * b[1] - a[1] * b[0],
    a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2],
  ];
}
