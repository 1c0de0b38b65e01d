import { describe, expect, it } from 'vitest';
import { createFleetReadout, updateFleetReadout } from '../../src/readout';
import type { ShipView, WorldView } from '../../src/prediction';
import { makeShip, makeView } from './views';

const STATES = ['', 'landed', 'contact', 'crashed', 'tipped', 'landed', '', 'tipped'] as const;

function fleet(states: readonly ShipView['shownState'][], changes: Partial<ShipView> = {}): WorldView {
  const ships = states.map((shownState, i) =>
    makeShip(
      { clearance: 10 * i },
      { shipId: `s${String(i)}`, name: `Ship ${String(i)}`, shownState, ...changes },
    ),
  );
  return { ...makeView(), ships, own: null };
}

describe('updateFleetReadout', () => {
  it('puts TIPPED first, then CONTACT, then the rest, each in the view’s order', () => {
    const out = updateFleetReadout(createFleetReadout(), fleet(STATES));
    expect(out.rows.slice(0, out.count).map((row) => `${row.shipId} ${row.status}`)).toEqual([
      's4 tipped',
      's7 tipped',
      's2 contact',
      's3 crashed',
      's0 flight',
      's6 flight',
      's1 landed',
      's5 landed',
    ]);
    expect(out.counts).toEqual({ tipped: 2, contact: 1, crashed: 1, flight: 2, landed: 2, none: 0 });
  });

  it('gives each ship’s row its name and provenance', () => {
    const view = fleet(['']);
    const given = { name: 'Heron', own: true, provenance: 'predicted', withdrawn: 'landed' } as const;
    const ships = [{ ...view.ships[0]!, ...given }];
    const { rows, timeScale } = updateFleetReadout(createFleetReadout(), { ...view, ships, timeScale: 4 });
    expect(rows[0]).toMatchObject({ shipId: 's0', status: 'flight', ...given });
    expect(timeScale).toBe(4);
  });

  it('follows a fleet that shrinks and grows, and reuses its rows', () => {
    const out = createFleetReadout();
    updateFleetReadout(out, fleet(STATES));
    const rows = [...out.rows];
    updateFleetReadout(out, fleet(['tipped']));
    expect(out.count).toBe(1);
    expect(out.rows[0]).toBe(rows[0]);
    expect(out.rows[0]).toMatchObject({ shipId: 's0', status: 'tipped' });
    expect(out.counts.landed).toBe(0);
    updateFleetReadout(out, fleet([...STATES, '']));
    expect(out.count).toBe(9);
    expect(out.rows.slice(0, 8)).toEqual(
      rows.map((row) => expect.objectContaining({ name: row.name }) as unknown),
    );
  });

  it('gives heights, and none for a stale ship', () => {
    const heights = (view: WorldView) => {
      const out = updateFleetReadout(createFleetReadout(), view);
      return out.rows.slice(0, out.count).map((row) => row.height);
    };
    const [low, high] = heights(fleet(['', '']));
    expect(low).toBeCloseTo(0, 6);
    expect(high).toBeCloseTo(10, 6);
    const out = updateFleetReadout(createFleetReadout(), fleet(['']));
    expect(updateFleetReadout(out, fleet([''], { provenance: 'stale' })).rows[0]!.height).toBeNaN();
    const overUnknown = { extrapolated: 'ground', feetHeight: 30 } as const;
    expect(heights(fleet([''], overUnknown))).toEqual([NaN]);
    expect(heights(fleet(['landed'], { ...overUnknown, surfaceContactState: 'landed' }))).toEqual([0]);
    expect(heights(fleet([''], { feetHeight: -0.1 }))).toEqual([0]);
  });

  it('has no ships before the view is ready', () => {
    const out = createFleetReadout();
    updateFleetReadout(out, fleet(STATES));
    updateFleetReadout(out, { ...fleet(STATES), ready: false });
    expect(out.count).toBe(0);
    expect(out.counts.tipped).toBe(0);
  });
});
