import type { Action, KeySettings } from './keyTable';
import { createGamepads } from './gamepad';
import { giveFocusBack, listenToKeys } from './keyboard';
import { createLayout, type Layout } from './layout';
import type { Stick } from './stick';
import { createThumbs, type Thumbs } from './thumbs';
import type { Device } from '../game/words/flightWords';

export interface DevicesPlace {
  readonly settings: () => KeySettings;
  readonly stick: Stick;
  readonly pressed: (action: Action) => void;
  readonly released: (action: Action) => void;
  readonly confirmed: () => void;
  readonly letGo: () => void;
  readonly lever: (throttle: number) => void;
  /** A stick moved: its input is sampled at once. */
  readonly moved: () => void;
  /** The pilot took another device, or a key turned out to print something else. */
  readonly changed: () => void;
  readonly tell: (text: string) => void;
  /** The game is paused: sticks are ignored. */
  readonly isResting: () => boolean;
}

/** Keyboard, gamepad and thumb sticks, and which of them the pilot uses. */
export interface Devices {
  readonly device: () => Device;
  readonly layout: () => Layout;
  readonly thumbs: Thumbs;
  /** Called once per frame. */
  readonly read: () => void;
}

export function connectDevices(window: Window, place: DevicesPlace): Devices {
  const { document } = window;
  let device: Device = window.matchMedia('(pointer: coarse)').matches ? 'thumbs' : 'keys';
  const use = (next: Device) => {
    if (device === next) return;
    device = next;
    place.changed();
  };
  const layout = createLayout(window.navigator, place.changed);
  const pressed = (from: Device) => (action: Action) => {
    use(from);
    place.pressed(action);
  };
  listenToKeys(window, place.settings, layout, {
    pressed: pressed('keys'),
    released: place.released,
    confirmed: place.confirmed,
    letGo: place.letGo,
  });
  const readGamepad = createGamepads(window.navigator, () => place.stick.deflection, {
    pressed: pressed('gamepad'),
    confirmed: place.confirmed,
    changed(name) {
      use(name === null ? 'keys' : 'gamepad');
      place.tell(name === null ? 'Gamepad disconnected.' : `Gamepad: ${name.slice(0, 40)}`);
    },
  });
  const thumbs = createThumbs(document.getElementById('pads')!, {
    deflection: () => place.stick.deflection,
    moved() {
      use('thumbs');
      place.moved();
    },
    lever(throttle) {
      use('thumbs');
      place.lever(throttle);
    },
    pressed: pressed('thumbs'),
  });
  giveFocusBack(document.getElementById('panel')!, document.getElementById('stage')!);
  return {
    device: () => device,
    layout: layout.layout,
    thumbs,
    read() {
      if (!place.isResting() && readGamepad()) {
        use('gamepad');
        place.moved();
      }
    },
  };
}
