/** Paints the HUD states that a test asks for; nothing here runs by itself. */
import { createCockpitLandingHud, createFleetHud } from '../../../src/hud';
import { createFleetReadout, createLandingReadout, fleetReadout, landingReadout } from '../../../src/readout';
import type { WorldView } from '../../../src/prediction';
import { makeFleet, STATES, type StateName } from './hudStates';

const KEYS: Record<string, string> = {
  pitchPlus: 'S',
  pitchMinus: 'W',
  yawPlus: 'D',
  yawMinus: 'A',
  translateYPlus: 'I',
  rateDamping: 'T',
};

const landing = createCockpitLandingHud(document, document.querySelector('#landing')!, {
  keyLabel: (action) => KEYS[action] ?? '',
});
const fleet = createFleetHud(document, document.querySelector('#fleet')!);

let readout = createLandingReadout();
let view: WorldView | undefined;

/** Flies the way to a state, each view as one frame. */
function show(name: StateName): void {
  readout = createLandingReadout();
  for (view of STATES[name]()) landing.paint(landingReadout(view, readout));
}

/** Paints the last view again, as a page does while nothing happens. */
function again(times: number): void {
  if (view === undefined) return;
  for (let i = 0; i < times; i++) landing.paint(landingReadout(view, readout));
}

function showFleet(size: number): void {
  fleet.paint(fleetReadout(makeFleet(size), createFleetReadout()));
}

/** ms a frame of script, landing and fleet apart, of a ship that slides and turns beside `ships` others. */
function time(frames: number, ships: number): { landing: number; paint: number; fleet: number } {
  const moving = createLandingReadout();
  const fleetNow = createFleetReadout();
  const views = STATES.sliding();
  const others = makeFleet(ships);
  const took = { landing: 0, paint: 0, fleet: 0 };
  for (let i = 0; i < frames; i++) {
    const began = performance.now();
    landingReadout(views[i % views.length]!, moving);
    const read = performance.now();
    landing.paint(moving);
    const painted = performance.now();
    fleet.paint(fleetReadout(others, fleetNow));
    took.landing += read - began;
    took.paint += painted - read;
    took.fleet += performance.now() - painted;
  }
  return { landing: took.landing / frames, paint: took.paint / frames, fleet: took.fleet / frames };
}

/** Gives an action another key, as a player does while the game runs. */
function rebind(action: string, label: string): void {
  KEYS[action] = label;
}

Object.assign(window, { hud: { show, showFleet, again, time, rebind, landing, fleet } });
document.documentElement.dataset['ready'] = 'true';
