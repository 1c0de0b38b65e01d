/** Draws a whole case: a ship in the air, near the ground, in it, landed, on its side, upside down, or between bodies. */
import {
  type Body,
  type BodyMotion,
  DEFAULT_SETTINGS,
  loadTiming,
  type Quat,
  type ShipClass,
  type ShipInit,
  type Vec3,
} from '../../../src/dynamics';
import { add, compose, cross, rotate } from '../../../src/authority';
import { createRandom, type Random } from '../../../src/scenarios';
import { between, chance, pick, tangent, triple, unitQuaternion, unitVector } from './draw';
import {
  drawBody,
  drawInputs,
  drawNeighbours,
  drawSettings,
  drawShipClass,
  drawTempo,
  drawTerrain,
} from './drawCraft';
import type { CaseTerrain, ExactCase } from './exactCase';
import { caseTerrain } from './playCase';

/** Approximate number of substeps per case. */
const LENGTH = 700;

const STARTS = [
  'flight',
  'approach',
  'approach',
  'contact',
  'contact',
  'landed',
  'tipped',
  'tipped',
  'tipped',
  'head',
  'transfer',
] as const;
type Start = (typeof STARTS)[number];

type MovingBody = Body & BodyMotion;

/** A place on a body. */
interface Place {
  readonly body: Body & BodyMotion;
  readonly terrain: CaseTerrain;
  /** Unit, ICRF. */
  readonly normal: Vec3;
}

/** The case of a seed. */
export function drawCase(seed: number): ExactCase {
  const rng = createRandom(seed);
  const start = pick(rng, STARTS);
  const shipClass = drawShipClass(rng);
  const settings = drawSettings(rng);
  const body = start === 'transfer' ? smallBody(rng) : drawBody(rng);
  const normal = chance(rng, 0.2) ? pick(rng, AXES) : unitVector(rng);
  const terrain = drawTerrain(rng, normal, body.radius);
  const alone = drawShip(rng, start, shipClass, { body, terrain, normal });
  const neighbours = start === 'transfer' ? drawNeighbours(rng, body) : [];
  const ship = neighbours[0] === undefined ? alone : betweenBodies(rng, alone, body, neighbours[0]);
  const bodies = chance(rng, 0.5) ? [body, ...neighbours] : [...neighbours, body];
  const { tickRate, timeScale } = drawTempo(rng);
  const timing = loadTiming(tickRate, timeScale, { ...DEFAULT_SETTINGS, ...settings });
  const substeps = timing.ok ? timing.value.substeps : 1;
  const ticks = Math.max(1, Math.round(LENGTH / substeps));
  const hover =
    ((shipClass.dryMass + ship.fuel) * 6.6743e-11 * body.mass) /
    (body.radius * body.radius * (shipClass.mainEngineThrust + 1));
  const inputs = drawInputs(rng, ticks, substeps, hover);
  const name = `${start}-${seed}`;
  return { name, tickRate, timeScale, ticks, settings, terrain, shipClass, bodies, ship, inputs };
}

/** Directions whose zeros and ones are the special cases of perpendicular axes. */
const AXES: readonly Vec3[] = [
  [1, 0, 0],
  [-1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
  [0, 0, -1],
];

function smallBody(rng: Random): Body & BodyMotion {
  const radius = between(rng, 300, 3000);
  return { ...drawBody(rng), name: 'first', radius, mass: radius * radius * between(rng, 1e8, 1e9) };
}

function drawShip(rng: Random, start: Start, shipClass: ShipClass, place: Place): ShipInit {
  const { body, normal } = place;
  const height = drawHeight(rng, start);
  const [nx, ny, nz] = rotate(
    [-body.attitude[0], -body.attitude[1], -body.attitude[2], body.attitude[3]],
    normal,
  );
  const ground = caseTerrain(place.terrain)(body.name, nx, ny, nz);
  // Its class's contact offset, or its own, which may be 0: the centre of mass on the ground.
  const groundContactOffset = chance(rng, 0.3) ? pick(rng, [0, between(rng, 0, 9)]) : null;
  const offset = groundContactOffset ?? shipClass.groundContactOffset;
  const reach = body.radius + ground + offset + height;
  const relativePosition: Vec3 = [normal[0] * reach, normal[1] * reach, normal[2] * reach];
  const rests = chance(rng, 0.2);
  const groundBound = start !== 'flight' && start !== 'transfer';
  const fall = groundBound ? between(rng, -drawSpeed(rng), 1) : between(rng, -300, 300);
  const slide = rests ? 0 : drawSpeed(rng);
  const along = tangent(rng, normal);
  const local: Vec3 = [0, 1, 2].map((k) => normal[k]! * fall + along[k]! * slide) as unknown as Vec3;
  const spin = rests ? ([0, 0, 0] as const) : triple(rng, pick(rng, [0.01, 0.2, 1.5]));
  const moves = start !== 'landed';
  const groundVelocity = cross(body.angularVelocity, relativePosition);
  const standsStill = start === 'flight' && chance(rng, 0.1);
  return {
    shipClass: shipClass.name,
    referenceBody: body.name,
    relativePosition,
    relativeVelocity: standsStill ? [0, 0, 0] : moves ? add(groundVelocity, local) : groundVelocity,
    attitude: drawAttitude(rng, start, normal),
    angularVelocity: moves ? add(body.angularVelocity, spin) : body.angularVelocity,
    fuel: shipClass.fuelCapacity * pick(rng, [0, 1e-6, 1e-5, 1e-4, 0.3, 1, 1.2]) * between(rng, 0.5, 1),
    wheelMomentum: drawWheels(rng, shipClass),
    ...(groundContactOffset !== null && { groundContactOffset }),
    surfaceContactState: stateOf(start),
    contactImpactSpeed: start === 'contact' ? drawSpeed(rng) : 0,
    crashed: false,
  };
}

/** Momentum of the wheels: none, up to their capacity, or more. */
function drawWheels(rng: Random, { reactionWheelCapacity, reactionWheelTorque }: ShipClass): Vec3 {
  const most = reactionWheelCapacity ?? reactionWheelTorque;
  const share = (): number => pick(rng, [0, -1, 1, between(rng, -1, 1), 1.5]);
  // + 0, since JSON, which Python reads, has no −0.
  return [most[0] * share() + 0, most[1] * share() + 0, most[2] * share() + 0];
}

/** On the way from its body to the neighbour, near the point where the reference body changes. */
function betweenBodies(rng: Random, ship: ShipInit, body: MovingBody, neighbour: MovingBody): ShipInit {
  const way = (body.radius / (body.radius + neighbour.radius)) * between(rng, 0.8, 1.2);
  const [x, y, z] = [0, 1, 2].map(
    (k) => (neighbour.position[k]! - body.position[k]!) * way,
  ) as unknown as Vec3;
  return { ...ship, relativePosition: [x, y, z] };
}

function stateOf(start: Start): ShipInit['surfaceContactState'] {
  if (start === 'contact' || start === 'landed' || start === 'tipped') return start;
  return start === 'head' ? 'tipped' : '';
}

/** Of the feet above the ground, m. */
function drawHeight(rng: Random, start: Start): number {
  if (start === 'flight') return between(rng, 100, 4000);
  if (start === 'approach') return between(rng, 0.01, 15);
  return -between(rng, -0.02, 0.3);
}

function drawSpeed(rng: Random): number {
  return between(rng, 0, pick(rng, [0.02, 0.4, 3, 12, 30, 70]));
}

/** Tilt of the start: 2 arctan k, up to about 40°, around 90°, upside down, or any. */
function drawAttitude(rng: Random, start: Start, normal: Vec3): Quat {
  if (start === 'flight' || start === 'transfer')
    return chance(rng, 0.2) ? [0, 0, 0, 1] : unitQuaternion(rng);
  const upright = compose(fromZTo(normal), yaw(rng));
  if (start === 'head' && chance(rng, 0.5)) return compose([...tangent(rng, normal), 0], upright);
  const k =
    start === 'head'
      ? between(rng, 2, 9)
      : start === 'tipped'
        ? between(rng, 0.5, 1.3)
        : between(rng, 0, 0.4);
  const axis = tangent(rng, normal);
  const length = Math.sqrt(1 + k * k);
  return compose(
    [(axis[0] * k) / length, (axis[1] * k) / length, (axis[2] * k) / length, 1 / length],
    upright,
  );
}

function yaw(rng: Random): Quat {
  const k = between(rng, -3, 3);
  const length = Math.sqrt(1 + k * k);
  return [0, 0, k / length, 1 / length];
}

/** The rotation that takes z to `n`. */
function fromZTo([x, y, z]: Vec3): Quat {
  return z > -0.99 ? compose([-y, x, 0, 1 + z], [0, 0, 0, 1]) : [1, 0, 0, 0];
}
