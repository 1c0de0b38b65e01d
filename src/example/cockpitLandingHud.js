import { createLandingReadout, updateLandingReadout } from 'galaxy-touchdown';
import { createCockpitLandingHud } from 'galaxy-touchdown/hud';
import { keyLabel } from './controls.js';

/** Creates the landing HUD in `host`; call the returned function with each frame's view. */
export function createLandingHud(host) {
  const readout = createLandingReadout();
  const hud = createCockpitLandingHud(document, host, { keyLabel });
  return (view) => hud.paint(updateLandingReadout(readout, view));
}
