import type { LandingReadout } from '../readout';
import { createAnnouncer } from './announcer';
import { createCrossPointer } from './crossPointer';
import { createDescentPanel } from './descentPanel';
import { append } from './elements';
import { createGatesPanel } from './gatesPanel';
import { createRightingPanel, type KeyLabel, type TurnKeys } from './rightingPanel';
import { scrollWhereShort } from './scrolling';
import { showPart } from './shown';
import { createStatusSlot } from './statusSlot';
import { createTiltPanel } from './tiltPanel';
import { createTouchdownCard } from './touchdownCard';

/** Paints one readout after the other; holds DOM until disposed. */
export interface Hud<Readout> {
  /** Touches the DOM only where what is shown changed. */
  readonly paint: (readout: Readout) => void;
  /** Takes everything out of the host again. */
  readonly dispose: () => void;
}

export interface LandingHudOptions {
  /** Names the keys in the righting help; without it the help names the axes alone. */
  readonly keyLabel?: KeyLabel;
  /** Which controls turn the ship now, where they are not one for each axis. */
  readonly turnKeys?: TurnKeys;
}

/**
 * The cockpit's landing HUD, appended to `host` (HUD, the design and beyond it). Its style sheets come with index.ts;
 * no content security policy stands in its way.
 */
export function createCockpitLandingHud(
  document: Document,
  host: Element,
  options: LandingHudOptions = {},
): Hud<LandingReadout> {
  const root = document.createElement('section');
  root.className = 'hud hud-landing';
  root.setAttribute('aria-label', 'Landing');
  const paintStatus = createStatusSlot(root);
  const paintTilt = createTiltPanel(root);
  const parts = append(root, 'div', 'hud-parts');
  const instruments = append(parts, 'div', 'hud-instruments');
  const paintDrift = createCrossPointer(instruments);
  const paintDescent = createDescentPanel(instruments);
  const landed = append(parts, 'p', 'hud-landed', 'Landed');
  const paintLanded = showPart(landed);
  const paintGates = createGatesPanel(parts);
  const paintRighting = createRightingPanel(parts, options.keyLabel ?? (() => ''), options.turnKeys);
  const paintCard = createTouchdownCard(parts);
  const announce = createAnnouncer(root);
  host.append(root);
  const unwatch = scrollWhereShort(parts, 'Landing, further down');
  return {
    paint: (readout) => {
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
      root.remove();
    },
  };
}
