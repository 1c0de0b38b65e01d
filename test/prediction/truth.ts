import {
  beginTick,
  BODY_STRIDE,
  type Controls,
  endTick,
  EVENT_NAMES,
  NO_EVENT,
  SHIP_STRIDE,
  stepWorld,
  type Timing,
  timingOfTick,
  type World,
  writeBodyMotion,
  writeControls,
  writeShip,
} from '../../src/dynamics';
import type { Authority } from '../../src/authority';
import type { InputRecord, ServerFrame, ShipState, WorldEvent } from '../../src/wire';

/**
 * What really happens on the server between its frames: every substep of every ship, simulated beside the authority from its own
 * frames and from the inputs as they reached it. Each tick is checked against the authority's next frame, to the bit, so that a
 * measurement against this truth is one against the server.
 */
export interface Truth {
  /** Rows of all ships at each substep boundary of the interval that begins at `tick`, or undefined if it is not simulated yet. */
  readonly interval: (tick: number) => Interval | undefined;
  readonly events: WorldEvent[];
  /** Ticks whose end did not come out as the authority's own: a measurement would be worthless. */
  readonly disagreements: number;
  /** The authority, watched. */
  readonly authority: Authority;
}

export interface Interval {
  readonly timing: Timing;
  readonly shipIds: readonly string[];
  /** substeps + 1 arrays of rows. */
  readonly rows: readonly Float64Array[];
  /** Wall s at which the interval's end was due. */
  readonly at: number;
}

const PROBE = 'truth-probe';
const KEPT = 16;

interface Pending {
  readonly shipId: string;
  readonly record: InputRecord;
}

/** Watches `authority`, whose clients fly `shipOf[playerId]`. `granularity` as the authority was made. */
export function watch(
  authority: Authority,
  world: World,
  shipOf: Readonly<Record<string, string>>,
  granularity: 'substep' | 'tick' = 'substep',
): Truth {
  authority.join(PROBE, '');
  const intervals = new Map<number, Interval>();
  const events: WorldEvent[] = [];
  const pending: Pending[] = [];
  const lastSeq = new Map<string, number>();
  const state = { disagreements: 0, expected: null as Float64Array | null };

  function simulate(frame: ServerFrame, at: number): void {
    const timing = timingOfTick(frame.timeScale / frame.tickRate);
    const shipIds = frame.ships.map((ship) => ship.shipId);
    const rows = rowsOf(frame.ships, world);
    if (state.expected !== null && !sameRows(state.expected, rows)) state.disagreements += 1;
    const bodies = new Float64Array(world.bodies.length * BODY_STRIDE);
    for (const [i, body] of frame.bodies.entries()) writeBodyMotion(bodies, i * BODY_STRIDE, body);
    const happened = new Uint8Array(shipIds.length);
    const boundaries = [rows.slice()];
    beginTick(rows, bodies, world);
    for (let substep = 0; substep < timing.substeps; substep++) {
      for (const [i, controls] of due(frame.tick, substep, shipIds))
        writeControls(rows, i * SHIP_STRIDE, controls);
      stepWorld(rows, bodies, happened, world, timing.dt);
      for (const [i, event] of happened.entries()) {
        if (event === NO_EVENT) continue;
        const type = EVENT_NAMES[event] as WorldEvent['type'];
        events.push({ type, shipId: shipIds[i]!, tick: frame.tick, substep });
      }
      boundaries.push(rows.slice());
    }
    endTick(bodies, world, timing);
    state.expected = rows;
    intervals.set(frame.tick, { timing, shipIds, rows: boundaries, at });
    intervals.delete(frame.tick - KEPT);
  }

  /** As the server: what is due, in the order of its stamps; overtaken numbers never. */
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

  /** An order changes the world between two frames: the next frame is the truth, not what was expected. */
  function ordered<T>(result: T): T {
    state.expected = null;
    return result;
  }
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
      },
      world,
    );
    if (reason !== null) throw new Error(reason);
    writeControls(rows, i * SHIP_STRIDE, ship);
  }
  return rows;
}

function sameRows(a: Float64Array, b: Float64Array): boolean {
  return a.length === b.length && a.every((value, i) => Object.is(value, b[i]));
}
