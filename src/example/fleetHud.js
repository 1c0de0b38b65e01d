import { createFleetReadout, updateFleetReadout } from 'galaxy-touchdown';
import { createFleetHud } from 'galaxy-touchdown/hud';

/** Creates the fleet HUD in `host`; call the returned function with each frame's view. */
export function createFleet(host) {
  const readout = createFleetReadout();
  const hud = createFleetHud(document, host);
  return (view) => hud.paint(updateFleetReadout(readout, view));
}
