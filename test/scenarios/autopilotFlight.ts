import { type Authority, createAuthority, inverse, rotate, type SpawnOrder } from '../../src/authority';
import {
  BODIES,
  flatTerrain,
  type Settings,
  SHIP_CLASSES,
  type ShipClass,
  TERRAINS,
  type Vec3,
} from '../../src/dynamics';
import {
  BEGIN_LANDING,
  continueLanding,
  type LandingManeuver,
  type LandingSite,
  type LocalState,
  toBodyRelative,
} from '../../src/scenarios';
import type { BodyState, ShipState } from '../../src/wire';

export interface Flight {
  readonly body: string;
  readonly shipClass?: ShipClass;
  readonly tickRate: number;
  readonly initial?: Partial<LocalState>;
  readonly terrain?: string;
  readonly settings?: Partial<Settings>;
  /** Ticks from a state until the controls computed from it act. */
  readonly delay?: number;
  /** The autopilot plans without the delay. */
  readonly ignoresDelay?: boolean;
  /** Metres east and north of the start to land at; by default below the ship. */
  readonly target?: readonly [east: number, north: number];
  /** The ship is on the ground at the start. */
  readonly standing?: boolean;
  /** Like the game's own server, which sends ICRF only. */
  readonly legacy?: boolean;
}

export interface Flown {
  readonly maneuver: LandingManeuver;
  readonly ship: ShipState;
  /** The phases in their order. */
  readonly phases: readonly string[];
  /** Impact speed at the first touch, m/s. */
  readonly impact: number;
  readonly touches: number;
  /** Game seconds until the maneuver's end. */
  readonly seconds: number;
  /** m along the ground from the target at the end; NaN without one. */
  readonly off: number;
}

export const LANDER_CLASS = SHIP_CLASSES.find((shipClass) => shipClass.name === 'planetary_lander')!;

/** Flies a ship from 200 m down by the autopilot alone, its states and controls carried by an authority. */
export function flyDown(flight: Flight): Flown {
  const shipClass = flight.shipClass ?? LANDER_CLASS;
  const body = BODIES.find((candidate) => candidate.name === flight.body)!;
  const terrain = flight.terrain ?? 'flat';
  const made = createAuthority({
    shipClasses: [shipClass],
    bodies: [body],
    terrain,
    terrains: TERRAINS,
    settings: flight.settings ?? {},
    tickRate: flight.tickRate,
    timeScale: 1,
    legacy: flight.legacy ?? false,
  });
  if (!made.ok) throw new Error(made.reason);
  const authority = made.value;
  const reason = authority.spawn(order(flight, shipClass)) ?? '';
  const joined = authority.join('ann', 'one');
  if (reason !== '' || !joined.ok) throw new Error(reason);
  const terrainHeight = TERRAINS[terrain] ?? flatTerrain;
  const target = flight.target && placeOf(flight, shipClass);
  return fly(authority, { body, shipClass, terrainHeight, ...(target && { target }) }, flight);
}

function fly(
  authority: Authority,
  site: LandingSite,
  { delay = 0, tickRate, ignoresDelay: ignoresDelay = false }: Flight,
): Flown {
  const phases: string[] = [];
  let maneuver: LandingManeuver = BEGIN_LANDING;
  let [impact, touches, seq] = [0, 0, 0];
  for (let tick = 0; ; tick++) {
    const frame = authority.frameFor('ann')!;
    const ship = frame.ships[0]!;
    for (const event of frame.events) {
      if (event.type === 'ship.contact') touches++;
      if (event.type === 'ship.contact' && touches === 1) impact = ship.contactImpactSpeed ?? 0;
    }
    const lag = ignoresDelay ? 0 : (delay + 0.5) / tickRate;
    const next = continueLanding(maneuver, ship, { ...site, body: frame.bodies[0]!, delay: lag });
    if (!next.ok) throw new Error(next.reason);
    maneuver = next.value;
    if (phases.at(-1) !== maneuver.phase) phases.push(maneuver.phase);
    if (maneuver.phase === 'complete' || maneuver.phase === 'failed' || tick > 200 * tickRate)
      return {
        ...{ maneuver, ship, phases, impact, touches, seconds: tick / tickRate },
        off: site.target ? distanceAlong(ship, site.target, frame.bodies[0]!) : NaN,
      };
    const { controls } = maneuver;
    authority.receive(
      'ann',
      { kind: 'inputs', inputs: [{ seq: ++seq, tick: tick + delay, substep: 0, controls }] },
      0,
    );
    authority.tick((tick + 1) / tickRate);
  }
}

/** A place on the ground near the start, m in the body's axes. */
function placeOf(flight: Flight, shipClass: ShipClass): Vec3 {
  const body = BODIES.find(({ name }) => name === flight.body)!;
  const { ship } = order(flight, shipClass, flight.target);
  return rotate(inverse(body.attitude), ship.relativePosition);
}

/** m along the ground between a ship and a place in the body's axes. */
function distanceAlong(ship: ShipState, place: Vec3, body: BodyState): number {
  const [a, b] = [rotate(inverse(body.attitude), ship.relativePosition!), place];
  const along = (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / (Math.hypot(...a) * Math.hypot(...b));
  return body.radius * Math.sqrt(Math.max(0, 2 - 2 * along));
}

function order(
  { body: name, initial, terrain = 'flat', standing = false }: Flight,
  shipClass: ShipClass,
  [east, north]: readonly [number, number] = [0, 0],
): SpawnOrder {
  const body = BODIES.find((candidate) => candidate.name === name)!;
  const degree = (Math.PI / 180) * body.radius;
  const latitude = 20 + north / degree;
  const local: LocalState = {
    height: 200,
    velocity: [0, 0, 0],
    tilt: 0,
    leanTo: 0,
    heading: 0,
    spin: [0, 0, 0],
    ...initial,
  };
  const craft = {
    shipClass,
    fuel: 0.6 * shipClass.fuelCapacity,
    surfaceContactState: standing ? 'landed' : '',
    contactImpactSpeed: 0,
  } as const;
  const ground = {
    body,
    site: { latitude, longitude: 30 + east / (degree * Math.cos((latitude * Math.PI) / 180)) },
    terrainHeight: TERRAINS[terrain] ?? flatTerrain,
  };
  return { shipId: 'one', playerId: 'ann', name: 'One', ship: toBodyRelative(local, craft, ground) };
}
