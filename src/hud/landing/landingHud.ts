import type { LandingReadout } from '../../readout';
import { createAnnouncer } from '../announcer';
import { createFrame, type HudAppearance } from '../appearance';
import { checked, requireHost } from '../checks';
import { createCrossPointer } from './crossPointer';
import { createDescentPanel } from './descentPanel';
import { append } from '../elements';
import type { Hud } from '../hud';
import { createGatesPanel } from './gatesPanel';
import { createRightingPanel, type KeyLabel, type TurnKeys } from './rightingPanel';
import { scrollWhereShort } from '../scrolling';
import { showPart } from '../shown';
import { createStatusSlot } from './statusSlot';
import { createTiltPanel } from './tiltPanel';
import { createTouchdownCard } from './touchdownCard';

/** Options of the landing HUD. */
export interface LandingHudOptions extends HudAppearance {
  /** Names the keys in the righting help; without it the help names only the axes. */
  readonly keyLabel?: KeyLabel;
  /** The controls that turn the ship now, where there is not one for each axis. */
  readonly turnKeys?: TurnKeys;
}

/**
 * Creates the cockpit's landing HUD and appends it to `host`, which may be a shadow root (HUD, The landing HUD).
 * Its style sheet is hud.css: link it where the host is, in the shadow root if it is one. Nothing here needs more of a content
 * security policy than `default-src 'self'`.
 *
 * @example
 * ```ts
 * const hud = createCockpitLandingHud(document, host, { theme: 'dark', layout: 'compact' });
 * const readout = createLandingReadout();
 * hud.paint(updateLandingReadout(readout, predictor.view(now))); // each display frame
 * ```
 */
export function createCockpitLandingHud(
  document: Document,
  host: Element | ShadowRoot,
  options: LandingHudOptions = {},
): Hud<LandingReadout> {
  requireHost(document, host, options);
  const { root, panel, dispose } = createFrame(document, 'landing', 'Landing', options);
  const paintStatus = createStatusSlot(panel);
  const paintTilt = createTiltPanel(panel);
  const parts = append(panel, 'div', 'td-parts');
  const instruments = append(parts, 'div', 'td-instruments');
  const paintDrift = createCrossPointer(instruments);
  const paintDescent = createDescentPanel(instruments);
  const landed = append(parts, 'p', 'td-landed', 'Landed');
  const paintLanded = showPart(landed);
  const paintGates = createGatesPanel(parts);
  const paintRighting = createRightingPanel(parts, options.keyLabel ?? (() => ''), options.turnKeys);
  const paintCard = createTouchdownCard(parts);
  const announce = createAnnouncer(panel);
  host.append(root);
  const unwatch = scrollWhereShort(parts, 'Landing details');
  const hud = {
    ...({ root, members: ['status', 'descent', 'touchdown'], madeBy: 'updateLandingReadout' } as const),
    paint: (readout: LandingReadout) => {
      paintStatus(readout);
      paintTilt(readout);
      paintDrift(readout.drift, readout.tilt);
      paintDescent(readout.descent);
      paintLanded(readout.status === 'landed');
      paintGates(readout.gates);
      paintRighting(readout.righting);
      paintCard(readout);
      announce(readout);
    },
    dispose: () => {
      unwatch();
      dispose();
    },
  };
  return checked(hud, options.onWarning);
}
