import { createAuthority } from '../../authority';
import { err, ok, type Result, SHIP_CLASSES, TERRAINS } from '../../dynamics';
import {
  createLoopbackLink,
  findScenario,
  fleetOrders,
  type LoadedScenario,
  loadScenario,
  type LoopbackLink,
  type RunInput,
} from '../../scenarios';
import type { LoadOperation } from './operation';
import type { SavedShip } from './savedShips';

export const OWN_PLAYER = 'pilot';
export const OWN_SHIP = 'own';

/** Inputs kept for a replay: an hour of flying. */
const MAX_APPLIED = 20_000;

/** A world that is being played. */
export interface LoadedWorld {
  readonly loaded: LoadedScenario;
  readonly link: LoopbackLink;
  /** The pilot's inputs since the load. */
  readonly applied: readonly RunInput[];
  /** Guests by player. */
  readonly guests: Set<string>;
  isConnected: boolean;
  /** All ships as the operator saved them; null before. */
  saved: readonly SavedShip[] | null;
  /** The player's ship at the start of a drag; null while it is not dragged. */
  dragged: SavedShip | null;
}

/** Begins the world of a load operation, or returns an error that names the field. */
export function loadWorld(operation: LoadOperation, now: number): Result<LoadedWorld> {
  const loaded = resolve(operation);
  if (!loaded.ok) return loaded;
  const applied: RunInput[] = [];
  const authority = authorityOf(loaded.value, operation.legacy, applied);
  if (!authority.ok) return authority;
  const own = {
    shipId: OWN_SHIP,
    playerId: OWN_PLAYER,
    name: operation.pilot || 'Eagle',
    ship: loaded.value.ship,
    plan: operation.plan ?? loaded.value.inputs,
  };
  for (const order of [own, ...fleetOrders(loaded.value, operation.others, operation.seed)]) {
    const reason = authority.value.spawn(order);
    if (reason !== null) return err(`${order.shipId}.${reason}`);
  }
  const link = createLoopbackLink(authority.value, operation.network, operation.seed, now);
  if (operation.upNetwork !== undefined) link.setNetwork(operation.network, operation.upNetwork);
  const reason = link.connect(OWN_PLAYER, OWN_SHIP, now);
  if (reason !== null) return err(reason);
  const world = { loaded: loaded.value, link, applied, guests: new Set<string>() };
  return ok({ ...world, isConnected: true, saved: null, dragged: null });
}

function authorityOf(
  { scenario, body, shipClass }: LoadedScenario,
  legacy: boolean,
  applied: RunInput[],
): ReturnType<typeof createAuthority> {
  return createAuthority({
    settings: scenario.settings,
    shipClasses: SHIP_CLASSES.map((known) => (known.name === shipClass.name ? shipClass : known)),
    bodies: [body],
    terrain: scenario.terrain,
    terrains: TERRAINS,
    tickRate: scenario.tickRate,
    timeScale: scenario.timeScale,
    legacy,
    onInput(shipId, input) {
      if (shipId === OWN_SHIP && applied.length < MAX_APPLIED) applied.push(input);
    },
  });
}

function resolve(operation: LoadOperation): Result<LoadedScenario> {
  const scenario = findScenario(operation.scenario);
  if (scenario === null) return err(`scenario: no scenario named ${operation.scenario}`);
  const { body, shipClass, terrain, surfaceNormal = '', tickRate, timeScale } = operation;
  return loadScenario({
    ...scenario,
    body: body === '' ? scenario.body : body,
    shipClass: shipClass === '' ? scenario.shipClass : shipClass,
    terrain: terrain === '' ? scenario.terrain : terrain,
    settings: surfaceNormal === '' ? scenario.settings : { ...scenario.settings, surfaceNormal },
    tickRate,
    timeScale,
  });
}

/** A guest's ship starts where the fleet's would, farther out with each guest; a guest that returns keeps its ship. */
export function addGuest(world: LoadedWorld, playerId: string, name: string, now: number): string | null {
  const { loaded, link, guests } = world;
  if (guests.has(playerId)) {
    link.reconnect(playerId, now);
    return null;
  }
  const place = guests.size + 1;
  const order = fleetOrders(loaded, place, place).at(-1)!;
  // The scenario begins for a guest when it comes: a ship with neutral controls would fall before its pilot has read how to fly.
  const came = link.authority.tickNumber();
  const plan = loaded.inputs.map((input) => ({ ...input, tick: input.tick + came }));
  const guest = { ...order, shipId: playerId, playerId, name, plan };
  const reason = link.authority.spawn(guest);
  if (reason !== null) return reason;
  guests.add(playerId);
  return link.connect(playerId, playerId, now);
}
