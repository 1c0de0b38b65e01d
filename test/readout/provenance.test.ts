import { describe, expect, it } from 'vitest';
import {
  createLandingReadout,
  DURATION,
  updateLandingReadout,
  type LandingReadout,
  provenanceText,
  STATUS_LOOKS,
  withdrawnText,
} from '../../src/readout';
import type { ShipView } from '../../src/prediction';
import { makeView, type Pose } from './views';

const read = (pose: Pose, changes: Partial<ShipView> = {}): LandingReadout =>
  updateLandingReadout(createLandingReadout(), makeView(pose, changes));

const says = (readout: LandingReadout) => provenanceText(readout, DURATION.key(readout.age));

describe('status', () => {
  it('has the design’s words, each with a shape and a colour', () => {
    const looks = (['', 'contact', 'landed', 'tipped'] as const).map((state) => {
      const { word, shape, colour } = STATUS_LOOKS[read({ state }).status];
      return `${shape} ${word} ${colour}`;
    });
    expect(looks).toEqual(['◇ FLIGHT neutral', '▲ CONTACT yellow', '■ LANDED cyan', '✖ TIPPED red']);
    const crashed = STATUS_LOOKS[read({}, { crashed: true, shownState: 'crashed' }).status];
    expect(`${crashed.shape} ${crashed.word} ${crashed.colour}`).toBe('✖ CRASHED red');
  });

  it('is the shown state, while the numbers are those of the predicted state', () => {
    // A bounce: CONTACT dwells, but the ship is 0.8 m up already.
    const hop = read({ state: '', clearance: 0.8, up: 3 }, { shownState: 'contact' });
    expect(hop.status).toBe('contact');
    expect(hop.descent.feetHeight).toBeCloseTo(0.8, 6);
  });

  it('shows CRASHED only once the server has confirmed it', () => {
    expect(read({}, { crashed: true, shownState: '' }).status).toBe('flight');
  });

  it('shows NO DATA before there is a ship', () => {
    const out = createLandingReadout();
    updateLandingReadout(out, makeView({ state: 'contact', tilt: 20 }));
    for (const view of [
      { ...makeView(), ready: false },
      { ...makeView(), own: null },
    ]) {
      updateLandingReadout(out, view);
      expect(out).toMatchObject({ status: 'none', known: false, withdrawn: '', shipName: '' });
      expect(out.gates.shown).toBe(false);
      expect(says(out)).toBe('');
      expect(numbersOf(out).every(Number.isNaN)).toBe(true);
    }
  });
});

const numbersOf = ({ descent, tilt, drift }: LandingReadout) => [
  descent.verticalSpeed,
  descent.horizontalSpeed,
  descent.timeToImpact,
  descent.feetHeight,
  tilt.degrees,
  drift.x,
  drift.y,
];

describe('provenance', () => {
  it('uses the HUD’s words', () => {
    expect(says(read({}, { provenance: 'confirmed', age: 0.42 }))).toBe('CONF 0.4 s');
    expect(says(read({}, { provenance: 'predicted', age: 31 }))).toBe('PRED');
    expect(says(read({ state: 'contact' }, { provenance: 'predicted', age: 0.31 }))).toBe('PRED 0.3 s');
    expect(says(read({}, { provenance: 'stale', age: 2.6 }))).toBe('STALE 2.6 s');
    const fast = { ...makeView({}, { provenance: 'off' }), timeScale: 100 };
    expect(says(updateLandingReadout(createLandingReadout(), fast))).toBe('PRED OFF ×100');
  });

  it('prints dashes for a stale state, and numbers again with the next one', () => {
    const out = createLandingReadout();
    const pose: Pose = { state: 'tipped', tilt: 88, clearance: -0.02 };
    updateLandingReadout(out, makeView(pose));
    expect(numbersOf(out).filter(Number.isNaN)).toHaveLength(1);
    updateLandingReadout(out, makeView(pose, { provenance: 'stale', age: 3 }));
    expect(out).toMatchObject({ status: 'tipped', known: false });
    expect(numbersOf(out).every(Number.isNaN)).toBe(true);
    expect([out.gates.shown, out.righting.shown, out.touchdownShown]).toEqual([false, false, false]);
    updateLandingReadout(out, makeView(pose));
    expect(out.known).toBe(true);
    expect(numbersOf(out).filter(Number.isNaN)).toHaveLength(1);
  });

  it('keeps the server’s numbers where prediction is off', () => {
    const off = read({ clearance: 40, up: -5 }, { provenance: 'off' });
    expect(off.known).toBe(true);
    expect(off.descent.verticalSpeed).toBeCloseTo(5, 6);
  });

  it('reports a withdrawn prediction', () => {
    expect(withdrawnText(read({}, { withdrawn: 'landed' }).withdrawn)).toBe('LANDED withdrawn');
    expect(withdrawnText(read({}).withdrawn)).toBe('');
  });
});
