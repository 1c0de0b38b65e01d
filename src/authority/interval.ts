import { beginTick, endTick, EVENT_NAMES, NO_EVENT, readControls, stepWorld } from '../dynamics';
import type { WorldEvent } from '../wire';
import { applyDue } from './pilots/inputQueue';
import { flyPlans } from './ships/plans';
import { presentOf, type ServerState } from './serverState';
import { rowOf } from './ships/shipTable';

/** Simulates the interval that begins at the present boundary, substep by substep, with the inputs that have arrived. */
export function simulateInterval(server: ServerState): void {
  const { ships, bodies, world, tempo } = server;
  const { substeps, dt } = tempo.timing();
  beginTick(ships.rows, bodies, world);
  for (let substep = 0; substep < substeps; substep++) {
    applyInputs(server, substep);
    stepWorld(ships.rows, bodies, ships.events, world, dt);
    collectEvents(server, substep);
  }
  endTick(bodies, world, tempo.timing());
}

function applyInputs(server: ServerState, substep: number): void {
  const { ships, plans, pilots, counters, tick } = server;
  flyPlans(plans, ships, tick, substep);
  for (const pilot of pilots.values()) {
    if (pilot.queue.length === 0) continue;
    const at = rowOf(ships, pilot.shipId);
    if (at < 0) continue;
    const applied = applyDue(pilot, counters, { rows: ships.rows, at }, { ...presentOf(server), substep });
    if (!applied) continue;
    // The player's first input ends the ship's plan.
    plans.delete(pilot.shipId);
    server.options.onInput?.(pilot.shipId, { tick, substep, controls: readControls(ships.rows, at) });
  }
}

function collectEvents({ ships, events, tick }: ServerState, substep: number): void {
  for (const [i, event] of ships.events.entries()) {
    if (event === NO_EVENT) continue;
    const type = EVENT_NAMES[event] as WorldEvent['type'];
    events.push({ type, shipId: ships.entries[i]!.identity.shipId, tick, substep });
  }
}
