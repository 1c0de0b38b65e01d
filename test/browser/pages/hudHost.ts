/** Mounts the HUDs on a test's request: in the page or in a shadow root, at any width, with any appearance. */
import { createCockpitLandingHud, createFleetHud, type HudAppearance } from '../../../src/hud';
import {
  createFleetReadout,
  createLandingReadout,
  updateFleetReadout,
  updateLandingReadout,
} from '../../../src/readout';
import { KEYS, makeFleet, STATES, type StateName } from './hudStates';

const SHEET = new URL('../../../src/hud/styles/hud.css', import.meta.url).href;

const place = document.querySelector<HTMLElement>('#place')!;

/** An empty element at the position, `width` px wide. */
function clear(width: number): HTMLElement {
  const box = document.createElement('div');
  box.id = 'box';
  box.style.cssText = `all: revert; width: ${String(width)}px`;
  place.replaceChildren(box);
  return box;
}

/** A shadow root with the style sheet linked inside; resolves once it is there. */
async function shadowIn(box: HTMLElement): Promise<ShadowRoot> {
  const root = box.attachShadow({ mode: 'open' });
  const link = document.createElement('link');
  link.rel = 'stylesheet';
  link.href = SHEET;
  root.append(link);
  await new Promise((loaded) => (link.onload = loaded));
  return root;
}

/** Shows one HUD of the state in a box of that width. */
async function mount(
  name: StateName | 'fleet',
  width: number,
  shadow: boolean,
  look: HudAppearance,
): Promise<void> {
  const box = clear(width);
  const host = shadow ? await shadowIn(box) : box;
  if (name === 'fleet') {
    createFleetHud(document, host, look).paint(updateFleetReadout(createFleetReadout(), makeFleet(20)));
    return;
  }
  const landing = createCockpitLandingHud(document, host, {
    ...look,
    keyLabel: (action) => KEYS[action] ?? '',
  });
  const readout = createLandingReadout();
  for (const view of STATES[name]()) landing.paint(updateLandingReadout(readout, view));
}

Object.assign(window, { mount });
document.documentElement.dataset['ready'] = 'true';
