import {
  ATTITUDE,
  beginTick,
  BODY_STRIDE,
  type Controls,
  endTick,
  EVENT_NAMES,
  NO_EVENT,
  type ShipRecord,
  SHIP_STRIDE,
  spawnShip,
  stepWorld,
  type Timing,
  timingOfTick,
  type World,
  writeBodyMotion,
  writeControls,
  writeShip,
} from '../../src/dynamics';
import type { Authority, SpawnOrder } from '../../src/authority';
import type { InputRecord, ServerFrame, ShipState, WorldEvent } from '../../src/wire';

/**
 * The ground truth between the server's frames: every substep of every ship, simulated beside the authority from its own
 * frames and the inputs as they arrived. Each tick is compared with the authority's next frame, bit by bit, so that a
 * measurement against it is one against the server.
 */
export interface Truth {
  /** Rows of all ships at each substep boundary of the interval that begins at `tick`, or undefined if it is not simulated yet. */
  readonly interval: (tick: number) => Interval | undefined;
  readonly events: WorldEvent[];
  /** Ticks whose end differs from the authority's: measurements are then worthless. */
  readonly disagreements: number;
  /** The watched authority. */
  readonly authority: Authority;
}

export interface Interval {
  readonly timing: Timing;
  readonly shipIds: readonly string[];
  /** Rows of all ships at each of the substeps + 1 boundaries, one after the other; rowAt reads them. */
  readonly rows: Float64Array;
  /** Wall s at which the interval's end was due. */
  readonly at: number;
}

/** The row of the ship at `index` at a substep boundary of the interval. */
export function rowAt({ rows, shipIds }: Interval, boundary: number, index: number): Float64Array {
  const at = (boundary * shipIds.length + index) * SHIP_STRIDE;
  return rows.subarray(at, at + SHIP_STRIDE);
}

const PROBE = 'truth-probe';
const KEPT = 16;

interface Pending {
  readonly shipId: string;
  readonly record: InputRecord;
}

/** Watches `authority`, into which `orders` are about to be spawned; `granularity` as it was made. */
export function watch(
  authority: Authority,
  world: World,
  orders: readonly SpawnOrder[],
  granularity: 'substep' | 'tick' = 'substep',
): Truth {
  const shipOf = Object.fromEntries(orders.map(({ playerId, shipId }) => [playerId, shipId]));
  authority.join(PROBE, '');
  const intervals = new Map<number, Interval>();
  const events: WorldEvent[] = [];
  const pending: Pending[] = [];
  const lastSeq = new Map<string, number>();
  const state = { disagreements: 0, expected: null as Float64Array | null };

  function simulate(frame: ServerFrame, at: number): void {
    const timing = timingOfTick(frame.timeScale / frame.tickRate, world.settings.contactLongestSubstep);
    const shipIds = frame.ships.map((ship) => ship.shipId);
    const rows = isTold(frame)
      ? rowsOf(frame.ships, world)
      : (state.expected ?? rowsOfOrders(orders, world)).slice();
    if (state.expected !== null && !agrees(frame, state.expected, rows)) state.disagreements += 1;
    const bodies = new Float64Array(world.bodies.length * BODY_STRIDE);
    for (const [i, body] of frame.bodies.entries()) writeBodyMotion(bodies, i * BODY_STRIDE, body);
    const happened = new Uint8Array(shipIds.length);
    const boundaries = new Float64Array((timing.substeps + 1) * rows.length);
    boundaries.set(rows);
    beginTick(rows, bodies, world);
    for (let substep = 0; substep < timing.substeps; substep++) {
      if (pending.length > 0)
        for (const [i, controls] of due(frame.tick, substep, shipIds))
          writeControls(rows, i * SHIP_STRIDE, controls);
      stepWorld(rows, bodies, happened, world, timing.dt);
      for (let i = 0; i < happened.length; i++) {
        const event = happened[i]!;
        if (event === NO_EVENT) continue;
        const type = EVENT_NAMES[event] as WorldEvent['type'];
        events.push({ type, shipId: shipIds[i]!, tick: frame.tick, substep });
      }
      boundaries.set(rows, (substep + 1) * rows.length);
    }
    endTick(bodies, world, timing);
    state.expected = rows;
    intervals.set(frame.tick, { timing, shipIds, rows: boundaries, at });
    intervals.delete(frame.tick - KEPT);
  }

  /** Applies inputs like the server: those due, in the order of their stamps; superseded ones never. */
  function* due(tick: number, substep: number, shipIds: readonly string[]): Generator<[number, Controls]> {
    for (const entry of pending.filter(({ record }) => isDue(record, tick, substep))) {
      pending.splice(pending.indexOf(entry), 1);
      const { shipId, record } = entry;
      if (record.seq <= (lastSeq.get(shipId) ?? 0)) continue;
      lastSeq.set(shipId, record.seq);
      const i = shipIds.indexOf(shipId);
      if (i >= 0) yield [i, record.controls];
    }
  }

  function isDue(record: InputRecord, tick: number, substep: number): boolean {
    const whole = granularity === 'tick' && record.substep > 0;
    const t = whole ? record.tick + 1 : record.tick;
    const s = granularity === 'tick' ? 0 : record.substep;
    return t < tick || (t === tick && s <= substep);
  }

  return {
    interval: (tick) => intervals.get(tick),
    events,
    get disagreements() {
      return state.disagreements;
    },
    authority: {
      ...authority,
      receive(playerId, message, now) {
        const shipId = shipOf[playerId];
        if (message.kind === 'inputs' && shipId !== undefined) {
          for (const record of message.inputs) pending.push({ shipId, record });
          pending.sort((a, b) => a.record.seq - b.record.seq);
        }
        return authority.receive(playerId, message, now);
      },
      tick(at) {
        const frame = authority.frameFor(PROBE)!;
        if (!frame.paused) simulate(frame, at);
        authority.tick(at);
      },
      kick: (...order) => ordered(authority.kick(...order)),
      respawn: (...order) => ordered(authority.respawn(...order)),
      spawn: (...order) => ordered(authority.spawn(...order)),
      despawn: (...order) => ordered(authority.despawn(...order)),
    },
  };

  /** A command changes the world between two frames: the next frame is then the truth. */
  function ordered<T>(result: T): T {
    state.expected = null;
    return result;
  }
}

/** Whether the server sends relative states; the game's own does not, and is assumed to follow the law from its start. */
function isTold(frame: ServerFrame): boolean {
  return frame.ships.every((ship) => ship.relativePosition !== null);
}

/** A row sent in full is compared in full; otherwise attitude, spin and fuel, which depend on everything else. */
function agrees(frame: ServerFrame, expected: Float64Array, rows: Float64Array): boolean {
  if (isTold(frame)) return sameRows(expected, rows);
  return frame.ships.every((ship, i) => {
    const row = rows.subarray(i * SHIP_STRIDE, (i + 1) * SHIP_STRIDE);
    const told = [...ship.attitude, ...ship.angularVelocity, ship.fuel];
    return told.every((value, k) => Object.is(value, row[ATTITUDE + k]));
  });
}

function rowsOfOrders(orders: readonly SpawnOrder[], world: World): Float64Array {
  const rows = new Float64Array(orders.length * SHIP_STRIDE);
  for (const [i, { ship }] of orders.entries()) spawnShip(rows, i * SHIP_STRIDE, ship, world);
  return rows;
}

function rowsOf(ships: readonly ShipState[], world: World): Float64Array {
  const rows = new Float64Array(ships.length * SHIP_STRIDE);
  for (const [i, ship] of ships.entries()) {
    const reason = writeShip(
      rows,
      i * SHIP_STRIDE,
      {
        ...ship,
        contactImpactSpeed: ship.contactImpactSpeed!,
        relativePosition: ship.relativePosition!,
        relativeVelocity: ship.relativeVelocity!,
        wheelMomentum: ship.wheelMomentum!,
        groundContactOffset: ship.groundContactOffset!,
      } as ShipRecord,
      world,
    );
    if (reason !== null) throw new Error(reason);
    writeControls(rows, i * SHIP_STRIDE, ship as Controls);
  }
  return rows;
}

function sameRows(a: Float64Array, b: Float64Array): boolean {
  return a.length === b.length && a.every((value, i) => Object.is(value, b[i]));
}
