/**
 * Bytes of heap that a readout allocates, for an unchanged view and for the next one. Run as a bundle with
 * --expose-gc (test/run.mjs) and a young generation that holds them all: the readouts as they are shipped. Prints bytes per call, one
 * number per case, as JSON.
 */
import type { World } from '../../src/dynamics';
import type { ShipView, WorldView } from '../../src/prediction';
import { addTrack, createFleet } from '../../src/prediction/simulation/track';
import { createShipView } from '../../src/prediction/drawn/shipView';
import {
  createFleetReadout,
  createLandingReadout,
  updateFleetReadout,
  updateLandingReadout,
} from '../../src/readout';
import { makeShip, makeView, NO_TOUCHDOWN, type Pose } from './views';

const SLIDE: Pose = {
  clearance: -0.3,
  east: 3.1,
  north: 5.2,
  up: 0.4,
  state: 'contact',
  tilt: 7.5,
  leanTo: 30,
};
const TOPPLE: Pose = { ...SLIDE, clearance: -0.016, east: 0.3, up: 0, tilt: 41, tiltRate: 0.05 };
const CARD = { ...NO_TOUCHDOWN, known: true, verticalSpeed: 12.3, slideMetres: 15.2, largestTilt: 0.2 };

const POSES: Readonly<Record<string, readonly [Pose, Partial<ShipView>?]>> = {
  flight: [{ clearance: 86, east: 3.2, north: 6.4, up: -12.3, tilt: 4 }],
  contact: [SLIDE],
  toppling: [TOPPLE],
  landed: [{ clearance: -0.016, state: 'landed', tilt: 1.2 }, { touchdown: { ...CARD, outcome: 'landed' } }],
  tipped: [{ clearance: -0.016, state: 'tipped', tilt: 89.6 }, { touchdown: { ...CARD, outcome: 'tipped' } }],
  stuck: [{ clearance: -0.016, state: 'tipped', tilt: 89.6, body: 'Earth' }],
  stale: [SLIDE, { provenance: 'stale' }],
};

declare const gc: () => void;

interface Case {
  readonly call: () => void;
  readonly calls: number;
}

/** Bytes per call: the minimum of four rounds, since the engine's compilers allocate too. */
function bytesOf({ call, calls }: Case): number {
  let least = Infinity;
  for (let round = 0; round < 4; round++) {
    gc();
    const before = process.memoryUsage().heapUsed;
    run(call, calls);
    least = Math.min(least, process.memoryUsage().heapUsed - before);
  }
  return least / calls;
}

function run(call: () => void, calls: number): void {
  for (let i = 0; i < calls; i++) call();
}

const world = makeView();

/**
 * Like the predictor's views: all ships have the same object layout, settings and bodies. With many layouts, the
 * measurement would show those.
 */
function viewOf(pose: Pose, changes: Partial<ShipView> = {}): WorldView & { own: ShipView } {
  const own = asViewed(makeView(pose, changes).own);
  return { ...world, ships: [own], own };
}

function asViewed(ship: ShipView): ShipView {
  const track = addTrack(createFleet(), ship.shipId, 12);
  const view = createShipView(track, { shipClasses: [world.own.shipClass] } as unknown as World);
  for (const [name, value] of Object.entries(ship))
    if (name !== 'shipClass') (view as unknown as Record<string, unknown>)[name] = value;
  return view;
}

/** The view a little later at each call: everything a frame changes. */
function going(view: WorldView & { own: ShipView }): () => void {
  let frame = 0;
  return () => {
    frame++;
    const wave = (frame % 64) / 64;
    view.sinceTick = wave;
    view.tick = 100 + Math.floor(frame / 64);
    view.own.velocity[0]! += wave < 0.5 ? 1e-3 : -1e-3;
    view.own.position[0]! += wave < 0.5 ? 1e-3 : -1e-3;
    view.own.angularVelocity[1]! += wave < 0.5 ? 1e-7 : -1e-7;
    view.own.age = 0.4 + wave;
  };
}

const cases: Record<string, Case> = {};
for (const [name, [pose, changes]] of Object.entries(POSES)) {
  const readout = createLandingReadout();
  const view = viewOf(pose, changes);
  cases[`${name}, the same view`] = { call: () => updateLandingReadout(readout, view), calls: 20_000 };
  const go = going(view);
  const moving = createLandingReadout();
  const call = (): void => {
    go();
    updateLandingReadout(moving, view);
  };
  cases[`${name}, frame after frame`] = { call, calls: name === 'toppling' ? 1000 : 20_000 };
}

const SHOWN = ['', 'landed', 'tipped'] as const;
const ships = Array.from({ length: 1000 }, (_, i) =>
  asViewed(makeShip({ clearance: 12.5 * i }, { shipId: `ship-${String(i)}`, shownState: SHOWN[i % 3]! })),
);
const fleet = { ...world, ships };
const fleetOut = createFleetReadout();
cases['fleet of 1000'] = { call: () => updateFleetReadout(fleetOut, fleet), calls: 500 };
let swapped = 0;
const change = (): void => {
  const ship = ships[swapped++ % 1000]!;
  ship.shownState = ship.shownState === 'landed' ? 'contact' : 'landed';
  ship.feetHeight += 0.25;
  updateFleetReadout(fleetOut, fleet);
};
cases['fleet of 1000, one ship changes'] = { call: change, calls: 500 };

// Runs all before measuring any: everything is compiled, for every kind of view, and the runs ahead of the law are done.
for (let pass = 0; pass < 3; pass++) for (const { call, calls } of Object.values(cases)) run(call, calls);
const bytes = Object.fromEntries(Object.entries(cases).map(([name, one]) => [name, bytesOf(one)]));
console.log(JSON.stringify(bytes, null, 1));
