import type { Action, KeySettings } from './keyTable';
import { createGamepads, padName } from './gamepad';
import { restoreFocus, listenToKeys } from './keyboard';
import { createLayout, type Layout } from './layout';
import type { Stick } from './stick';
import { createThumbs, type Thumbs } from './thumbs';
import type { Device } from '../game/texts/flightTexts';

export interface DeviceListeners {
  readonly settings: () => KeySettings;
  readonly stick: Stick;
  readonly pressed: (action: Action) => void;
  readonly released: (action: Action) => void;
  readonly confirmed: () => void;
  readonly releaseAll: () => void;
  readonly lever: (throttle: number) => void;
  /** A stick moved: its input is sampled at once. */
  readonly moved: () => void;
  /** The pilot took another device, or a key turned out to print something else. */
  readonly changed: () => void;
  readonly notify: (text: string) => void;
  /** The game is paused: sticks are ignored. */
  readonly isPaused: () => boolean;
}

/** Keyboard, gamepad and thumb sticks, and which of them the pilot uses. */
export interface Devices {
  readonly device: () => Device;
  readonly layout: () => Layout;
  readonly thumbs: Thumbs;
  /** Called once per frame. */
  readonly read: () => void;
}

export function connectDevices(window: Window, listeners: DeviceListeners): Devices {
  const { document } = window;
  let device: Device = window.matchMedia('(pointer: coarse)').matches ? 'thumbs' : 'keys';
  const use = (next: Device) => {
    if (device === next) return;
    device = next;
    listeners.changed();
  };
  const layout = createLayout(window.navigator, listeners.changed);
  const pressed = (from: Device) => (action: Action) => {
    use(from);
    listeners.pressed(action);
  };
  listenToKeys(window, listeners.settings, layout, {
    pressed: pressed('keys'),
    released: listeners.released,
    confirmed: listeners.confirmed,
    releaseAll: listeners.releaseAll,
  });
  const readGamepad = createGamepads(window, () => listeners.stick.deflection, {
    pressed: pressed('gamepad'),
    confirmed: listeners.confirmed,
    changed(name) {
      use(name === null ? 'keys' : 'gamepad');
      listeners.notify(name === null ? 'Gamepad disconnected.' : `Gamepad: ${padName(name)}`);
    },
  });
  const thumbs = createThumbs(document.getElementById('pads')!, {
    deflection: () => listeners.stick.deflection,
    moved() {
      use('thumbs');
      listeners.moved();
    },
    lever(throttle) {
      use('thumbs');
      listeners.lever(throttle);
    },
    pressed: pressed('thumbs'),
  });
  restoreFocus(document.getElementById('panel')!, document.getElementById('scene-view')!);
  return {
    device: () => device,
    layout: layout.layout,
    thumbs,
    read() {
      if (!listeners.isPaused() && readGamepad()) {
        use('gamepad');
        listeners.moved();
      }
    },
  };
}
