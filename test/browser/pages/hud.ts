/** Paints HUD states on a test's request. */
import { createCockpitLandingHud, createFleetHud } from '../../../src/hud';
import {
  createFleetReadout,
  createLandingReadout,
  updateFleetReadout,
  updateLandingReadout,
} from '../../../src/readout';
import type { WorldView } from '../../../src/prediction';
import { KEYS, makeFleet, STATES, type StateName } from './hudStates';

const landing = createCockpitLandingHud(document, document.querySelector('#landing')!, {
  theme: 'system',
  keyLabel: (action) => KEYS[action] ?? '',
});
const fleet = createFleetHud(document, document.querySelector('#fleet')!, { theme: 'system' });

let readout = createLandingReadout();
let view: WorldView | undefined;

/** Plays the views that lead to a state, each as one frame. */
function show(name: StateName): void {
  readout = createLandingReadout();
  for (view of STATES[name]()) landing.paint(updateLandingReadout(readout, view));
}

/** Paints the last view again, like a page on which nothing changes. */
function again(times: number): void {
  if (view === undefined) return;
  for (let i = 0; i < times; i++) landing.paint(updateLandingReadout(readout, view));
}

function showFleet(size: number): void {
  fleet.paint(updateFleetReadout(createFleetReadout(), makeFleet(size)));
}

/** Subjects of the benchmark: `frames` frames of a ship that slides and turns, and of 1,000 ships of which some change. */
const subjects = (): Record<string, (frames: number) => void> => {
  const views = STATES.sliding();
  const readouts = views.map((each) => updateLandingReadout(createLandingReadout(), each));
  const moving = createLandingReadout();
  const ships = makeFleet(1000);
  const fleetNow = createFleetReadout();
  let frame = 0;
  /** A tenth of them climbs, and one at the top of the list changes between tipped and landed, which moves the rows below. */
  const change = (): void => {
    frame++;
    for (let i = frame % 10; i < 1000; i += 10) ships.ships[i]!.feetHeight += 0.35;
    const first = ships.ships[8]!;
    first.shownState = first.shownState === 'tipped' ? 'landed' : 'tipped';
  };
  const each = (paint: (i: number) => void) => (frames: number) => {
    for (let i = 0; i < frames; i++) paint(i);
  };
  return {
    'hud-read': each((i) => updateLandingReadout(moving, views[i % views.length]!)),
    'hud-paint': each((i) => landing.paint(readouts[i % readouts.length]!)),
    'hud-paint-same': each(() => landing.paint(moving)),
    'fleet-read-1000': each(() => {
      change();
      updateFleetReadout(fleetNow, ships);
    }),
    'fleet-paint-1000': each(() => {
      change();
      fleet.paint(updateFleetReadout(fleetNow, ships));
    }),
    'hud-paint-laid-out': each((i) => {
      landing.paint(readouts[i % readouts.length]!);
      document.body.getBoundingClientRect();
    }),
    'fleet-paint-1000-laid-out': each(() => {
      change();
      fleet.paint(updateFleetReadout(fleetNow, ships));
      document.body.getBoundingClientRect();
    }),
  };
};

/** ms per frame, by subject: `rounds` rounds each, after warm-up. */
function time(rounds: number): Record<string, number[]> {
  const took: Record<string, number[]> = {};
  for (const [name, run] of Object.entries(subjects())) {
    run(1500);
    took[name] = Array.from({ length: rounds }, () => {
      const began = performance.now();
      run(FRAMES_A_ROUND);
      return (performance.now() - began) / FRAMES_A_ROUND;
    });
  }
  return took;
}

/** The browser's clock has a resolution of 0.1 ms. */
const FRAMES_A_ROUND = 2000;

/** Gives an action another key, as a player does while the game runs. */
function rebind(action: string, label: string): void {
  KEYS[action] = label;
}

Object.assign(window, { hud: { show, showFleet, again, time, rebind, landing, fleet } });
document.documentElement.dataset['ready'] = 'true';
