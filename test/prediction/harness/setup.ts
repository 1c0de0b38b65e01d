import {
  type Body,
  BODIES,
  type BodyMotion,
  type Controls,
  NEUTRAL_CONTROLS,
  SHIP_CLASSES,
  type ShipClass,
  type TerrainHeight,
} from '../../../src/index';
import { type DesignBody, type DesignShip } from './design/law';
import { createDesignServer, type DesignServer, type SendsBodies } from './design/server';
import type { Dice } from './random';
import type { WayOptions } from './wire';
import {
  conjugate,
  cross,
  dot,
  plus,
  times,
  type Turn,
  turned,
  turnOn,
  unit,
  type Vec,
} from './design/vectors';

/** One world, server, network and page, drawn from a seed. */
export interface Setup {
  readonly server: DesignServer;
  readonly told: Body & BodyMotion;
  readonly network: WayOptions;
  readonly answersPings: boolean;
  /** How frames come in: the game's JSON, or bytes that are decoded when they are needed. */
  readonly door: 'json' | 'bytes';
  /** Grain of the page's clock, s. */
  readonly grain: number;
  /** The server's ground above the client's: an offset, m, and a slope. */
  readonly rise: { readonly offset: number; readonly slope: number };
  readonly clientTerrain: TerrainHeight;
  readonly label: string;
}

export const OWN = 'own-1';
export const OTHER = 'other-2';

export const NETWORKS: Readonly<Record<string, WayOptions>> = {
  near: { delay: 0.003, jitter: 0.0005, resent: 0, resend: 0 },
  home: { delay: 0.018, jitter: 0.004, resent: 0.002, resend: 0.2 },
  mobile: { delay: 0.06, jitter: 0.012, resent: 0.02, resend: 0.25 },
  far: { delay: 0.28, jitter: 0.02, resent: 0.005, resend: 0.6 },
};

/** Hz. With one step a tick the design's ship hops on its spring for ever at 20 Hz, and at 10 Hz is thrown off. */
export const TICK_RATES = [40, 50, 100];
/** Hz */
const SEND_RATES = [0.1, 0.25, 0.5, 1, 2, 5, 10, 20];
const DRIFT = 5e-4;

/** A body that the server may move. */
export function designBody(told: Body & BodyMotion): DesignBody {
  return {
    ...told,
    position: [...told.position],
    velocity: [...told.velocity],
    attitude: [...told.attitude],
    angularVelocity: [...told.angularVelocity],
  };
}

export function drawSetup(dice: Dice): Setup {
  const tickRate = dice.pick(TICK_RATES);
  const sendRate = dice.pick(SEND_RATES);
  const networkName = dice.pick(Object.keys(NETWORKS));
  const told = dice.pick(BODIES.filter(({ name }) => name === 'Luna' || name === 'Mars'));
  const shipClass = dice.pick(SHIP_CLASSES);
  const rise = drawRise(dice);
  const sendsBodies = dice.pick<SendsBodies>(['all', 'all', 'turnless', 'none']);
  const door = sendsBodies === 'all' && dice.chance(0.3) ? 'bytes' : 'json';
  const site = unit([dice.between(-1, 1), dice.between(-0.8, 0.8), dice.between(-1, 1)]);
  const clientTerrain: TerrainHeight = dice.chance(0.5) ? () => 0 : wavesAt(site, told.radius);
  const terrainHeight = risen(clientTerrain, rise, { site, radius: told.radius });
  const body = designBody(told);
  const place = { site, body, terrainHeight };
  const ships = [OWN, OTHER].map((id, k) => placeShip(dice, { ...place, id, shipClass, aside: 80 * k }));
  const server = createDesignServer(body, ships, {
    terrainHeight,
    tickRate,
    timeScale: 1,
    sendRate,
    sendsBodies,
    drift: dice.pick([0, 0, DRIFT, -DRIFT]),
    sendsScale: door === 'bytes' || dice.chance(0.7),
  });
  const answersPings = dice.chance(0.6);
  const grain = dice.pick([0, 0, 0, 0.001, 0.016, 0.1]);
  const { drift, sendsScale } = server.options;
  const label = [
    `${told.name}, ${shipClass.name}, ${tickRate} Hz sent at ${sendRate} Hz, ${networkName}, ${door}`,
    `bodies ${sendsBodies}, ${sendsScale ? '' : 'no '}scale, ${answersPings ? '' : 'no '}pongs, drift ${drift}, grain ${grain}`,
    `ground ${rise.offset.toFixed(2)} m, slope ${(100 * rise.slope).toFixed(1)} %`,
  ].join('; ');
  return {
    server,
    told,
    network: NETWORKS[networkName]!,
    answersPings,
    door,
    grain,
    rise,
    clientTerrain,
    label,
  };
}

function drawRise(dice: Dice): Setup['rise'] {
  const kind = dice.pick(['same', 'same', 'offset', 'slope', 'both']);
  const offset = kind === 'offset' || kind === 'both' ? dice.between(-1, 1) : 0;
  const slope = kind === 'slope' || kind === 'both' ? dice.between(-0.05, 0.05) : 0;
  return { offset, slope };
}

/** Gentle waves, 1 m high and 400 m long. */
function wavesAt(site: Vec, radius: number): TerrainHeight {
  const [e, n] = alongGround(site);
  return (_, x, y, z) => {
    const at: Vec = [x, y, z];
    return Math.sin((dot(at, e) * radius) / 64) * Math.cos((dot(at, n) * radius) / 64);
  };
}

function risen(
  terrain: TerrainHeight,
  { offset, slope }: Setup['rise'],
  { site, radius }: { readonly site: Vec; readonly radius: number },
): TerrainHeight {
  const [e] = alongGround(site);
  return (name, x, y, z) => terrain(name, x, y, z) + offset + slope * dot([x, y, z], e) * radius;
}

function alongGround(site: Vec): [Vec, Vec] {
  const e = unit(cross([0, 1, 0], site));
  return [e, cross(site, e)];
}

interface Placing {
  readonly id: string;
  readonly shipClass: ShipClass;
  readonly site: Vec;
  readonly body: DesignBody;
  readonly terrainHeight: TerrainHeight;
  /** m east of the site. */
  readonly aside: number;
}

/** Above the ground, coming down, nearly upright. */
export function placeShip(dice: Dice, placing: Placing): DesignShip {
  const { id, shipClass, site, body, terrainHeight, aside } = placing;
  const normal = unit(plus(site, times(alongGround(site)[0], aside / body.radius)));
  const [nx, ny, nz] = normal;
  const up = turned(body.attitude, normal);
  const [east, north] = alongGround(up);
  const height = dice.logBetween(4, 150);
  const ground = body.radius + terrainHeight(body.name, nx, ny, nz) + shipClass.groundContactOffset;
  const r = times(up, ground + height);
  const along = plus(times(east, dice.between(-6, 6)), times(north, dice.between(-6, 6)));
  const speed = plus(times(up, -dice.between(0, 12)), along);
  return {
    id,
    shipClass,
    fuel: shipClass.fuelCapacity * dice.between(0.3, 1),
    state: '',
    crashed: false,
    impact: 0,
    pin: null,
    angularVelocity: [0, 0, 0],
    position: plus(body.position, r),
    velocity: plus(body.velocity, plus(speed, cross(body.angularVelocity, r))),
    attitude: turnOn(noseAlong(up), times(east, dice.between(-0.1, 0.1)), 1),
    controls: NEUTRAL_CONTROLS,
  };
}

/** The shortest turn of body +Z onto `up`. */
function noseAlong(up: Vec): Turn {
  const axis = cross([0, 0, 1], up);
  return turnOn([0, 0, 0, 1], times(unit(axis), Math.acos(up[2])), 1);
}

/** What a pilot does next, and for how long, s. */
export function drawControls(dice: Dice): { readonly controls: Controls; readonly seconds: number } {
  const attitudeHold = dice.chance(0.7);
  const calm: Controls = { ...NEUTRAL_CONTROLS, attitudeHold };
  const kind = dice.pick(['calm', 'calm', 'engine', 'side', 'stick']);
  if (kind === 'engine')
    return { controls: { ...calm, thrustLevel: dice.between(0.1, 0.4) }, seconds: dice.between(0.3, 1) };
  if (kind === 'side')
    return {
      controls: { ...calm, translationInput: [dice.pick([-1, 1]), 0, 0] },
      seconds: dice.between(0.3, 2),
    };
  if (kind === 'stick')
    return {
      controls: { ...calm, rotationInput: [dice.between(-0.3, 0.3), 0, 0] },
      seconds: dice.between(0.1, 0.4),
    };
  return { controls: calm, seconds: dice.between(0.5, 4) };
}

/** Height of a place above the ground of the client, m. */
export function aboveGround(terrain: TerrainHeight, body: DesignBody, attitude: Turn, position: Vec): number {
  const [nx, ny, nz] = turned(conjugate(attitude), unit(position));
  return Math.hypot(...position) - body.radius - terrain(body.name, nx, ny, nz);
}
