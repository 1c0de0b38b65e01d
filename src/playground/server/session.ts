import { createAuthority } from '../../authority';
import { type Result, err, SHIP_CLASSES, TERRAINS, type Vec3 } from '../../dynamics';
import {
  createLoopbackLink,
  type Delivery,
  type LoopbackLink,
  findScenario,
  fleetOrders,
  type RunInput,
  siteToIcrf,
  loadScenario,
  type LoadedScenario,
} from '../../scenarios';
import { loadOperation, type LoadOperation, type Operation } from './operation';

/**
 * The server the page plays against: a scenario's authority behind a simulated connection, with an operator. No clock: wall
 * seconds are handed in, so that a test plays it as the worker does.
 */
export interface Session {
  /** Does what the operator asks, or says why not. */
  readonly operate: (operation: unknown, now: number) => string | null;
  /** Bytes from the page's client; nothing before a world is loaded. */
  readonly send: (bytes: Uint8Array, now: number) => void;
  /** Lets everything up to `now` happen; what has come to the client by then. */
  readonly run: (now: number) => Delivery[];
  /** When something happens next, wall seconds; Infinity when nothing will. */
  readonly nextAt: () => number;
  /** For the page's panel; null before a world is loaded. */
  readonly status: () => SessionStatus | null;
  /** What the pilot's inputs did to the own ship since the load, at the substeps where they acted. */
  readonly applied: () => readonly RunInput[];
  /** Another player comes to fly beside the own ship; the reason why not, or null. */
  readonly join: (playerId: string, name: string, now: number) => string | null;
  readonly leave: (playerId: string) => void;
  readonly sendFrom: (playerId: string, bytes: Uint8Array, now: number) => void;
  /** What has come to another player by `now`, after run(now). */
  readonly deliverTo: (playerId: string, now: number) => Delivery[];
  readonly world: () => { readonly scenario: string; readonly terrain: string };
}

export interface SessionStatus {
  readonly tick: number;
  readonly tickRate: number;
  readonly timeScale: number;
  readonly paused: boolean;
  readonly frozen: boolean;
  readonly connected: boolean;
  /** Messages of the client that were refused, and why the last. */
  readonly refused: number;
  readonly lastRefusal: string;
  /** Ticks the host was too slow for. */
  readonly slipped: number;
}

const OWN_PLAYER = 'pilot';
export const OWN_SHIP = 'own';

/** Inputs kept for a replay: an hour of flying. */
const MAX_APPLIED = 20_000;

interface Loaded {
  readonly loaded: LoadedScenario;
  readonly exchange: LoopbackLink;
  readonly applied: readonly RunInput[];
  /** Guests by player. */
  readonly seats: Set<string>;
  connected: boolean;
}

export function createSession(): Session {
  let loaded: Loaded | null = null;

  function operate(given: unknown, now: number): string | null {
    const checked = loadOperation(given);
    if (!checked.ok) return checked.reason;
    const operation = checked.value;
    if (operation.kind !== 'load')
      return loaded === null ? 'no world is loaded' : operateWorld(loaded, operation, now);
    const world = load(operation, now);
    if (!world.ok) return world.reason;
    loaded = world.value;
    return null;
  }

  return {
    operate,
    send: (bytes, now) => loaded?.exchange.send(OWN_PLAYER, bytes, now),
    run(now) {
      loaded?.exchange.run(now);
      return loaded?.exchange.deliver(OWN_PLAYER, now) ?? [];
    },
    nextAt: () => loaded?.exchange.nextAt() ?? Infinity,
    status: () => (loaded === null ? null : statusOf(loaded)),
    applied: () => loaded?.applied ?? [],
    join: (playerId, name, now) =>
      loaded === null ? 'no world is loaded' : seat(loaded, playerId, name, now),
    leave(playerId) {
      loaded?.exchange.drop(playerId);
      loaded?.exchange.authority.despawn(playerId);
    },
    sendFrom: (playerId, bytes, now) => loaded?.exchange.send(playerId, bytes, now),
    deliverTo: (playerId, now) => loaded?.exchange.deliver(playerId, now) ?? [],
    world: () => ({
      scenario: loaded?.loaded.scenario.name ?? '',
      terrain: loaded?.loaded.scenario.terrain ?? '',
    }),
  };
}

function load(operation: LoadOperation, now: number): Result<Loaded> {
  const loaded = stageOperation(operation);
  if (!loaded.ok) return loaded;
  const { scenario, body, ship, shipClass, inputs } = loaded.value;
  const applied: RunInput[] = [];
  const authority = createAuthority({
    settings: scenario.settings,
    shipClasses: SHIP_CLASSES.map((known) => (known.name === shipClass.name ? shipClass : known)),
    bodies: [body],
    terrain: scenario.terrain,
    terrains: TERRAINS,
    tickRate: scenario.tickRate,
    timeScale: scenario.timeScale,
    legacy: operation.legacy,
    onInput(shipId, input) {
      if (shipId === OWN_SHIP && applied.length < MAX_APPLIED) applied.push(input);
    },
  });
  if (!authority.ok) return authority;
  const own = {
    shipId: OWN_SHIP,
    playerId: OWN_PLAYER,
    name: operation.pilot || 'Touchdown',
    ship,
    plan: inputs,
  };
  for (const order of [own, ...fleetOrders(loaded.value, operation.others, operation.seed)]) {
    const reason = authority.value.spawn(order);
    if (reason !== null) return err(`${order.shipId}.${reason}`);
  }
  const exchange = createLoopbackLink(authority.value, operation.network, operation.seed, now);
  const reason = exchange.connect(OWN_PLAYER, OWN_SHIP, now);
  if (reason !== null) return err(reason);
  return { ok: true, value: { loaded: loaded.value, exchange, applied, seats: new Set(), connected: true } };
}

/** A guest's ship stands where the fleet's would, farther out with each guest; who comes again flies the same one on. */
function seat(
  { loaded, exchange, seats }: Loaded,
  playerId: string,
  name: string,
  now: number,
): string | null {
  if (seats.has(playerId)) {
    exchange.reconnect(playerId, now);
    return null;
  }
  const place = seats.size + 1;
  const order = fleetOrders(loaded, place, place).at(-1)!;
  const reason = exchange.authority.spawn({
    ...order,
    shipId: playerId,
    playerId,
    name,
    plan: loaded.inputs,
  });
  if (reason !== null) return reason;
  seats.add(playerId);
  return exchange.connect(playerId, playerId, now);
}

function stageOperation(operation: LoadOperation): Result<LoadedScenario> {
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

function operateWorld(
  loaded: Loaded,
  operation: Exclude<Operation, LoadOperation>,
  now: number,
): string | null {
  const { exchange } = loaded;
  const { authority } = exchange;
  switch (operation.kind) {
    case 'pause':
      authority.setPaused(operation.paused);
      return null;
    case 'step':
      return exchange.step(operation.unit, now);
    case 'tickRate':
      return authority.setTickRate(operation.tickRate);
    case 'timeScale':
      return authority.setTimeScale(operation.timeScale);
    case 'network':
      exchange.setNetwork(operation.numbers);
      return null;
    case 'run':
    case 'invite':
      return null;
    case 'restart':
      return authority.respawn(OWN_SHIP);
    case 'kick':
      return kick(loaded, operation.velocity, operation.spin);
    case 'freeze':
      exchange.setFrozen(operation.frozen, now);
      return null;
    case 'drop':
      exchange.drop(OWN_PLAYER);
      loaded.connected = false;
      return null;
    case 'reconnect':
      exchange.reconnect(OWN_PLAYER, now);
      loaded.connected = true;
      return null;
  }
}

function kick({ loaded, exchange }: Loaded, velocity: Vec3, spin: Vec3): string | null {
  const motion = exchange.authority.frameFor(OWN_PLAYER)?.bodies[0] ?? loaded.body;
  const ground = { body: motion, site: loaded.scenario.site, terrainHeight: loaded.terrainHeight };
  return exchange.authority.kick(OWN_SHIP, siteToIcrf(velocity, ground), siteToIcrf(spin, ground));
}

function statusOf({ exchange, connected }: Loaded): SessionStatus {
  const { authority, loop, counters } = exchange;
  return {
    tick: authority.tickNumber(),
    tickRate: authority.tempo.tickRate(),
    timeScale: authority.tempo.timeScale(),
    paused: authority.tempo.paused(),
    frozen: loop.frozen,
    connected,
    refused: counters.refused,
    lastRefusal: counters.lastRefusal,
    slipped: loop.slipped,
  };
}
