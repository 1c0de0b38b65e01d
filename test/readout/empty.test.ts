import { expect, it } from 'vitest';
import {
  createFleetReadout,
  createFlightReadout,
  createLandingAids,
  createLandingReadout,
  createTargetReadout,
  type LandingReadout,
  updateFleetReadout,
  updateFlightReadout,
  updateLandingAids,
  updateLandingReadout,
} from '../../src/readout';
import { makeView, NO_TOUCHDOWN } from './views';

/** What is shown; the memory is the readout's own. */
const shown = (readout: object) => ({ ...readout, memory: null });

it('a new readout shows what one without a ship shows', () => {
  expect(createFleetReadout()).toEqual(updateFleetReadout(createFleetReadout(), null));
  expect(createFlightReadout()).toEqual(updateFlightReadout(createFlightReadout(), null));
  expect(shown(createLandingAids())).toEqual(shown(updateLandingAids(createLandingAids(), null)));
  expect(shown(createLandingReadout())).toEqual(shown(updateLandingReadout(createLandingReadout(), null)));
});

it('a new readout has no numbers', () => {
  expect(createFleetReadout()).toEqual({
    rows: [],
    count: 0,
    counts: { none: 0, flight: 0, contact: 0, landed: 0, tipped: 0, crashed: 0 },
    timeScale: 1,
  });
  expect(createLandingReadout()).toMatchObject({
    status: 'none',
    provenance: 'stale',
    known: false,
    withdrawn: '',
    drift: { x: NaN, y: NaN, scale: 1 },
    tilt: { degrees: NaN, trend: 0, leanX: 0, leanY: 0, settle: NaN, prominent: false },
    gates: { shown: false, tilt: { met: false, value: NaN, limit: NaN } },
    descent: { shown: false },
    age: Infinity,
    margin: { shown: false, degrees: NaN },
    righting: { shown: false, torqueAvailable: NaN, torqueNeeded: NaN, fuel: NaN, holdUntil: NaN },
    touchdown: NO_TOUCHDOWN,
    touchdownShown: false,
  });
  expect(createLandingAids()).toMatchObject({ shown: false, outcome: 'working', advice: 'none' });
  expect(createTargetReadout().shown).toBe(false);
});

/** Without what is hidden with the numbers or belongs to the settings. */
const numbersOf = ({ drift, tilt, gates, margin, righting, ...rest }: LandingReadout) => ({
  ...{ ...shown(rest), age: null },
  drift: { ...drift, scale: null },
  tilt: { ...tilt, settle: null, noReturn: null, tipped: null },
  shown: [gates.shown, margin.shown, righting.shown],
});

it.each(['', 'contact', 'landed', 'tipped'] as const)(
  'a landing readout forgets its numbers with the ship, and with its recent state: %j',
  (state) => {
    const full = makeView({ clearance: 3, up: -2, east: 3, tilt: 30, leanTo: 40, tiltRate: 0.1, state });
    for (const view of [null, makeView({ state }, { provenance: 'stale' })]) {
      const out = updateLandingReadout(createLandingReadout(), full);
      expect(numbersOf(updateLandingReadout(out, view))).toEqual(
        numbersOf(updateLandingReadout(createLandingReadout(), view)),
      );
    }
  },
);

it('a readout after its ship has disappeared is that without a ship', () => {
  const flying = makeView({ clearance: 30, up: -2, east: 3, tilt: 20, leanTo: 40 });
  const gone = makeView({ clearance: 30 }, { crashed: true, shownState: 'crashed' });
  const aids = createLandingAids();
  for (let i = 0; i < 60; i++) updateLandingAids(aids, flying);
  expect(aids.outcome).toBe('touch');
  const { touchPlace } = aids;
  const flight = updateFlightReadout(createFlightReadout(), flying);
  expect(flight.fuel).toBeGreaterThan(0);
  expect(shown(updateFlightReadout(flight, gone))).toEqual(
    shown(updateFlightReadout(createFlightReadout(), gone)),
  );
  expect(shown(updateLandingAids(aids, gone))).toEqual({ ...shown(createLandingAids()), touchPlace });
});
