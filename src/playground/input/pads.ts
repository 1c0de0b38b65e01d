import { append } from '../panels/elements';
import type { Action } from './keyTable';

const PADS: readonly (readonly [Action, string, string])[] = [
  ['pitchMinus', '⤒', 'Pitch forward'],
  ['pitchPlus', '⤓', 'Pitch back'],
  ['yawPlus', '⇤', 'Yaw left'],
  ['yawMinus', '⇥', 'Yaw right'],
  ['rollMinus', '↺', 'Roll left'],
  ['rollPlus', '↻', 'Roll right'],
  ['rateDamping', '◎', 'Rate damping'],
  ['throttleCut', '✕', 'Cut the engine'],
  ['throttleUp', '▲', 'Throttle up'],
  ['throttleDown', '▼', 'Throttle down'],
];

/** Pads for fingers; they hold while touched. Shown on small screens and where fingers are the pointer. */
export function createPads(
  host: Element,
  pressed: (action: Action) => void,
  released: (action: Action) => void,
): void {
  for (const [action, sign, about] of PADS) {
    const pad = append(host, 'button', '', sign);
    pad.type = 'button';
    pad.setAttribute('aria-label', about);
    pad.addEventListener('pointerdown', (event) => {
      pad.setPointerCapture(event.pointerId);
      pressed(action);
    });
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'] as const)
      pad.addEventListener(end, () => released(action));
    // Enter and space hold a pad too: a keyboard reaches everything.
    pad.addEventListener('keydown', (event) => {
      if ((event.key === 'Enter' || event.key === ' ') && !event.repeat) pressed(action);
    });
    pad.addEventListener('keyup', (event) => {
      if (event.key === 'Enter' || event.key === ' ') released(action);
    });
    pad.addEventListener('blur', () => released(action));
  }
}
