import type { TurnKeys } from '../../../hud';
import { ROTATION_ACTIONS, type TranslationAction } from '../../../readout';
import type { Action, KeyMap } from '../../input/keyTable';
import { capOf, type Layout } from '../../input/layout';
import { pushKeyFor, turnKeysFor } from '../../input/steering';
import { type Cockpit, createCockpit } from '../../view/cockpit';
import { controlName, type Device } from './flightTexts';
import type { Page } from '../pageParts';
import type { Parts } from '../parts';

/** The character on the key of an action, on this keyboard; '' if keys are off. */
export function keyCapOf(page: Page, parts: Parts): (action: Action) => string {
  const caps = new Map<Action, string>();
  let map: KeyMap | null = null;
  let layout: Layout | null = null;
  return (action) => {
    if (!page.keys.enabled) return '';
    const current = parts.devices.layout();
    // Cached: the displays look up every key in every frame, and a look-up searches the whole table.
    if (map !== page.keys.map || layout !== current) caps.clear();
    map = page.keys.map;
    layout = current;
    const cap = caps.get(action) ?? capOf(action, map, layout);
    caps.set(action, cap);
    return cap;
  };
}

const TURN_WORDS = {
  pitchPlus: 'tilt towards you',
  pitchMinus: 'tilt away',
  yawPlus: 'tilt left',
  yawMinus: 'tilt right',
  rollPlus: 'turn left',
  rollMinus: 'turn right',
} as const;

const SHIP_AXES = Float64Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);

/** The names of the pilot's device: keys as printed, gamepad, or thumb sticks. */
export function wireCockpit(page: Page, parts: Parts): Cockpit {
  const { stick, autopilot } = parts.live.flightControls;
  const screen = new Float64Array(9);
  const seen = () => page.sceneView?.screenAxes(screen) === true;
  parts.live.flightControls.steerInScreenAxes(() => (seen() ? screen : null));
  autopilot.landAt(() => parts.game.tracker.pads().find(({ isNext }) => isNext)?.place ?? null);
  const cap = keyCapOf(page, parts);
  const name = (action: Action) => controlName(parts.devices.device(), action, cap);
  const turnKeys: TurnKeys = (actions) => {
    let [x, y] = [0, 0];
    for (const action of actions) {
      if (action === ROTATION_ACTIONS[0]![0]) x = 1;
      if (action === ROTATION_ACTIONS[0]![1]) x = -1;
      if (action === ROTATION_ACTIONS[1]![0]) y = 1;
      if (action === ROTATION_ACTIONS[1]![1]) y = -1;
    }
    return turnKeysFor(stick.steering, x, y).map((key) => ({ cap: name(key), words: TURN_WORDS[key] }));
  };
  return createCockpit(page.document, {
    host: page.part('hud'),
    flightHost: page.part('flight'),
    keyLabel: (action) =>
      name(action.startsWith('translate') ? pushKeyFor(stick.steering, action as TranslationAction) : action),
    turnKeys,
    modeLabel: (key) => modeLabelOf(parts.devices.device(), key, cap),
    target: () => parts.game.tracker.target(),
    screen: () => (seen() ? screen : SHIP_AXES),
    isAutopilotOn: autopilot.isOn,
  });
}

/** The D-pad's directions, which are too long in words for a list. */
const ARROWS: Partial<Record<Action, string>> = {
  modeUpright: '↑',
  modeRetrograde: '←',
  modeHold: '→',
  killRates: '↓',
};

/** The key of a mode, in short; on a touch screen the button has its name. */
export function modeLabelOf(device: Device, action: Action, cap: (action: Action) => string): string {
  if (device === 'thumbs') return '';
  return (device === 'gamepad' ? ARROWS[action] : undefined) ?? controlName(device, action, cap);
}
