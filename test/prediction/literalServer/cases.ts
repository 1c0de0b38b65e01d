import {
  type Body,
  type BodyMotion,
  cosineOfDegrees,
  sineOfDegrees,
  type TerrainHeight,
  type Vec3,
} from '../../../src/dynamics';
import type { Site } from '../../../src/scenarios';
import type { LiteralOptions } from './literalServer';
import { cross, dot, scale } from './vectors';

/** One way in which the game's server may differ from its client's model (PREDICTION, Learned ground). */
export interface LiteralCase {
  readonly name: string;
  readonly options: Partial<Omit<LiteralOptions, 'terrainHeight' | 'hz' | 'every'>>;
  /** Its ground above the client's, m, at metres east and north of the site. */
  readonly rise?: (east: number, north: number) => number;
  /** Share of sends that are missed. */
  readonly missed?: number;
  /** Its frames have no tick rate. */
  readonly omitsTickRate?: boolean;
  /** Each ship in its own message. */
  readonly oneMessagePerShip?: boolean;
  /** From the third landed state on it is settled, not from the third of a contact. */
  readonly settlesLanded?: boolean;
  /** Scenarios that show it; the usual ones by default. */
  readonly flights?: readonly string[];
}

export const USUAL_FLIGHTS = ['opening', 'settle', 'bounce', 'slide'];

const bumps = (east: number, north: number): number =>
  0.5 * Math.sin((2 * Math.PI * east) / 40) * Math.cos((2 * Math.PI * north) / 55);

export const CASES: readonly LiteralCase[] = [
  { name: 'as told', options: {} },
  ...[0.05, -0.05, 0.5, -0.5, 1, -1].map((metres) => ({
    name: `ground ${metres > 0 ? '+' : '−'}${Math.abs(metres)} m`,
    options: {},
    rise: () => metres,
  })),
  { name: 'slope 5 %', options: {}, rise: (east, north) => 0.05 * (0.8 * east + 0.6 * north) },
  { name: 'bumps 0.5 m', options: {}, rise: bumps },
  { name: 'friction 0.4', options: { frictionKinetic: 0.4 } },
  { name: 'mass 5 % off', options: { massFactor: 1.05 }, flights: ['freighter-hold', 'launch'] },
  { name: 'spring × 2', options: { spring: 200 } },
  { name: 'damping 1', options: { damping: 1 } },
  { name: 'controller gains × 2', options: { gain: 2 }, flights: ['freighter-hold'] },
  { name: 'time scale 1.05 not told', options: { timeScale: 1.05 } },
  { name: 'time scale 10 not told', options: { timeScale: 10 } },
  {
    name: 'spin 1 % off, attitudes true',
    options: { spinFactor: 1.01, tellsAttitude: true },
    settlesLanded: true,
    flights: ['slide-mars'],
  },
  {
    name: 'spin 1 % off, attitudes made of it',
    options: { spinFactor: 1.01 },
    settlesLanded: true,
    flights: ['slide-mars'],
  },
  { name: 'tick rate not sent', options: {}, omitsTickRate: true },
  { name: 'tick rate not sent, sends missed 20 %', options: {}, omitsTickRate: true, missed: 0.2 },
  { name: 'bodies not sent', options: { sendsBodies: false } },
  { name: 'sends missed 20 %', options: {}, missed: 0.2 },
  { name: 'sends missed 50 %', options: {}, missed: 0.5 },
  { name: 'one message a ship', options: {}, oneMessagePerShip: true },
];

export const FAITHFUL: Omit<LiteralOptions, 'terrainHeight' | 'hz' | 'every'> = {
  frictionStatic: 0.8,
  frictionKinetic: 0.5,
  spring: 100,
  damping: 0.3,
  massFactor: 1,
  gain: 1,
  aligned: true,
  timeScale: 1,
  sendsBodies: true,
  spinFactor: 1,
  tellsAttitude: false,
};

/** The server's ground: the client's plus `rise`. */
export function groundOf(
  terrainHeight: TerrainHeight,
  rise: LiteralCase['rise'],
  { body, site }: { readonly body: Body & BodyMotion; readonly site: Site },
): TerrainHeight {
  if (rise === undefined) return terrainHeight;
  const level = cosineOfDegrees(site.latitude);
  const up: Vec3 = [
    level * sineOfDegrees(site.longitude),
    sineOfDegrees(site.latitude),
    level * cosineOfDegrees(site.longitude),
  ];
  const eastward = cross([0, 1, 0], up);
  const east = scale(eastward, 1 / Math.sqrt(dot(eastward, eastward)));
  const north = cross(up, east);
  return (name, nx, ny, nz) => {
    const n: Vec3 = [nx, ny, nz];
    return terrainHeight(name, nx, ny, nz) + rise(dot(n, east) * body.radius, dot(n, north) * body.radius);
  };
}
