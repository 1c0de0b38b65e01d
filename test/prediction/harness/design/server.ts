import type { Controls, TerrainHeight } from '../../../../src/index';
import { type DesignBody, type DesignShip, updateShip } from './law';
import { minus, plus, times, type Turn, turnOn, type Vec } from './vectors';

/** What a server sends of its bodies: all, no attitude and no spin, or nothing. */
export type SendsBodies = 'all' | 'turnless' | 'none';

export interface ServerOptions {
  readonly terrainHeight: TerrainHeight;
  /** Hz */
  tickRate: number;
  timeScale: number;
  /** Hz; a send falls on a tick. */
  readonly sendRate: number;
  /** Server seconds a true second, less 1. */
  readonly drift: number;
  readonly sendsBodies: SendsBodies;
  readonly sendsScale: boolean;
}

/** Where a ship was at a tick: relative to the body's centre, ICRF axes. */
export interface Truth {
  readonly position: Vec;
  readonly velocity: Vec;
  readonly attitude: Turn;
  readonly state: string;
}

interface TickRecord {
  /** True time of the tick's boundary, s. */
  readonly at: number;
  readonly timeScale: number;
  readonly tickRate: number;
  readonly ships: ReadonlyMap<string, Truth>;
}

/** One run of the server's tick counter. */
export interface Era {
  readonly firstTick: number;
  readonly ticks: TickRecord[];
}

export interface DesignServer {
  readonly options: ServerOptions;
  readonly ships: Map<string, DesignShip>;
  readonly body: DesignBody;
  readonly eras: Era[];
  /** Runs up to true time `t`; gives each frame of the game's JSON, and when it was sent. */
  readonly runTo: (t: number, send: (frame: Record<string, unknown>, at: number) => void) => void;
  /** Controls take effect at the next tick. */
  readonly control: (shipId: string, controls: Controls) => void;
  /** Ticks stop for `seconds` from `t` on. */
  readonly stand: (t: number, seconds: number) => void;
  /** Another run of the counter from `tick` on, from `t` on. */
  readonly restart: (t: number, tick: number) => void;
  /** Tick and wall s since it, as a pong answers. */
  readonly clockAt: (t: number) => { readonly tick: number; readonly sinceTick: number };
  readonly frame: () => Record<string, unknown>;
}

const FIRST_TICK = 5000;
const xyz = ([x, y, z]: readonly number[]) => ({ x, y, z });
const wxyz = ([x, y, z, w]: Turn) => ({ w, x, y, z });

export function createDesignServer(
  body: DesignBody,
  crew: readonly DesignShip[],
  options: ServerOptions,
): DesignServer {
  const ships = new Map(crew.map((ship) => [ship.id, ship]));
  const pending = new Map<string, Controls>();
  const eras: Era[] = [{ firstTick: FIRST_TICK, ticks: [] }];
  let tick = FIRST_TICK;
  let nextAt = 0;
  let tickedAt = 0;
  let unsent = 0;

  function remember(at: number): void {
    const { tickRate, timeScale } = options;
    const seen = [...ships.values()].map((ship) => [ship.id, truthOf(ship, body)] as const);
    eras.at(-1)!.ticks.push({ at, tickRate, timeScale, ships: new Map(seen) });
  }

  function step(): void {
    const dt = options.timeScale / options.tickRate;
    body.position = plus(body.position, times(body.velocity, dt));
    body.attitude = turnOn(body.attitude, body.angularVelocity, dt);
    for (const [id, controls] of pending) {
      const ship = ships.get(id);
      if (ship !== undefined) ship.controls = controls;
    }
    pending.clear();
    for (const ship of ships.values()) updateShip(ship, body, options.terrainHeight, dt);
    for (const [id, { crashed }] of ships) if (crashed) ships.delete(id);
    tick += 1;
  }

  const server: DesignServer = {
    options,
    ships,
    body,
    eras,
    runTo(t, send) {
      while (nextAt <= t) {
        if (eras.at(-1)!.ticks.length > 0) step();
        tickedAt = nextAt;
        remember(tickedAt);
        unsent += 1;
        if (unsent >= options.tickRate / options.sendRate - 1e-9 || eras.at(-1)!.ticks.length === 1) {
          send(server.frame(), tickedAt);
          unsent = 0;
        }
        nextAt = tickedAt + 1 / (options.tickRate * (1 + options.drift));
      }
    },
    control: (shipId, controls) => pending.set(shipId, controls),
    stand(t, seconds) {
      nextAt = Math.max(nextAt, t + seconds);
    },
    restart(t, first) {
      tick = first;
      nextAt = t;
      eras.push({ firstTick: first, ticks: [] });
    },
    clockAt: (t) => ({ tick, sinceTick: Math.max(0, t - tickedAt) }),
    frame: () => frameOf(tick, { ships, body, options }),
  };
  return server;
}

function truthOf({ position, velocity, attitude, state }: DesignShip, body: DesignBody): Truth {
  return {
    position: minus(position, body.position),
    velocity: minus(velocity, body.velocity),
    attitude,
    state,
  };
}

function frameOf(tick: number, { ships, body, options }: Pick<DesignServer, 'ships' | 'body' | 'options'>) {
  const { tickRate, timeScale, sendsBodies, sendsScale } = options;
  const turns = sendsBodies === 'all' && {
    attitude: wxyz(body.attitude),
    angular_velocity: xyz(body.angularVelocity),
  };
  const { name, mass, radius, position, velocity } = body;
  const told = { name, mass, radius, position: xyz(position), velocity: xyz(velocity), ...turns };
  return {
    tick,
    tick_rate: tickRate,
    paused: false,
    ...(sendsScale && { time_scale: timeScale }),
    ...(sendsBodies !== 'none' && { bodies: [told] }),
    ships: [...ships.values()].map((ship) => stateOf(ship, body)),
  };
}

/** A ship's state with the design's fields alone. */
function stateOf(ship: DesignShip, { name }: DesignBody) {
  const { controls } = ship;
  return {
    ship_id: ship.id,
    player_id: ship.id,
    name: ship.id,
    ship_class: ship.shipClass.name,
    position: xyz(ship.position),
    velocity: xyz(ship.velocity),
    attitude: wxyz(ship.attitude),
    angular_velocity: xyz(ship.angularVelocity),
    rotation_input: xyz(controls.rotationInput),
    translation_input: xyz(controls.translationInput),
    thrust_level: controls.thrustLevel,
    attitude_hold: controls.attitudeHold,
    attitude_mode: 'none',
    fuel: ship.fuel,
    mass: ship.shipClass.dryMass + ship.fuel,
    landed_body_name: ship.state === '' ? '' : name,
    surface_contact_state: ship.state,
  };
}

/** True time of a label (tick, game s since it) in an era; ticks to come run on at the present rate. */
export function timeOf({ firstTick, ticks }: Era, tick: number, sinceTick: number, drift: number): number {
  const last = ticks.length - 1;
  const index = tick - firstTick;
  const record = ticks[Math.max(0, Math.min(index, last))]!;
  const beyond = (index - Math.min(index, last)) / record.tickRate;
  return record.at + (beyond + sinceTick / record.timeScale) / (1 + drift);
}

/** The truth at a label, between two ticks; null where it is not known yet or the ship was not there. */
export function truthAt(
  { firstTick, ticks }: Era,
  shipId: string,
  tick: number,
  sinceTick: number,
): Truth | null {
  const record = ticks[tick - firstTick];
  const next = ticks[tick - firstTick + 1];
  const [a, b] = [record?.ships.get(shipId), next?.ships.get(shipId)];
  if (record === undefined || a === undefined || b === undefined) return null;
  const share = (sinceTick * record.tickRate) / record.timeScale;
  const mix = (p: Vec, q: Vec): Vec => plus(times(p, 1 - share), times(q, share));
  return {
    position: mix(a.position, b.position),
    velocity: mix(a.velocity, b.velocity),
    attitude: a.attitude,
    state: share < 0.5 ? a.state : b.state,
  };
}
