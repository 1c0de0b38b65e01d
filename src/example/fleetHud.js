import { createFleetReadout, updateFleetReadout } from 'galaxy-touchdown';
import { createFleetHud } from 'galaxy-touchdown/hud';

/** The fleet HUD in `host`; call what it returns with each frame's view. */
export function createFleet(host) {
  const readout = createFleetReadout();
  const hud = createFleetHud(document, host);
  return (view) => hud.paint(updateFleetReadout(readout, view));
}
