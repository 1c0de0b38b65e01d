/** Paints the HUD states that a test asks for; nothing here runs by itself. */
import { createCockpitLandingHud, createFleetHud } from '../../../src/hud';
import { createFleetReadout, createLandingReadout, fleetReadout, landingReadout } from '../../../src/readout';
import { makeFleet, STATES, type StateName } from './hudStates';

const KEYS: Readonly<Record<string, string>> = {
  pitchPlus: 'S',
  pitchMinus: 'W',
  yawPlus: 'D',
  yawMinus: 'A',
  translateYPlus: 'I',
};

const landing = createCockpitLandingHud(document, document.querySelector('#landing')!, {
  keyLabel: (action) => KEYS[action] ?? '',
});
const fleet = createFleetHud(document, document.querySelector('#fleet')!);

function show(name: StateName): void {
  const readout = createLandingReadout();
  for (const view of STATES[name]()) landing.paint(landingReadout(view, readout));
}

function showFleet(size: number): void {
  fleet.paint(fleetReadout(makeFleet(size), createFleetReadout()));
}

/** ms a frame that the script of both HUDs takes, over `frames` frames of a ship that slides and turns. */
function time(frames: number): number {
  const readout = createLandingReadout();
  const fleetNow = createFleetReadout();
  const views = STATES.sliding();
  const ships = makeFleet(1000);
  const began = performance.now();
  for (let i = 0; i < frames; i++) {
    landing.paint(landingReadout(views[i % views.length]!, readout));
    fleet.paint(fleetReadout(ships, fleetNow));
  }
  return (performance.now() - began) / frames;
}

Object.assign(window, { hud: { show, showFleet, time, landing, fleet } });
document.documentElement.dataset['ready'] = 'true';
