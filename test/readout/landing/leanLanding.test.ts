import { describe, expect, it } from 'vitest';
import {
  createLandingReadout,
  createLeanLandingReadout,
  type LandingReadout,
  updateLandingReadout,
} from '../../../src/readout';
import { makeView, type Pose } from '../views';

/** Views until a simulation ahead has its answer. */
const VIEWS = 60;

function read(out: LandingReadout, ...poses: Pose[]): Omit<LandingReadout, 'memory'> & { memory: undefined } {
  for (const pose of poses) {
    const view = makeView(pose);
    for (let i = 0; i < VIEWS; i++) updateLandingReadout(out, view);
  }
  return { ...out, memory: undefined };
}

const STEADY: Pose = { state: 'contact', clearance: -0.016 };
const TOPPLING: Pose = { ...STEADY, tilt: 45 };
const ON_SIDE: Pose = { state: 'tipped', clearance: -0.016, tilt: 89.6, fuel: 4000 };

describe('a lean landing readout', () => {
  it.each([['flight', { clearance: 300, up: -8 }] as const, ['contact', STEADY] as const])(
    'reads the same as the full one in %s',
    (_, pose) => {
      expect(read(createLeanLandingReadout(), pose)).toEqual(read(createLandingReadout(), pose));
    },
  );

  it('reads the same of a landed ship after it has toppled and lain on its side', () => {
    const poses = [TOPPLING, ON_SIDE, { state: 'landed', clearance: -0.016 }] as const;
    const { righting: leanHelp, margin: leanMargin, ...lean } = read(createLeanLandingReadout(), ...poses);
    const { righting, margin, ...full } = read(createLandingReadout(), ...poses);
    expect(lean).toEqual(full);
    expect([leanHelp.shown, leanMargin.shown]).toEqual([righting.shown, margin.shown]);
  });

  it('gives the margin of a toppling ship without the time that is left', () => {
    const full = read(createLandingReadout(), TOPPLING).margin;
    expect(full).toMatchObject({ shown: true, outlook: 'tips' });
    const { margin } = read(createLeanLandingReadout(), TOPPLING);
    expect(margin).toEqual({ ...full, outlook: 'working', timeToTipped: NaN });
  });

  it('gives no help to a tipped ship', () => {
    expect(read(createLandingReadout(), ON_SIDE).righting.shown).toBe(true);
    expect(read(createLeanLandingReadout(), ON_SIDE).righting.shown).toBe(false);
  });
});
