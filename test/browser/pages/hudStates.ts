/** The states a HUD can be in, each as the views that lead there. */
import type { ShipView, WorldView } from '../../../src/prediction';
import { later, makeShip, makeView, type Pose } from '../../readout/views';

export type StateName =
  | 'noData'
  | 'flight'
  | 'contact'
  | 'toppling'
  | 'landed'
  | 'tipped'
  | 'stuck'
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
  landed: () => touchdown(REST, {}),
  tipped: () => touchdown(ON_SIDE, {}),
  stuck: () => [makeView({ ...ON_SIDE, body: 'Earth', leanTo: 160 })],
  crashed: () => [makeView({ clearance: -1, up: -63, east: 5 }, { crashed: true, shownState: 'crashed' })],
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

/** Long enough for the runs ahead to have their answers. */
function frames(view: WorldView & { own: ShipView }, count: number): WorldView[] {
  return Array.from({ length: count }, (_, i) => later(view, i / 1000, view.own));
}

/** Falls, touches at 12.3 m/s, bounces once, slides and comes to the rest given. */
function touchdown(rest: Pose, changes: Partial<ShipView>): WorldView[] {
  const falling = makeView({ clearance: 0.1, east: 2.6, north: 4.1, up: -12.3, tilt: 3, leanTo: 20 });
  const touch = makeShip({ ...SLIDE, north: 4.1, east: 2.6, tilt: 6 }, { impactSpeed: 12.3 });
  const hop = makeShip({ clearance: 2, north: 3.6, east: 2.3, up: 3.4, tilt: 6 });
  const again = makeShip({ ...SLIDE, north: 3.6, east: 2.3, tilt: 9 }, { impactSpeed: 3.4 });
  const still = makeShip(rest, changes);
  const path: [number, ShipView][] = [
    [0.02, touch],
    [0.6, hop],
    [3.8, again],
    [0.9, again],
    [0.9, again],
    [2.2, still],
  ];
  const views: WorldView[] = [falling];
  for (const [seconds, ship] of path) views.push(later(views.at(-1)!, seconds, ship));
  return [...views, ...frames(later(views.at(-1)!, 0.1, still), 40)];
}

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
