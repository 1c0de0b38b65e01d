import { type Authority, createAuthority, type SpawnOrder } from '../../src/authority';
import {
  BODIES,
  flatTerrain,
  type Settings,
  SHIP_CLASSES,
  type ShipClass,
  TERRAINS,
} from '../../src/dynamics';
import {
  BEGIN_LANDING,
  continueLanding,
  type LandingManeuver,
  type LandingSite,
  type LocalState,
  toBodyRelative,
} from '../../src/scenarios';
import type { ShipState } from '../../src/wire';

export interface Flight {
  readonly body: string;
  readonly shipClass?: ShipClass;
  readonly tickRate: number;
  readonly initial?: Partial<LocalState>;
  readonly terrain?: string;
  readonly settings?: Partial<Settings>;
  /** Ticks from a state until the controls computed from it act. */
  readonly delay?: number;
  /** The autopilot does not know the delay. */
  readonly ignoresDelay?: boolean;
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
  return fly(authority, { body, shipClass, terrainHeight }, flight);
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
    if (maneuver.phase === 'complete' || maneuver.phase === 'failed' || tick > 120 * tickRate)
      return { maneuver, ship, phases, impact, touches, seconds: tick / tickRate };
    const { controls } = maneuver;
    authority.receive(
      'ann',
      { kind: 'inputs', inputs: [{ seq: ++seq, tick: tick + delay, substep: 0, controls }] },
      0,
    );
    authority.tick((tick + 1) / tickRate);
  }
}

function order({ body, initial, terrain = 'flat' }: Flight, shipClass: ShipClass): SpawnOrder {
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
    surfaceContactState: '',
    contactImpactSpeed: 0,
  } as const;
  const ground = {
    body: BODIES.find((candidate) => candidate.name === body)!,
    site: { latitude: 20, longitude: 30 },
    terrainHeight: TERRAINS[terrain] ?? flatTerrain,
  };
  return { shipId: 'one', playerId: 'ann', name: 'One', ship: toBodyRelative(local, craft, ground) };
}
