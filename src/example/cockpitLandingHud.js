import { createLandingReadout, updateLandingReadout } from 'galaxy-touchdown';
import { createCockpitLandingHud } from 'galaxy-touchdown/hud';
import { keyLabel } from './controls.js';

/** The landing HUD in `host`; call what it returns with each frame's view. */
export function createLandingHud(host) {
  const readout = createLandingReadout();
  const hud = createCockpitLandingHud(document, host, { keyLabel });
  return (view) => hud.paint(updateLandingReadout(readout, view));
}
