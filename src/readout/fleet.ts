import type { Provenance, ShipView, WorldView } from '../prediction';
import { isGroundKnown, standsOnGround } from './landing/descent';
import { type StatusId, statusOf } from './status';
import { viewOf } from './arguments';

/** One ship's row. */
export interface FleetRow {
  shipId: string;
  name: string;
  own: boolean;
  status: StatusId;
  provenance: Provenance;
  withdrawn: ShipView['withdrawn'];
  /** AGL of the feet, m; 0 on the ground, NaN without a recent state or over unknown ground. */
  height: number;
}

/** All ships, those that need help first (HUD, Fleet). */
export interface FleetReadout {
  /** In the order shown; only the first `count` are present ships. */
  readonly rows: FleetRow[];
  count: number;
  /** Ships by status. */
  readonly counts: Record<StatusId, number>;
  /** Game s per wall s. */
  timeScale: number;
}

/** TIPPED first, then CONTACT, then the rest; ships of one status keep the view's order. */
export const FLEET_ORDER: readonly StatusId[] = ['tipped', 'contact', 'crashed', 'flight', 'landed', 'none'];

/**
 * An empty readout of a fleet, filled by updateFleetReadout.
 *
 * @example
 * ```ts
 * const readout = updateFleetReadout(createFleetReadout(), predictor.view(now));
 * console.log(readout.counts.landed);
 * ```
 */
export function createFleetReadout(): FleetReadout {
  return {
    rows: [],
    count: 0,
    counts: { none: 0, flight: 0, contact: 0, landed: 0, tipped: 0, crashed: 0 },
    timeScale: 1,
  };
}

/**
 * Fills `out` in two passes over the ships: count, then place. Allocates only where the fleet has grown.
 *
 * @example
 * ```ts
 * const readout = createFleetReadout(); // once
 * updateFleetReadout(readout, predictor.view(now)); // each display frame
 * for (const row of readout.rows.slice(0, readout.count)) console.log(row);
 * ```
 */
export function updateFleetReadout(out: FleetReadout, given: WorldView | null): FleetReadout {
  const view = viewOf('updateFleetReadout', out, given);
  const ships = view.ready ? view.ships : NO_SHIPS;
  const { rows, counts } = out;
  for (const status of FLEET_ORDER) counts[status] = 0;
  for (const ship of ships) counts[statusOf(ship.shownState)]++;
  let from = 0;
  for (const status of FLEET_ORDER) {
    nextRow[status] = from;
    from += counts[status];
  }
  while (rows.length < ships.length) rows.push(createRow());
  for (const ship of ships) fillRow(rows[nextRow[statusOf(ship.shownState)]++]!, ship);
  out.count = ships.length;
  out.timeScale = view.timeScale;
  return out;
}

const NO_SHIPS: readonly ShipView[] = [];
/** Index of the next row of each status. */
const nextRow = createFleetReadout().counts;

function createRow(): FleetRow {
  return {
    shipId: '',
    name: '',
    own: false,
    status: 'none',
    provenance: 'stale',
    withdrawn: '',
    height: NaN,
  };
}

function fillRow(row: FleetRow, ship: ShipView): void {
  row.shipId = ship.shipId;
  row.name = ship.name;
  row.own = ship.own;
  row.status = statusOf(ship.shownState);
  row.provenance = ship.provenance;
  row.withdrawn = ship.withdrawn;
  // Separate stores, not one with either value: a place that holds whole numbers and doubles is boxed.
  if (ship.provenance === 'stale') row.height = NaN;
  else if (standsOnGround(ship)) row.height = 0;
  else if (!isGroundKnown(ship)) row.height = NaN;
  else row.height = ship.feetHeight;
}
