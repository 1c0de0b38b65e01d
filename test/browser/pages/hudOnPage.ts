/** Both HUDs at their places in the playground, with its style sheets, to check that they fit. */
import { createCockpitLandingHud, createFleetHud } from '../../../src/hud';
import {
  createFleetReadout,
  createLandingReadout,
  updateFleetReadout,
  updateLandingReadout,
} from '../../../src/readout';
import { makeFleet, STATES, type StateName } from './hudStates';

const place = document.querySelector('#hud')!;
const landing = createCockpitLandingHud(document, place, {
  theme: 'system',
  keyLabel: (action) =>
    ({ pitchMinus: 'W', yawMinus: 'A', yawPlus: 'D', rateDamping: 'T' })[action as 'yawPlus'],
});
const fleet = createFleetHud(document, place, { theme: 'system' });

/** Plays the views that lead to a state, each as one frame, beside a fleet of `size`. */
function show(name: StateName, size: number): void {
  const readout = createLandingReadout();
  for (const view of STATES[name]()) landing.paint(updateLandingReadout(readout, view));
  fleet.paint(updateFleetReadout(createFleetReadout(), makeFleet(size)));
}

Object.assign(window, { show });
document.documentElement.dataset['ready'] = 'true';
