/** Views that lead to each state of a HUD. */
import type { ShipView, WorldView } from '../../../src/prediction';
import { later, makeShip, makeView, type Pose } from '../../readout/views';

/** The keys that the HUDs name, unless a test binds others. */
export const KEYS: Record<string, string> = {
  pitchPlus: 'S',
  pitchMinus: 'W',
  yawPlus: 'D',
  yawMinus: 'A',
  translateYPlus: 'I',
  rateDamping: 'T',
};

export type StateName =
  | 'noData'
  | 'flight'
  | 'nudged'
  | 'contact'
  | 'toppling'
  | 'landed'
  | 'tipped'
  | 'stuck'
  | 'twoKeys'
  | 'helped'
  | 'lighter'
  | 'wide'
  | 'crashed'
  | 'predicted'
  | 'confirmed'
  | 'stale'
  | 'withdrawn'
  | 'off'
  | 'sliding';

const APPROACH: Pose = { clearance: 86, east: 3.2, north: 6.4, up: -12.3, tilt: 4, leanTo: 60 };
const SLIDE: Pose = { clearance: -0.3, east: 3, north: 5.1, up: 0.4, state: 'contact' };
const REST: Pose = { clearance: -0.016, state: 'landed', tilt: 1.2, leanTo: 20 };
const ON_SIDE: Pose = { clearance: -0.016, state: 'tipped', tilt: 89.6, leanTo: 180 };

export const STATES: Readonly<Record<StateName, () => readonly WorldView[]>> = {
  noData: () => [{ ...makeView(), ready: false }],
  flight: () => [makeView(APPROACH, { provenance: 'predicted', age: 31 })],
  // Off by less than any display shows.
  nudged: () => [
    makeView(
      { ...APPROACH, clearance: 86.01, tilt: 4.001, leanTo: 60.02 },
      { provenance: 'predicted', age: 31 },
    ),
  ],
  contact: () => [makeView({ ...SLIDE, tilt: 7.5, leanTo: 30 }, { provenance: 'confirmed', age: 0.4 })],
  toppling: () =>
    frames(
      makeView({
        ...SLIDE,
        clearance: -0.016,
        east: 0.3,
        north: 0,
        up: 0,
        tilt: 41,
        leanTo: 140,
        tiltRate: 0.05,
      }),
      30,
    ),
  landed: () => touchdown(REST, 'landed'),
  tipped: () => touchdown(ON_SIDE, 'tipped'),
  stuck: () => touchdown({ ...ON_SIDE, body: 'Earth', leanTo: 160 }, 'tipped'),
  twoKeys: () => touchdown({ ...ON_SIDE, leanTo: 225 }, 'tipped'),
  helped: () => touchdown({ ...ON_SIDE, leanTo: 225, fuel: 20_000 }, 'tipped'),
  lighter: () => touchdown({ ...ON_SIDE, body: 'Mars', leanTo: 160, fuel: 20_000 }, 'tipped'),
  // Every number at its widest, and a withdrawn prediction.
  wide: () => [
    makeView(
      { clearance: 9_876, east: -1888.8, north: 888.8, up: -2888.8, tilt: 178.8, tiltRate: 0.3 },
      { provenance: 'predicted', age: 688, withdrawn: 'landed', shownState: 'contact' },
    ),
  ],
  crashed: () => [
    makeView(
      { clearance: -1, up: -63, east: 5 },
      {
        crashed: true,
        shownState: 'crashed',
        touchdown: {
          ...TOUCHDOWN,
          outcome: 'crashed',
          verticalSpeed: 63,
          horizontalSpeed: 5,
          bounces: 0,
          slideMetres: 0,
          settleSeconds: 0,
          largestTilt: 0.02,
        },
      },
    ),
  ],
  predicted: () => [makeView({ ...SLIDE, tilt: 2 }, { provenance: 'predicted', age: 0.3 })],
  confirmed: () => [makeView(APPROACH, { provenance: 'confirmed', age: 0.4 })],
  stale: () => [makeView({ ...SLIDE, tilt: 2 }, { provenance: 'stale', age: 2.6 })],
  withdrawn: () => [
    makeView({ ...SLIDE, tilt: 2 }, { provenance: 'predicted', age: 0.6, withdrawn: 'landed' }),
  ],
  off: () => [{ ...makeView(APPROACH, { provenance: 'off', age: 0.2 }), timeScale: 100 }],
  sliding: () =>
    Array.from({ length: 50 }, (_, i) =>
      makeView({ ...SLIDE, north: 20 - 0.2 * i, tilt: 10 + 0.1 * i, up: 0.1 * i }),
    ),
};

/** Long enough for the runs ahead to finish. */
function frames(view: WorldView & { own: ShipView }, count: number): WorldView[] {
  return Array.from({ length: count }, (_, i) => later(view, i / 1000, view.own));
}

/** At rest after a touch at 12.3 m/s, one bounce and a slide. */
function touchdown(rest: Pose, outcome: 'landed' | 'tipped'): WorldView[] {
  const largestTilt = outcome === 'landed' ? 0.157 : 1.564;
  return frames(makeView(rest, { touchdown: { ...TOUCHDOWN, outcome, largestTilt } }), 40);
}

const TOUCHDOWN: ShipView['touchdown'] = {
  known: true,
  outcome: 'open',
  verticalSpeed: 12.3,
  horizontalSpeed: 4.9,
  bounces: 1,
  slideMetres: 15.2,
  settleSeconds: 8.4,
  largestTilt: 0,
};

/** A fleet with every status in it. */
export function makeFleet(size: number): WorldView {
  const shown = ['', 'landed', 'contact', 'landed', '', 'landed', 'crashed', 'landed', 'tipped', ''] as const;
  const marks = ['predicted', 'confirmed', 'confirmed', 'confirmed', 'stale'] as const;
  const ships = Array.from({ length: size }, (_, i) =>
    makeShip(
      { clearance: shown[i % 10] === '' ? 40 * i + 12 : 0 },
      {
        shipId: `ship-${String(i)}`,
        name: i === 3 ? '<b>Aurora</b> & sons' : `Lander ${String(i + 1)}`,
        own: i === 0,
        shownState: shown[i % 10]!,
        provenance: marks[i % 5]!,
      },
    ),
  );
  return { ...makeView(), ships, own: ships[0] ?? null };
}
