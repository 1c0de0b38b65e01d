import { append, appendButton } from '../panels/elements';
import type { Action } from './keyTable';
import type { Deflection } from './stick';

export interface ThumbListeners {
  readonly deflection: () => Deflection;
  /** A thumb touched, moved or was lifted. */
  readonly moved: () => void;
  readonly lever: (throttle: number) => void;
  readonly pressed: (action: Action) => void;
}

export interface Thumbs {
  /** Throttle, 0 … 1, and the one that hovers, 0 … 1 or NaN. */
  readonly show: (throttle: number, hover: number) => void;
  /** Marks a mode's button as on or off. */
  readonly mark: (mode: ThumbMode, isOn: boolean) => void;
}

export type ThumbMode = 'rateDamping' | 'modeUpright' | 'autopilot';

// The lever's position is the square root of the throttle: a ship hovers at a tenth, where a finger's width must not change it by a third.

/** CSS px from a stick's middle to its full deflection. */
const REACH = 44;
const STEPS = 10;

const BUTTONS: readonly (readonly [Action, string])[] = [
  ['throttleCut', 'Cut'],
  ['rateDamping', 'Damping'],
  ['modeUpright', 'Upright'],
  ['autopilot', 'Auto'],
];

/** Three thumb sticks and a lever, with labels; shown on touch screens. The lever and the buttons are native controls. */
export function createThumbs(host: HTMLElement, listeners: ThumbListeners): Thumbs {
  const { deflection, moved } = listeners;
  createStickPad(host, 'Tilt', (right, away) => {
    Object.assign(deflection(), { tiltRight: right, tiltAway: away });
    moved();
  });
  const middle = append(host, 'div', 'thumb-middle');
  const label = append(middle, 'label', 'thumb-lever');
  const words = append(label, 'span', '', 'Engine');
  const lever = append(label, 'input');
  lever.type = 'range';
  lever.min = '0';
  lever.max = '100';
  lever.step = '0.5';
  lever.addEventListener('input', () => listeners.lever((lever.valueAsNumber / 100) ** 2));
  const buttons = append(middle, 'div', 'thumb-buttons');
  const marks = new Map<Action, HTMLElement>();
  for (const [action, text] of BUTTONS)
    marks.set(
      action,
      appendButton(buttons, text, () => listeners.pressed(action)),
    );
  const column = append(host, 'div', 'thumb-column');
  createStickPad(column, 'Lift', (_, up) => {
    deflection().pushUp = up;
    moved();
  });
  createStickPad(column, 'Push', (right, away) => {
    Object.assign(deflection(), { pushRight: right, pushAway: away });
    moved();
  });
  let shownThrottle = NaN;
  let shownHover = NaN;
  return {
    mark(mode, isOn) {
      const button = marks.get(mode)!;
      if (button.getAttribute('aria-pressed') !== String(isOn))
        button.setAttribute('aria-pressed', String(isOn));
    },
    show(throttle, hover) {
      const percent = Math.round(throttle * 100);
      const hoverPercent = Math.round(hover * 100);
      if (percent === shownThrottle && Object.is(hoverPercent, shownHover)) return;
      shownThrottle = percent;
      shownHover = hoverPercent;
      const text = `Engine ${percent} %${Number.isNaN(hover) ? '' : `, hover ${hoverPercent} %`}`;
      words.textContent = text;
      lever.setAttribute('aria-valuetext', text);
      const place = Math.sqrt(throttle) * 100;
      if (host.ownerDocument.activeElement !== lever || Math.abs(lever.valueAsNumber - place) > 1)
        lever.value = String(place);
    },
  };
}

/** A round pad: the thumb's offset from where it came down, in steps. It is for fingers only; keys and gamepads do the same. */
function createStickPad(host: HTMLElement, text: string, tell: (right: number, away: number) => void): void {
  const pad = append(host, 'div', 'thumb');
  pad.setAttribute('aria-hidden', 'true');
  const knob = append(pad, 'span', 'knob', text);
  let finger = -1;
  let from = { x: 0, y: 0 };
  let told = '0 0';
  const move = (x: number, y: number) => {
    const size = Math.max(1, Math.hypot(x, y) / REACH);
    const [right, away] = [x / REACH / size, -y / REACH / size].map((v) => Math.round(v * STEPS) / STEPS + 0);
    knob.style.translate = `${x / size}px ${y / size}px`;
    const next = `${right!} ${away!}`;
    if (next === told) return;
    told = next;
    tell(right!, away!);
  };
  pad.addEventListener('pointerdown', (event) => {
    if (finger >= 0) return;
    finger = event.pointerId;
    from = { x: event.clientX, y: event.clientY };
    pad.setPointerCapture(finger);
    event.preventDefault();
  });
  pad.addEventListener('pointermove', (event) => {
    if (event.pointerId === finger) move(event.clientX - from.x, event.clientY - from.y);
  });
  for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'] as const)
    pad.addEventListener(end, (event) => {
      if (event.pointerId !== finger) return;
      finger = -1;
      move(0, 0);
    });
}
